// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Ergun in the bed, Wen-Yu in the suspension, and a smooth blend between them.
///
///     C_D     = phi C_Ergun + (1 - phi) C_WenYu
///     phi     = atan[150 x 1.75 (0.8 - alpha_f)]/pi + 1/2
///     C_Ergun = 200 alpha_p/(alpha_f S^2 Re) + 7/(3 S)
///     C_WenYu = alpha_f^-1.65 max{24/(alpha_f Re) [1 + 0.15 (alpha_f Re)^0.687], 0.44}
///     Re      = rho |u - v| d/mu
///
/// S is the sphericity. Eqs 7-11 of Materials 18(14) (2025) 3261, after L. Huilin & D. Gidaspow,
/// Chem. Eng. Sci. 58 (2003) 3777-3792.
///
/// As published, phi leaks: phi(1) = 0.00606 puts a trace of Ergun's drag on a lone particle,
/// phi(0.4) = 0.99697 a trace of Wen-Yu's on a bed. The clean blend stretches phi about 0.8 until
/// it is 0 at alpha_f = 1, and 1 at 0.6 and below.
class GidaspowHuilinDrag final : public DragLaw
{
public:
    /// @param options sphericity, cleanBlend
    explicit GidaspowHuilinDrag(const DragOptions& options = {});

    double coefficientPerVolume(const LocalFlow& flow) const override;

    /// Ergun's share phi of the drag, in [0, 1].
    double blend(double voidFraction) const;

private:
    double sphericity_;
    bool cleanBlend_;
};

} // namespace interstice
