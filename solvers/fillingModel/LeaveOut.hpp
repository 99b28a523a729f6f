// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FillingModel.hpp"

#include <string>
#include <vector>

namespace interstice
{

/// A point that a plane was not fitted to, and what the plane says of it.
struct LeftOutPoint
{
    PlanePoint point;
    double predicted;
    double combinedError; ///< Of measured less predicted, see combinedError().
    bool inRange; ///< Of the plane; others are shown but do not count.

    /// Measured less predicted, in combined standard errors.
    double deviation() const { return (point.fit.y - predicted) / combinedError; }
};

/// What became of all points left out.
struct LeaveOutCheck
{
    std::vector<LeftOutPoint> points;
    std::vector<int> needed; ///< Series without which there is no fit, so that none can be judged.

    int judged() const; ///< Points in range.
    int within(double errors) const; ///< Of those, the ones that deviate by no more.
};

/// Standard error of measured less predicted at a point that the plane was not fitted to:
///
///     sqrt(se(plane)^2 + max(1, chi2) se(measured)^2)   weighted fit, error of the point known
///     sqrt(se(plane)^2 + scatter^2)                     otherwise
///
/// The error of a point is widened where the plane misses its own points by more than their errors.
double combinedError(const LinearFit& fit, const FitPoint& point);

/// Leaves out one series after another and predicts it from a plane through the rest. Points are
/// always in range: a left-out series at the rim is judged too, by the wider error it has there.
///
/// Throws InputError if there are too few series to leave one out.
LeaveOutCheck leaveOutEach(
    PlaneOf kind, const std::vector<PlanePoint>& points, const std::string& where);

/// Predicts points of another table from a plane.
LeaveOutCheck leaveOutTable(
    PlaneOf kind, const Plane& plane, const std::vector<PlanePoint>& points);

} // namespace interstice
