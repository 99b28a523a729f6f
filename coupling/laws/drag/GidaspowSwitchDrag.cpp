// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/GidaspowSwitchDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

double GidaspowSwitchDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    const double alpha = flow.voidFraction;
    const double cdRe = alpha < 0.8 ? drag::ergunCdRe(flow)
                                    : std::pow(alpha, drag::wenYuExponent)
                                          * drag::continuousCdRe(alpha * flow.reynolds());

    return drag::coefficientPerVolume(cdRe, flow);
}

} // namespace interstice
