// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/StokesDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

double StokesDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    return drag::coefficientPerVolume(24, flow);
}

} // namespace interstice
