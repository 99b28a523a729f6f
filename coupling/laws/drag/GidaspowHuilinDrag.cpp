// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/GidaspowHuilinDrag.hpp"

#include "coupling/laws/drag/SphereDrag.hpp"

namespace interstice
{

namespace
{

constexpr double pi = 3.14159265358979323846;

double publishedBlend(double voidFraction)
{
    return std::atan(150 * 1.75 * (0.8 - voidFraction)) / pi + 0.5;
}

} // namespace

GidaspowHuilinDrag::GidaspowHuilinDrag(const DragOptions& options)
    : sphericity_(options.sphericity), cleanBlend_(options.cleanBlend)
{
}

double GidaspowHuilinDrag::blend(double voidFraction) const
{
    const double phi = publishedBlend(voidFraction);
    if (!cleanBlend_)
    {
        return phi;
    }

    static const double leak = publishedBlend(1);
    return std::clamp((phi - leak) / (1 - 2 * leak), 0.0, 1.0);
}

double GidaspowHuilinDrag::coefficientPerVolume(const LocalFlow& flow) const
{
    const double alpha = flow.voidFraction;
    const double wenYu =
        std::pow(alpha, drag::wenYuExponent) * drag::continuousCdRe(alpha * flow.reynolds());
    const double ergun = drag::ergunCdRe(flow, sphericity_);
    const double phi = blend(alpha);

    return drag::coefficientPerVolume(phi * ergun + (1 - phi) * wenYu, flow);
}

} // namespace interstice
