// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ResultsTable.hpp"

#include <optional>
#include <vector>

namespace interstice
{

/// The variants that differ in d_p/h_D alone, by rising d_p/h_D.
///
/// They have v rho_g L_D/mu_g, rho_p/rho_g and L_D/h_D in common, to 1e-9.
struct Series
{
    std::vector<Variant> variants;
};

/// Sorts the rows of a table into series, by rising rho_p/rho_g, then v rho_g L_D/mu_g.
///
/// Throws InputError for two rows of one series with the same d_p/h_D: packings are to be averaged
/// before.
std::vector<Series> seriesOf(const ResultsTable& table);

/// Where the threshold lies relative to the sizes of a series.
enum class Crossing
{
    within, ///< Between two sizes.
    below, ///< Every size fills: the critical one is the finest or finer.
    above ///< The coarsest size does not fill: the critical one is coarser.
};

/// The smallest d_p/h_D from which on every coarser powder of a series fills the die.
struct CriticalSizeRatio
{
    Crossing crossing;
    double value; ///< (d_p/h_D)_crit; unless within, the size ratio that it is below or above.
    std::optional<double> error; ///< Standard error, where those of both neighbours are known.
    int falls; ///< How often the measure falls below the threshold with rising size; 0 is sound.
    DieFilling filling; ///< Of the series, with the particle diameter of `value`.
    int packings; ///< Fewest that an error of its neighbours is from; 0 where the table is silent.
};

/// Finds it by linear interpolation between the last size x_1 whose measure f_1 is below the
/// threshold t and the next, x_2, where f_2 >= t:
///
///     x      = x_1 + w (x_2 - x_1),                          w = (t - f_1)/(f_2 - f_1)
///     se(x)  = (x_2 - x_1)/(f_2 - f_1) sqrt((1 - w)^2 se(f_1)^2 + w^2 se(f_2)^2)
///
/// A measure that does not rise throughout may cross the threshold more than once. The last crossing
/// counts, as what is wanted is a size from which on the die is full: a finer one that filled by
/// chance, or by another mechanism, is no such size. Such a series is marked by `falls`.
///
/// `series` has at least one variant.
CriticalSizeRatio criticalSizeRatio(const Series& series, double threshold);

} // namespace interstice
