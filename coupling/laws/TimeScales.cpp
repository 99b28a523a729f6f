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

double tangentialDampingTime(double effectiveMass, double effectiveRadius, double effectiveModulus,
    double shearModulus, double restitution, double speed)
{
    const double logarithm = std::log(restitution);
    const double damping = -logarithm / std::sqrt(logarithm * logarithm + pi * pi);
    const double overlap = std::pow(15 * effectiveMass * speed * speed
            / (16 * effectiveModulus * std::sqrt(effectiveRadius)), 0.4);
    const double stiffness = 8 * shearModulus * std::sqrt(effectiveRadius * overlap);
    const double dashpot =
        2 * std::sqrt(5.0 / 6.0) * damping * std::sqrt(stiffness * effectiveMass);
    return 2 * effectiveMass / (7.0 / 2.0 * dashpot);
}

double displacedMassNumber(double voidFraction, double particleDensity, double gasDensity)
{
    return gasDensity / particleDensity * (1 - voidFraction) / voidFraction;
}

double trappedAirFrequency(double pressure, double cavityDepth, double solidFraction,
    double particleDensity, double plugHeight)
{
    const double massPerArea = solidFraction * particleDensity * plugHeight;
    return std::sqrt(pressure / (cavityDepth * massPerArea)) / (2 * pi);
}

} // namespace interstice
