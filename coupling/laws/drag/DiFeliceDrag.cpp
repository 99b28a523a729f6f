// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/DiFeliceDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

double DiFeliceDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    // The exponent has reached its creeping limit long before; log10(0) would be a trapped error.
    const double re = std::max(flow.voidFraction * flow.reynolds(), 1e-12);

    const double offset = 1.5 - std::log10(re);
    const double chi = 3.7 - 0.65 * std::exp(-0.5 * offset * offset);
    const double root = 0.63 * std::sqrt(re) + 4.8;

    return drag::coefficientPerVolume(std::pow(flow.voidFraction, 1 - chi) * root * root, flow);
}

} // namespace interstice
