// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

#include <algorithm>
#include <cmath>

/// Parts that several drag laws are made of. All are written as C_D Re, which is finite at
/// zero slip where C_D is not.
namespace interstice::drag
{

/// Drag coefficient of one sphere above which its wake no longer cares for viscosity (Newton).
constexpr double newton = 0.44;

/// C_D Re of a lone sphere below Re = 1000.
///
///     C_D Re = 24 (1 + 0.15 Re^0.687)
///
/// L. Schiller & A. Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318-320.
inline double viscousCdRe(double re)
{
    return 24 * (1 + 0.15 * std::pow(re, 0.687));
}

/// C_D Re of a lone sphere, with the two regimes joined by a switch at Re = 1000, where C_D
/// steps from 0.4384 to 0.44.
inline double switchedCdRe(double re)
{
    return re > 1000 ? newton * re : viscousCdRe(re);
}

/// C_D Re of a lone sphere, with the two regimes joined by the larger of both, without a step.
inline double continuousCdRe(double re)
{
    return std::max(viscousCdRe(re), newton * re);
}

/// Exponent of the void fraction by which neighbours raise C_D Re in a dilute suspension.
///
/// C.Y. Wen & Y.H. Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100-111: 4.65 - 2 in the study's
/// interstitial form (Eq 10: -1.65 for C_D, and one more for the Reynolds number inside it).
constexpr double wenYuExponent = -2.65;

/// C_D Re of a packed bed.
///
///     C_D Re = 200 alpha_p/(alpha_f S^2) + 7/(3 S) Re
///
/// The same as beta = 150 alpha_p^2 mu/(alpha_f d^2) + 1.75 alpha_p rho |u - v|/d for S = 1.
///
/// S. Ergun, Chem. Eng. Prog. 48 (1952) 89-94; Eq 9 of Materials 18(14) (2025) 3261.
inline double ergunCdRe(const LocalFlow& flow, double sphericity = 1)
{
    return 200 * flow.solidFraction() / (flow.voidFraction * sphericity * sphericity)
           + 7 / (3 * sphericity) * flow.reynolds();
}

/// B [kg/m3/s] that belongs to a drag coefficient: 3/4 (C_D Re) mu/d^2.
inline double coefficientPerVolume(double cdRe, const LocalFlow& flow)
{
    return 0.75 * cdRe * flow.viscosity / (flow.diameter * flow.diameter);
}

} // namespace interstice::drag
