// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Drag in random arrays of spheres, from lattice-Boltzmann simulations.
///
///     B  = 18 mu alpha_f^2/d^2 (F0 + F3 Re/2)
///     F0 = [1 + 3 sqrt(alpha_p/2) + 135/64 alpha_p ln(alpha_p) + 16.14 alpha_p]
///          / [1 + 0.681 alpha_p - 8.48 alpha_p^2 + 8.16 alpha_p^3]          alpha_p <  0.4
///     F0 = 10 alpha_p/alpha_f^3                                             otherwise
///     F3 = 0.0673 + 0.212 alpha_p + 0.0232/alpha_f^5
///     Re = alpha_f rho |u - v| d/mu
///
/// The paper's force contains the pressure force and its Reynolds number the radius: hence the
/// factors alpha_f^2 (for one) and 1/2. Where the published branches of F0 meet, it jumps by 1 %.
///
/// D.L. Koch & R.J. Hill, Annu. Rev. Fluid Mech. 33 (2001) 619-647.
class KochHillDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
