// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CriticalSizeRatio.hpp"
#include "LinearFit.hpp"
#include "ValidRange.hpp"

#include <optional>
#include <string>
#include <vector>

namespace interstice
{

/// Rows whose filling ratio is not between these are left out of the plane for the filling ratio:
/// an empty or full die no longer tells how far its powder is from filling.
constexpr Interval unsaturated{0.05, 0.98};

/// A point of a fit, with the die filling it stands for and the number of its series.
struct PlanePoint
{
    FitPoint fit;
    DieFilling filling;
    int series;
};

/// What a plane answers, and from which groups.
enum class PlaneOf
{
    criticalSize, ///< (d_p/h_D)_crit = a + b N_v + c rho_p/rho_g
    fillingRatio ///< delta = s_0 + s_1 d_p/h_D + s_2 N_v + s_3 rho_p/rho_g
};

/// Names of the groups of a plane, in the order of its coefficients.
std::vector<std::string> groupNames(PlaneOf kind);

/// Values of these groups.
std::vector<double> groupsOf(PlaneOf kind, const DieFilling& filling);

/// A fitted plane and where it may be used.
struct Plane
{
    LinearFit fit;
    ValidRange range;
    double largestError; ///< Of the plane at the points that it was fitted to.
};

/// Fits a plane. Throws InputError as leastSquares does.
Plane fitPlane(PlaneOf kind, const std::vector<PlanePoint>& points, const std::string& where);

/// The filling model of linear die filling: which powder fills the die, and how far others do.
///
/// The form is that of Eq 21 of *Modeling of Linear Die Filling Based on Dimensional Analysis Using
/// DEM-CFD Methods*, Materials 18(14) (2025) 3261, with N_v = v rho_g L_D/mu_g.
struct FillingModel
{
    std::string table; ///< File that it was fitted to.
    std::string measure; ///< Its column.
    double threshold; ///< The filling ratio that counts as full.
    Plane criticalSize;
    std::vector<CriticalSizeRatio> series; ///< What criticalSize was fitted to.
    std::optional<Plane> fillingRatio; ///< Empty where the table does not carry it.
};

/// A model with all that was met on the way to it.
struct FillingFit
{
    FillingModel model;
    std::vector<Series> series;
    std::vector<CriticalSizeRatio> critical; ///< One a series, censored ones included.
    std::vector<PlanePoint> criticalPoints;
    std::vector<PlanePoint> ratioPoints;
    int rowsBelow; ///< Rows left out of ratioPoints, as all but empty.
    int rowsAbove; ///< As all but full.
    std::string whyNoFillingRatio; ///< Why the model has no such plane; empty if it has.
};

/// Whether the standard errors of a table count as exact, or as estimates from its packings that
/// are weights from fewestPackingsForWeights on.
enum class Errors
{
    fromPackings,
    trusted
};

/// Fits both planes to a table.
///
/// Throws InputError if the plane of the critical size cannot be fitted: too few series whose
/// critical size is known, or series that do not vary a group. That the plane of the filling ratio
/// cannot be fitted is no error.
FillingFit fitFillingModel(
    const ResultsTable& table, double threshold, Errors errors = Errors::fromPackings);

/// Takes the standard errors of points as exact.
void trustErrors(std::vector<PlanePoint>& points);

/// The points of the two planes.
std::vector<PlanePoint> criticalPointsOf(const std::vector<CriticalSizeRatio>& critical);
std::vector<PlanePoint> ratioPointsOf(const std::vector<Series>& series);

} // namespace interstice
