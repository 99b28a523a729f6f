// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Gidaspow's drag: Ergun in the bed, Wen-Yu in the suspension, and a switch between them.
///
///     C_D Re = 200 alpha_p/alpha_f + 7/3 Re                                alpha_f <  0.8
///     C_D Re = alpha_f^-2.65 max{24 [1 + 0.15 Re_s^0.687], 0.44 Re_s}      otherwise
///     Re     = rho |u - v| d/mu,   Re_s = alpha_f Re
///
/// The sharp limit of GidaspowHuilinDrag. At the switch the drag jumps: downwards by 13 % for
/// creeping flow, by 38 % at Re = 100 and by 71 % at Re = 1000.
///
/// D. Gidaspow, Multiphase Flow and Fluidization, Academic Press (1994).
class GidaspowSwitchDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
