// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/RarefiedDrag.hpp"

#include <cmath>
#include <utility>

namespace interstice
{

double cunninghamFactor(double knudsen)
{
    return 1 + knudsen*(1.257 + (knudsen > 0 ? 0.4*std::exp(-1.1/knudsen) : 0));
}

RarefiedDrag::RarefiedDrag(std::unique_ptr<DragLaw> law, double meanFreePath)
    : law_(std::move(law)), meanFreePath_(meanFreePath)
{
}

double RarefiedDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    return law_->coefficientPerVolume(flow)/cunninghamFactor(2*meanFreePath_/flow.diameter);
}

} // namespace interstice
