// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/DieCavity.hpp"
#include "coupling/mesh/measures/PowderMeasure.hpp"

namespace interstice
{

/// A straight line z = a + b x through points, and how well it fits.
struct Line
{
    double slope = 0; ///< b; 0 for fewer than two points or points above each other
    double intercept = 0; ///< a
    double determination = 0; ///< R^2; 1 where all points are at one height
};

/// Least squares.
Line fitLine(const std::vector<double>& x, const std::vector<double>& z);

/// Slope of the powder's surface in a die.
///
/// The die is cut into bins of equal width along a direction. The highest particle of each bin (its
/// uppermost point; centre in the die) marks the surface; a least-squares line through these points
/// gives the angle, positive where the surface rises along the direction. Bins without powder are
/// left out. Bins should be several particles wide, or dents between particles count as surface. As
/// long as powder still falls through the mouth, it is the highest of its bin: read the slope when
/// the shoe has gone, and look at R^2.
///
/// Usage
///
///     surfaceSlope
///     {
///         type    surfaceSlope;
///         die     { low (0 0 -0.005); high (0.008 0.008 0); }
///     }
///
/// Property  | Description                      | Unit | Default
/// die       | see DieCavity                    |      | required
/// direction | horizontal direction of the bins |      | (1 0 0)
/// bins      | number of bins, at least 2       |      | 10
class SurfaceSlope final : public PowderMeasure
{
public:
    TypeName("surfaceSlope");

    SurfaceSlope(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;

private:
    std::vector<double> measure(const PowderState& powder) override;

    std::unique_ptr<DieCavity> die_;
    Foam::vector direction_;
    int bins_ = 0;
    double start_ = 0; // of the first bin along the direction [m]
    double width_ = 0; // of a bin [m]
};

} // namespace interstice
