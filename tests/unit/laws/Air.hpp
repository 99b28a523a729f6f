// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/BedFormulas.hpp"
#include "coupling/laws/DragLaw.hpp"

namespace interstice::test
{

constexpr double gravity = 9.81;
constexpr double airDensity = 1.225;
constexpr double airViscosity = 1.7894e-5;

/// Air around a grain of 40 um at a Reynolds number of the interstitial slip.
inline LocalFlow airAt(double reynolds, double voidFraction)
{
    const double diameter = 40e-6;
    const double slip = reynolds * airViscosity / (airDensity * diameter);
    return {slip, voidFraction, diameter, airDensity, airViscosity};
}

/// C_D Re of a law, from its B: the inverse of B = 3/4 (C_D Re) mu/d^2.
inline double cdRe(const DragLaw& law, const LocalFlow& flow)
{
    return law.coefficientPerVolume(flow) * flow.diameter * flow.diameter / (0.75 * flow.viscosity);
}

/// The law's drag over Stokes' drag of the same slip.
inline double overStokes(const DragLaw& law, const LocalFlow& flow)
{
    return cdRe(law, flow) / 24;
}

/// Grains in air.
inline Powder powderInAir(double diameter, double density)
{
    return {diameter, density, airDensity, airViscosity};
}

} // namespace interstice::test
