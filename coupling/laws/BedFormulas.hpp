// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Closed results for uniform beds and suspensions: what tests, and users in doubt, compare with.
/// All of them hold for model A, and take grains, never parcels: none depends on k.

/// Uniform grains in a gas.
struct Powder
{
    double diameter; ///< [m]
    double density; ///< Of the grains [kg/m3].
    double gasDensity; ///< [kg/m3]
    double gasViscosity; ///< Dynamic [Pa s].
};

/// The air around a grain of the powder.
LocalFlow flowAround(const Powder& powder, double voidFraction, double slip);

/// Slip |u - v| [m/s] at which drag and pressure force carry the grains.
///
/// With the weight of the mixture as pressure gradient this is B slip = alpha_f (rho_p - rho_f) g;
/// found by bisection, to round-off.
///
/// @param gravity above 0 [m/s2]; the grains must be denser than the gas
double carryingSlip(const DragLaw& law, const Powder& powder, double voidFraction, double gravity);

/// Velocity [m/s] at which a lone grain falls through still gas.
double terminalVelocity(const DragLaw& law, const Powder& powder, double gravity);

/// Velocity [m/s] at which a uniform suspension settles in a closed column, where the gas has to
/// rise past the grains: alpha_f times the carrying slip.
double settlingVelocity(
    const DragLaw& law, const Powder& powder, double voidFraction, double gravity);

/// Superficial gas velocity U_mf [m/s] that carries a bed. The same balance as of a settling
/// suspension, seen from the grains.
double minimumFluidisationVelocity(
    const DragLaw& law, const Powder& powder, double voidFraction, double gravity);

/// Pressure drop per length [Pa/m] of a fixed bed by a drag law: alpha_f dp/L = beta U/alpha_f.
///
/// @param superficialVelocity U = alpha_f u [m/s]
double bedPressureGradient(
    const DragLaw& law, const Powder& powder, double voidFraction, double superficialVelocity);

/// Pressure drop per length [Pa/m] of a fixed bed by Ergun's formula:
///
///     150 mu U alpha_p^2/(alpha_f^3 d^2) + 1.75 rho_f U^2 alpha_p/(alpha_f^3 d)
///
/// S. Ergun, Chem. Eng. Prog. 48 (1952) 89-94.
double ergunPressureGradient(const Powder& powder, double voidFraction, double superficialVelocity);

} // namespace interstice
