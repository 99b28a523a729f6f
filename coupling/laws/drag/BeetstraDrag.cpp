// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/BeetstraDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

double BeetstraDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    const double alpha = flow.voidFraction;
    const double solid = flow.solidFraction();
    const double re = alpha * flow.reynolds();

    const double creeping =
        10 * solid / (alpha * alpha) + alpha * alpha * (1 + 1.5 * std::sqrt(solid));

    // Numerator times Re and both sides of the fraction times Re^(1 + 4 alpha_p)/2, so that only
    // positive powers of Re are left and zero slip needs no care.
    const double numerator = (1 / alpha + 3 * alpha * solid) * re + 8.4 * std::pow(re, 1 - 0.343);
    const double power = std::pow(re, 0.5 * (1 + 4 * solid));
    const double inertial =
        0.413 / (24 * alpha * alpha) * numerator * power / (power + std::pow(10, 3 * solid));

    return drag::coefficientPerVolume(24 * alpha * (creeping + inertial), flow);
}

} // namespace interstice
