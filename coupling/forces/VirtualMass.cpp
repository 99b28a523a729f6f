// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/VirtualMass.hpp"

#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/sphereVolume.hpp"

namespace interstice
{

using namespace Foam;

Effect VirtualMass::effect() const
{
    return {"virtualMass", "mass of the air that a grain takes along, over its own", largestVirtualMassShare};
}

// Of the lightest particle.
std::optional<double> VirtualMass::numberAtStart(const AirAtRest& air, const DemEngine& dem) const
{
    return virtualMassShare(dem.minimumDensity(), air.density);
}

double VirtualMass::number(AirMotion& air, const DemEngine& dem) const
{
    return *numberAtStart({air.density, air.largestViscosity()}, dem);
}

void VirtualMass::act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own)
{
    dem.useAddedMass();
    const std::vector<vector>& acceleration = air.acceleration();
    const ParticleView view = dem.particles();
    for (int i = 0; i < view.count; ++i)
    {
        const double mass =
            seen(own[i]) ? coefficient*air.density*sphereVolume(2*view.radius[i]) : 0;
        dem.setAddedMass(i, mass);
        give(own[i], mass*acceleration[i], air.interval);
    }
}

} // namespace interstice
