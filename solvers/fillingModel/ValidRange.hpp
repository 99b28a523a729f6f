// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/Laws.hpp"
#include "LinearFit.hpp"

#include <array>
#include <string>
#include <vector>

namespace interstice
{

/// A quantity whose range in the fitted points bounds where a fit may be used.
struct RangedQuantity
{
    const char* name;
    const char* unit;
    double (*value)(const DieFilling&);
};

/// The three groups, and the two lengths of the die, which the groups alone do not fix.
constexpr RangedQuantity rangedQuantities[]{
    {"d_p/h_D", "", sizeRatio},
    {"N_v", "", shoeReynolds},
    {"rho_p/rho_g", "", densityRatio},
    {"L_D", "m", [](const DieFilling& filling) { return filling.dieLength; }},
    {"h_D", "m", [](const DieFilling& filling) { return filling.dieDepth; }},
};
constexpr std::size_t rangedCount = sizeof(rangedQuantities) / sizeof(rangedQuantities[0]);

/// Smallest and largest of each ranged quantity.
using ValidRange = std::array<Interval, rangedCount>;

/// The range that these points span; there is at least one.
ValidRange rangeOf(const std::vector<DieFilling>& points);

/// Whether d_p/h_D is given to the model, so that its range counts, or is what the model answers.
enum class SizeIs
{
    given,
    answer
};

/// The quantities outside the range, one readable line each: by how much, in units and in per cent
/// of the width of the range. Empty if all are inside, to a millionth of the limit.
std::vector<std::string> outsideRange(
    const ValidRange& range, const DieFilling& filling, SizeIs size);

/// The error for such lines; names the option that allows it.
InputError extrapolationRefused(const std::vector<std::string>& outside, const std::string& where);

} // namespace interstice
