// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Another law in a gas that slips on the grains, since its molecules fly far: B over Cunningham's factor
///
///     1 + Kn [1.257 + 0.4 exp(-1.1/Kn)],     Kn = 2 lambda/d
///
/// C.N. Davies, Proc. Phys. Soc. 57 (1945) 259-270, of lone spheres in creeping flow. In a bed the pores, narrower than
/// the grains, count besides, and drag is less still.
class RarefiedDrag : public DragLaw
{
public:
    /// @param meanFreePath lambda [m]
    RarefiedDrag(std::unique_ptr<DragLaw> law, double meanFreePath);

    double coefficientPerVolume(const LocalFlow& flow) const override;

private:
    std::unique_ptr<DragLaw> law_;
    double meanFreePath_;
};

/// That factor.
///
/// @param knudsen Kn, at least 0
double cunninghamFactor(double knudsen);

} // namespace interstice
