// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/EffectNumbers.hpp"

#include "coupling/laws/sphereVolume.hpp"

#include <cmath>

namespace interstice
{

namespace
{

constexpr double pi = 3.14159265358979323846;

} // namespace

double machNumber(double speed, double soundSpeed)
{
    return speed/soundSpeed;
}

double squeezedAirShare(double bulkDensity, double height, double gravity, double pressure)
{
    return bulkDensity*gravity*height/pressure;
}

double trappedAirNumber(
    double cavityDepth, double pressure, double permeability, double massPerArea)
{
    return cavityDepth/(pressure*permeability*permeability*massPerArea);
}

double virtualMassShare(double particleDensity, double gasDensity)
{
    return 0.5*gasDensity/particleDensity;
}

double historyShare(double diameter, double kinematicViscosity, double time)
{
    return diameter/(2*std::sqrt(pi*kinematicViscosity*time));
}

double saffmanShare(double diameter, double gasDensity, double gasViscosity, double shearRate)
{
    return 1.615/(3*pi)*diameter*std::sqrt(gasDensity*shearRate/gasViscosity);
}

double magnusShare(double diameter, double gasDensity, double gasViscosity, double spin)
{
    return gasDensity*diameter*diameter*spin/(24*gasViscosity);
}

double viscousForceShare(
    double gasViscosity, double speed, double length, double particleDensity, double gravity)
{
    return gasViscosity*speed/(length*length)/(particleDensity*gravity);
}

double rarefiedShare(double diameter, double meanFreePath)
{
    return 2.52*meanFreePath/diameter;
}

double meanFreePath(double gasDensity, double gasViscosity, double pressure)
{
    return gasViscosity*std::sqrt(pi/(2*pressure*gasDensity));
}

double stokesDragShare(
    double speed, double diameter, double gasViscosity, double particleDensity, double gravity)
{
    return 18*gasViscosity*speed/(particleDensity*gravity*diameter*diameter);
}

double bondNumber(double hamaker, double asperityRadius, double gap, double diameter,
    double particleDensity, double gravity)
{
    const double weight = sphereVolume(diameter)*particleDensity*gravity;
    return hamaker*asperityRadius/(6*gap*gap)/weight;
}

} // namespace interstice
