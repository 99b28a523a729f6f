// SPDX-License-Identifier: GPL-3.0-or-later
#include "CriticalSizeRatio.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace interstice
{

namespace
{

bool same(double a, double b)
{
    constexpr double roundOff = 1e-9;
    return std::abs(a - b) <= roundOff * std::max(std::abs(a), std::abs(b));
}

bool belongTogether(const DieFilling& a, const DieFilling& b)
{
    return same(shoeReynolds(a), shoeReynolds(b)) && same(densityRatio(a), densityRatio(b))
           && same(a.dieLength / a.dieDepth, b.dieLength / b.dieDepth);
}

bool finer(const Variant& a, const Variant& b)
{
    return sizeRatio(a.filling) < sizeRatio(b.filling);
}

// Zero stands for a number that is not told.
int fewestTold(int a, int b)
{
    return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}

void checkSizesDiffer(const Series& series, const std::string& file)
{
    for (std::size_t i = 1; i < series.variants.size(); ++i)
    {
        const Variant& a = series.variants[i - 1];
        const Variant& b = series.variants[i];
        if (same(sizeRatio(a.filling), sizeRatio(b.filling)))
        {
            throw InputError({"Two rows of the table are the same variant.",
                "lines " + std::to_string(std::min(a.line, b.line)) + " and "
                    + std::to_string(std::max(a.line, b.line)),
                "one row a variant", file,
                "Average the packings of a variant into one row; if another column tells the rows "
                "apart, keep those of one of its values."});
        }
    }
}

} // namespace

std::vector<Series> seriesOf(const ResultsTable& table)
{
    std::vector<Series> all;
    for (const Variant& variant : table.variants)
    {
        const auto home = std::find_if(all.begin(), all.end(),
            [&](const Series& series)
            { return belongTogether(series.variants.front().filling, variant.filling); });
        if (home == all.end())
        {
            all.push_back({{variant}});
        }
        else
        {
            home->variants.push_back(variant);
        }
    }

    for (Series& series : all)
    {
        std::sort(series.variants.begin(), series.variants.end(), finer);
        checkSizesDiffer(series, table.file);
    }
    std::sort(all.begin(), all.end(),
        [](const Series& a, const Series& b)
        {
            const DieFilling& first = a.variants.front().filling;
            const DieFilling& second = b.variants.front().filling;
            return std::make_tuple(densityRatio(first), shoeReynolds(first), first.dieLength)
                   < std::make_tuple(densityRatio(second), shoeReynolds(second), second.dieLength);
        });
    return all;
}

CriticalSizeRatio criticalSizeRatio(const Series& series, double threshold)
{
    const std::vector<Variant>& variants = series.variants;
    assert(!variants.empty());

    std::optional<std::size_t> lastBelow;
    int falls = 0;
    for (std::size_t i = 0; i < variants.size(); ++i)
    {
        if (variants[i].measure < threshold)
        {
            falls += i > 0 && variants[i - 1].measure >= threshold ? 1 : 0;
            lastBelow = i;
        }
    }

    const auto at = [&](Crossing crossing, double value, std::optional<double> error)
    {
        DieFilling filling = variants[lastBelow.value_or(0)].filling;
        filling.particleDiameter = value * filling.dieDepth;
        return CriticalSizeRatio{crossing, value, error, falls, filling, 0};
    };
    if (!lastBelow)
    {
        return at(Crossing::below, sizeRatio(variants.front().filling), std::nullopt);
    }
    if (*lastBelow + 1 == variants.size())
    {
        return at(Crossing::above, sizeRatio(variants.back().filling), std::nullopt);
    }

    const Variant& low = variants[*lastBelow];
    const Variant& high = variants[*lastBelow + 1];
    const double width = sizeRatio(high.filling) - sizeRatio(low.filling);
    const double rise = high.measure - low.measure;
    const double share = (threshold - low.measure) / rise;

    std::optional<double> error;
    if (low.error && high.error)
    {
        error = width / rise * std::hypot((1 - share) * *low.error, share * *high.error);
    }
    CriticalSizeRatio size = at(Crossing::within, sizeRatio(low.filling) + share * width, error);
    size.packings = fewestTold(low.packings, high.packings);
    return size;
}

} // namespace interstice
