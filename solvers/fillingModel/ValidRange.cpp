// SPDX-License-Identifier: GPL-3.0-or-later
#include "ValidRange.hpp"

#include "Text.hpp"

#include <algorithm>
#include <cassert>

namespace interstice
{

namespace
{

std::string spaced(const char* unit)
{
    return *unit ? std::string(" ") + unit : "";
}

std::string outsideLine(const RangedQuantity& quantity, double value, const Interval& range)
{
    const bool above = value > range.high;
    const double beyond = above ? value - range.high : range.low - value;
    const double width = range.high - range.low;
    const std::string unit = spaced(quantity.unit);

    std::string line =
        formatted("%s %.6g%s, fitted for %.6g", quantity.name, value, unit.c_str(), range.low);
    line += width > 0 ? formatted(" to %.6g%s", range.high, unit.c_str()) : unit + " only";
    line += formatted(": %.3g%s %s", beyond, unit.c_str(), above ? "above" : "below");
    return line + (width > 0 ? formatted(", %.0f %% of the width", 100 * beyond / width) : "");
}

} // namespace

ValidRange rangeOf(const std::vector<DieFilling>& points)
{
    assert(!points.empty());
    ValidRange range;
    for (std::size_t i = 0; i < rangedCount; ++i)
    {
        const double first = rangedQuantities[i].value(points.front());
        range[i] = {first, first};
        for (const DieFilling& point : points)
        {
            const double value = rangedQuantities[i].value(point);
            range[i] = {std::min(range[i].low, value), std::max(range[i].high, value)};
        }
    }
    return range;
}

std::vector<std::string> outsideRange(
    const ValidRange& range, const DieFilling& filling, SizeIs size)
{
    constexpr double rounding = 1e-6;

    std::vector<std::string> lines;
    for (std::size_t i = size == SizeIs::given ? 0 : 1; i < rangedCount; ++i)
    {
        const double value = rangedQuantities[i].value(filling);
        if (value < range[i].low * (1 - rounding) || value > range[i].high * (1 + rounding))
        {
            lines.push_back(outsideLine(rangedQuantities[i], value, range[i]));
        }
    }
    return lines;
}

InputError extrapolationRefused(const std::vector<std::string>& outside, const std::string& where)
{
    std::string lines;
    for (const std::string& line : outside)
    {
        lines += (lines.empty() ? "" : "\n") + line;
    }
    return InputError({"The model would have to extrapolate.", lines,
        "groups, L_D and h_D within the range of the fit", where,
        "Add runs there and fit again, or give --extrapolate to see the number all the same."});
}

} // namespace interstice
