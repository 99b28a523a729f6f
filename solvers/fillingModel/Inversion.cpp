// SPDX-License-Identifier: GPL-3.0-or-later
#include "Inversion.hpp"

#include "Text.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace interstice
{

namespace
{

void checkPositive(double value, Sought sought, const FillingModel& model, const std::string& found)
{
    if (!(value > 0))
    {
        throw InputError({std::string("The model gives no positive ") + nameOf(sought)
                              + " at which the die is just full.",
            found, "a limit above zero",
            model.table + ", threshold " + formatted("%g", model.threshold),
            "These conditions are outside what the plane describes: take some nearer to the fit."});
    }
}

// By its definition: those N_v whose plane is within t standard errors of the size ratio.
//     (p + q N)^2 <= t^2 (u + N e)^T C (u + N e),   p + q N = a + b N + c rho_p/rho_g - d_p/h_D
std::optional<Interval> fieller(const LinearFit& fit, double density, double size)
{
    const Eigen::Vector3d u(1, 0, density);
    const Eigen::Vector3d e(0, 1, 0);
    const double p = fit.at({0, density}) - size;
    const double q = fit.coefficients(1);
    const double t2 = fit.quantile() * fit.quantile();

    const double a = q * q - t2 * e.dot(fit.covariance * e);
    const double b = p * q - t2 * u.dot(fit.covariance * e);
    const double c = p * p - t2 * u.dot(fit.covariance * u);
    if (a <= 0)
    {
        return std::nullopt;
    }
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    return Interval{(-b - root) / a, (-b + root) / a};
}

Limit smallestDiameter(const FillingModel& model, DieFilling filling)
{
    const LinearFit& fit = model.criticalSize.fit;
    const std::vector<double> groups = groupsOf(PlaneOf::criticalSize, filling);
    const double h = filling.dieDepth;
    const double value = h * fit.at(groups);
    checkPositive(value, Sought::particleDiameter, model,
        formatted("%.4g um from N_v %.4g, rho_p/rho_g %.5g", 1e6 * value, groups[0], groups[1]));

    filling.particleDiameter = value;
    const Interval size = fit.confidence(groups);
    return {value, false, h * std::max(size.low, 0.0), h * size.high, filling};
}

Limit deepestDie(const FillingModel& model, DieFilling filling)
{
    const LinearFit& fit = model.criticalSize.fit;
    const std::vector<double> groups = groupsOf(PlaneOf::criticalSize, filling);
    const double d = filling.particleDiameter;
    const double size = fit.at(groups);
    checkPositive(size, Sought::dieDepth, model,
        formatted("d_p/h_D %.4g from N_v %.4g, rho_p/rho_g %.5g", size, groups[0], groups[1]));

    filling.dieDepth = d / size;
    const Interval sizes = fit.confidence(groups);
    Limit limit{filling.dieDepth, true, d / sizes.high, std::nullopt, filling};
    if (sizes.low > 0)
    {
        limit.high = d / sizes.low;
    }
    return limit;
}

Limit limitingSpeed(const FillingModel& model, DieFilling filling)
{
    const LinearFit& fit = model.criticalSize.fit;
    const double size = sizeRatio(filling);
    const double density = densityRatio(filling);
    const double slope = fit.coefficients(1);
    const double speedOfOne = filling.gasViscosity / (filling.gasDensity * filling.dieLength);
    const double value = speedOfOne * (size - fit.at({0, density})) / slope;
    checkPositive(value, Sought::shoeSpeed, model,
        formatted("%.4g m/s from d_p/h_D %.4g, rho_p/rho_g %.5g", value, size, density));

    filling.shoeSpeed = value;
    Limit limit{value, slope > 0, std::nullopt, std::nullopt, filling};
    if (const std::optional<Interval> interval = fieller(fit, density, size))
    {
        limit.low = std::max(speedOfOne * interval->low, 0.0);
        limit.high = speedOfOne * interval->high;
    }
    return limit;
}

} // namespace

const char* nameOf(Sought sought)
{
    switch (sought)
    {
    case Sought::shoeSpeed:
        return "shoeSpeed";
    case Sought::particleDiameter:
        return "particleDiameter";
    default:
        return "dieDepth";
    }
}

Limit limitOf(Sought sought, const FillingModel& model, const DieFilling& filling)
{
    switch (sought)
    {
    case Sought::shoeSpeed:
        return limitingSpeed(model, filling);
    case Sought::particleDiameter:
        return smallestDiameter(model, filling);
    default:
        return deepestDie(model, filling);
    }
}

} // namespace interstice
