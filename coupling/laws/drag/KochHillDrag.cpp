// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/KochHillDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

namespace
{

double creepingForce(double solid, double alpha)
{
    if (solid >= 0.4)
    {
        return 10 * solid / (alpha * alpha * alpha);
    }

    // x ln x tends to zero with x, but log(0) would be a trapped error.
    const double logarithmic = solid > 0 ? 135.0 / 64 * solid * std::log(solid) : 0;

    return (1 + 3 * std::sqrt(0.5 * solid) + logarithmic + 16.14 * solid)
           / (1 + solid * (0.681 + solid * (-8.48 + solid * 8.16)));
}

double inertialForce(double solid, double alpha)
{
    const double square = alpha * alpha;
    return 0.0673 + 0.212 * solid + 0.0232 / (square * square * alpha);
}

} // namespace

double KochHillDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    const double alpha = flow.voidFraction;
    const double solid = flow.solidFraction();
    const double re = alpha * flow.reynolds();
    const double force = creepingForce(solid, alpha) + 0.5 * inertialForce(solid, alpha) * re;

    return drag::coefficientPerVolume(24 * alpha * alpha * force, flow);
}

} // namespace interstice
