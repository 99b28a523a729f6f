// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FillingModel.hpp"

#include <optional>
#include <string>

namespace interstice
{

/// What may be sought, the others given.
enum class Sought
{
    shoeSpeed,
    particleDiameter,
    dieDepth
};

/// The value at which a die is just full, and on which side of it the die is full.
struct Limit
{
    double value; ///< In SI units.
    bool largest; ///< True: it is full at and below the value; false: at and above.
    std::optional<double> low; ///< 95 % interval of the value; empty: no bound on this side.
    std::optional<double> high;
    DieFilling filling; ///< With the value in.
};

/// Solves d_p/h_D = a + b N_v + c rho_p/rho_g for one quantity; what `filling` has there is ignored.
///
///     particleDiameter   d_p = h_D (a + b N_v + c rho_p/rho_g)                    smallest
///     dieDepth           h_D = d_p/(a + b N_v + c rho_p/rho_g)                    largest
///     shoeSpeed          v   = mu_g/(rho_g L_D) (d_p/h_D - a - c rho_p/rho_g)/b   largest for b > 0,
///                                                                                 smallest for b < 0
///
/// Filling rises with d_p/h_D; so a given powder fills shallow dies, and the limit is the deepest.
/// Intervals are at 95 %: those values which the plane, within its own error, cannot tell from the
/// limit. For a speed that is Fieller's interval, unbounded if b does not differ from zero.
///
/// E.C. Fieller, J. R. Stat. Soc. B 16 (1954) 175-185.
///
/// Throws InputError if the plane gives no positive value.
Limit limitOf(Sought sought, const FillingModel& model, const DieFilling& filling);

/// Its name: that of the parameter.
const char* nameOf(Sought sought);

} // namespace interstice
