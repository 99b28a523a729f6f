// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// The pair Ergun / Wen-Yu with a switch at a void fraction of 0.8, as CFD codes commonly have it.
///
///     C_D Re = 200 alpha_p/alpha_f + 7/3 Re              alpha_f <  0.8
///     C_D Re = alpha_f^-2.65 CdRe_sphere(alpha_f Re)     otherwise
///     Re     = rho |u - v| d/mu
///
/// It differs from GidaspowSwitchDrag only in the lone sphere inside Wen-Yu: here 0.44 begins at
/// alpha_f Re = 1000 with a small step, there where both curves cross (alpha_f Re = 989). The two
/// laws are equal everywhere else, and 0.4 % apart at most.
///
/// OpenFOAM's particle force of the same name gives B/alpha_f, the coefficient of model B, whose
/// drag contains the pressure force; this is its counterpart for model A.
///
/// S. Ergun, Chem. Eng. Prog. 48 (1952) 89-94; C.Y. Wen & Y.H. Yu, Chem. Eng. Prog. Symp. Ser. 62
/// (1966) 100-111; D. Gidaspow, Multiphase Flow and Fluidization, Academic Press (1994).
class ErgunWenYuDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
