// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/TimeScales.hpp"

#include <cmath>
#include <limits>

namespace interstice
{

namespace
{

constexpr double pi = 3.14159265358979323846;

} // namespace

double rayleighTime(double radius, double density, double youngsModulus, double poissonRatio)
{
    const double shearModulus = youngsModulus / (2 + 2 * poissonRatio);
    return pi * radius * std::sqrt(density / shearModulus) / (0.1631 * poissonRatio + 0.8766);
}

double hertzTime(
    double effectiveMass, double effectiveRadius, double effectiveModulus, double speed)
{
    const double massOverModulus = effectiveMass / effectiveModulus;
    return 2.87 * std::pow(massOverModulus * massOverModulus / (effectiveRadius * speed), 0.2);
}

double ExchangeScales::particleTime() const noexcept
{
    return particleDensity / coefficientPerVolume;
}

double ExchangeScales::gasTime() const noexcept
{
    const double beta = (1 - voidFraction) * coefficientPerVolume;
    return voidFraction * gasDensity / beta;
}

double ExchangeScales::mutualTime() const noexcept
{
    return 1 / (1 / gasTime() + 1 / particleTime());
}

double ExchangeScales::sealedBedTime() const noexcept
{
    return voidFraction * voidFraction * particleTime();
}

double ExchangeScales::explicitLimit() const noexcept
{
    return 2 * sealedBedTime();
}

double ExchangeScales::implicitDragLimit() const noexcept
{
    const double margin = 1 - 2 * voidFraction * voidFraction;
    return margin > 0 ? 2 * sealedBedTime() / margin : std::numeric_limits<double>::infinity();
}

double ExchangeScales::recommendedStep() const noexcept
{
    return 0.2 * sealedBedTime();
}

double trappedAirFrequency(double pressure, double cavityDepth, double solidFraction,
    double particleDensity, double plugHeight)
{
    const double massPerArea = solidFraction * particleDensity * plugHeight;
    return std::sqrt(pressure / (cavityDepth * massPerArea)) / (2 * pi);
}

} // namespace interstice
