// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/Dispersion.hpp"

#include "coupling/laws/ImplicitDrag.hpp"

#include <algorithm>
#include <cmath>

namespace interstice
{

namespace
{

constexpr double structureConstant = 2.1; // C_0
constexpr double longest = 1e9; // steps are as good as infinite beyond

// Variance of the mean of w over a step of x times T, that begins with a known w: the plain formula loses its digits
// for small x.
double varianceOfMean(double x)
{
    constexpr double small = 0.02;
    return x < small
        ? x*(2.0/3 + x*(-0.5 + x*(7.0/30 - x/12)))
        : (2*x - 3 + 4*std::exp(-x) - std::exp(-2*x))/(x*x);
}

} // namespace

double lagrangianTime(double energy, double dissipation)
{
    return energy > 0 && dissipation > 0 ? energy/dissipation/(0.5 + 0.75*structureConstant) : 0;
}

double seenTime(double time, double slip, double rms)
{
    return rms > 0 ? time*rms/std::hypot(rms, slip) : 0;
}

LangevinStep::LangevinStep(double ratio)
{
    const double x = std::min(ratio, longest);
    kept_ = std::exp(-x);
    keptMean_ = meanSlip(x);
    end_ = std::sqrt(-std::expm1(-2*x));
    mean_ = end_ > 0 ? x*keptMean_*keptMean_/end_ : 0;
    rest_ = std::sqrt(std::max(0.0, varianceOfMean(x) - mean_*mean_));
}

LangevinStep::Result LangevinStep::operator()(double w, double drift, double first, double second) const
{
    return {drift + kept_*(w - drift) + end_*first, drift + keptMean_*(w - drift) + mean_*first + rest_*second};
}

} // namespace interstice
