// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/SurfaceSlope.hpp"

#include "coupling/laws/InputError.hpp"

#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"

#include <cmath>

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(SurfaceSlope, 0);
addToRunTimeSelectionTable(functionObject, SurfaceSlope, dictionary);

namespace
{

/// A point of the surface: height, then place along the direction, to be compared in this order.
struct Peak
{
    scalar height = -GREAT;
    scalar along = 0;

    bool operator<(const Peak& other) const
    {
        return height < other.height || (height == other.height && along < other.along);
    }
};

/// The highest peak of each bin on all ranks: the reduced height finds whose place counts.
void highest(std::vector<Peak>& peaks)
{
    const label count = static_cast<label>(peaks.size());
    scalarField heights(count);
    forAll(heights, i)
    {
        heights[i] = peaks[i].height;
    }
    Pstream::listCombineGather(heights, maxEqOp<scalar>());
    Pstream::listCombineScatter(heights);
    scalarField places(count, -GREAT);
    forAll(places, i)
    {
        if (peaks[i].height == heights[i])
        {
            places[i] = peaks[i].along;
        }
    }
    Pstream::listCombineGather(places, maxEqOp<scalar>());
    Pstream::listCombineScatter(places);
    forAll(places, i)
    {
        peaks[i] = {heights[i], places[i]};
    }
}

} // namespace

Line fitLine(const std::vector<double>& x, const std::vector<double>& z)
{
    const std::size_t n = x.size();
    Line line;
    if (n < 2)
    {
        return line;
    }
    double meanX = 0;
    double meanZ = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        meanX += x[i]/n;
        meanZ += z[i]/n;
    }
    double xx = 0;
    double xz = 0;
    double zz = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        xx += (x[i] - meanX)*(x[i] - meanX);
        xz += (x[i] - meanX)*(z[i] - meanZ);
        zz += (z[i] - meanZ)*(z[i] - meanZ);
    }
    line.slope = xx > 0 ? xz/xx : 0;
    line.intercept = meanZ - line.slope*meanX;
    // Heights that differ by round-off alone are one height.
    line.determination = zz > 1e-20*xx ? line.slope*xz/zz : 1;
    return line;
}

SurfaceSlope::SurfaceSlope(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, dict, {"slope [deg]", "R2 [-]", "bins [-]"})
{
    read(dict);
}

bool SurfaceSlope::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    die_ = std::make_unique<DieCavity>(p.sub("die"), time_);
    const vector along = p.direction("direction", "", vector(1, 0, 0));
    const double bins = p.number("bins", "", Parameters::Range::positive, 10);
    p.allKnown();
    if (along.z() != 0 || mag(along) < SMALL)
    {
        throw InputError({"The slope of a surface is measured along a horizontal direction.",
            "z component " + Foam::name(along.z()), "a direction with z = 0, not zero itself",
            p.where("direction"), "Correct the direction."});
    }
    if (bins < 2 || bins != std::floor(bins))
    {
        throw InputError({"A line needs two points.", Foam::name(bins) + " bins",
            "a whole number of at least 2", p.where("bins"), "Correct the number."});
    }
    direction_ = along/mag(along);
    bins_ = static_cast<int>(bins);
    const Extent ends = extentAlong(die_->bounds(), direction_);
    start_ = ends.low;
    width_ = (ends.high - ends.low)/bins_;
    return true;
}

std::vector<double> SurfaceSlope::measure(const PowderState& powder)
{
    std::vector<Peak> peaks(bins_);
    for (int i = 0; i < powder.count; ++i)
    {
        const vector centre = toFoam(powder.position[i]);
        if (die_->holds(centre))
        {
            const double along = centre & direction_;
            const int bin = std::min(static_cast<int>((along - start_)/width_), bins_ - 1);
            peaks[bin] = std::max(peaks[bin], Peak{centre.z() + powder.radius[i], along});
        }
    }
    highest(peaks);

    std::vector<double> x;
    std::vector<double> z;
    for (const Peak& peak : peaks)
    {
        if (peak.height > -GREAT)
        {
            x.push_back(peak.along);
            z.push_back(peak.height);
        }
    }
    const Line line = fitLine(x, z);
    return {radToDeg(std::atan(line.slope)), line.determination, double(x.size())};
}

} // namespace interstice
