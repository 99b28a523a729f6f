// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Drag in random arrays of spheres up to Re = 1000, from lattice-Boltzmann simulations.
///
///     B = 18 mu alpha_f/d^2 F
///     F = 10 alpha_p/alpha_f^2 + alpha_f^2 (1 + 1.5 sqrt(alpha_p))
///       + 0.413 Re/(24 alpha_f^2) [1/alpha_f + 3 alpha_f alpha_p + 8.4 Re^-0.343]
///                                 / [1 + 10^(3 alpha_p) Re^-(1 + 4 alpha_p)/2]
///     Re = alpha_f rho |u - v| d/mu
///
/// F is the drag without the pressure force, over Stokes' drag at the superficial velocity.
///
/// R. Beetstra, M.A. van der Hoef & J.A.M. Kuipers, AIChE J. 53 (2007) 489-501, for spheres of one
/// size.
class BeetstraDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
