// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/SchillerNaumannDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

double SchillerNaumannDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    return drag::coefficientPerVolume(drag::switchedCdRe(flow.reynolds()), flow);
}

} // namespace interstice
