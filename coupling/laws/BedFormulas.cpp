// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/BedFormulas.hpp"

namespace interstice
{

LocalFlow flowAround(const Powder& powder, double voidFraction, double slip)
{
    return {slip, voidFraction, powder.diameter, powder.gasDensity, powder.gasViscosity};
}

double carryingSlip(const DragLaw& law, const Powder& powder, double voidFraction, double gravity)
{
    const double load = voidFraction * (powder.density - powder.gasDensity) * gravity;

    const auto drag = [&](double slip)
    { return slip * law.coefficientPerVolume(flowAround(powder, voidFraction, slip)); };

    // Creeping drag gives a first guess from above for most laws. Not for Di Felice's, whose
    // coefficient falls with the slip in very dense beds.
    double low = 0;
    double high = load / law.coefficientPerVolume(flowAround(powder, voidFraction, 0));
    while (drag(high) < load)
    {
        high *= 2;
    }

    // Until the interval cannot be halved any more.
    for (double mid = 0.5 * high; mid > low && mid < high; mid = 0.5 * (low + high))
    {
        (drag(mid) < load ? low : high) = mid;
    }
    return high;
}

double terminalVelocity(const DragLaw& law, const Powder& powder, double gravity)
{
    return carryingSlip(law, powder, 1, gravity);
}

double settlingVelocity(
    const DragLaw& law, const Powder& powder, double voidFraction, double gravity)
{
    return voidFraction * carryingSlip(law, powder, voidFraction, gravity);
}

double minimumFluidisationVelocity(
    const DragLaw& law, const Powder& powder, double voidFraction, double gravity)
{
    return settlingVelocity(law, powder, voidFraction, gravity);
}

double bedPressureGradient(
    const DragLaw& law, const Powder& powder, double voidFraction, double superficialVelocity)
{
    const double slip = superficialVelocity / voidFraction;
    const LocalFlow air = flowAround(powder, voidFraction, slip);
    return air.solidFraction() * law.coefficientPerVolume(air) * slip / voidFraction;
}

double ergunPressureGradient(const Powder& powder, double voidFraction, double superficialVelocity)
{
    const double d = powder.diameter;
    const double u = superficialVelocity;
    const double solid = 1 - voidFraction;
    const double viscous = 150 * powder.gasViscosity * u * solid * solid / (d * d);
    const double inertial = 1.75 * powder.gasDensity * u * u * solid / d;
    return (viscous + inertial) / (voidFraction * voidFraction * voidFraction);
}

} // namespace interstice
