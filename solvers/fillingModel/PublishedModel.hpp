// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FillingModel.hpp"

#include <array>
#include <vector>

namespace interstice
{

/// The filling ratio that Eq 21 is for.
constexpr double publishedThreshold = 0.9;

/// Coefficients of Eq 21 for 1, N_v and rho_p/rho_g: read off from sizeRatioFor90Percent, so that
/// they stand in the code once.
std::array<double, 3> publishedCoefficients();

/// A series of the table beside Eq 21.
struct PublishedSeries
{
    CriticalSizeRatio measured;
    double fitted; ///< d_p/h_D of our plane.
    double published; ///< d_p/h_D of Eq 21.
    double error; ///< Standard error of measured: its own, else the scatter about our plane.
};

/// The series of a model that are in the range of Eq 21, its die and air included.
std::vector<PublishedSeries> seriesInPublishedRange(const FillingModel& model);

} // namespace interstice
