// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Drag of a lone sphere, corrected by a power of the void fraction that depends on Re.
///
///     C_D Re = alpha_f^(1 - chi) (0.63 sqrt(Re) + 4.8)^2         Dalla Valle's C_D, times Re
///     chi    = 3.7 - 0.65 exp[-(1.5 - log10 Re)^2/2]
///     Re     = alpha_f rho |u - v| d/mu
///
/// One formula for all void fractions, without a switch.
///
/// R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153-159; in the form of model A, with the
/// interstitial slip, by Zhou, Kuang, Chu & Yu, J. Fluid Mech. 661 (2010) 482-510.
class DiFeliceDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
