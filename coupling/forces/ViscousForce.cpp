// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/ViscousForce.hpp"

#include "coupling/laws/EffectNumbers.hpp"

namespace interstice
{

using namespace Foam;

Effect ViscousForce::effect() const
{
    return {"viscousForce", "force of viscous stresses over weight", largestViscousForceShare};
}

// Of the lightest particle; without gravity, on earth.
double ViscousForce::number(AirMotion& air, const DemEngine& dem) const
{
    const Vector3 g = dem.gravity();
    const double pull = mag(vector(g[0], g[1], g[2]));
    return air.largestViscousForce()/(dem.minimumDensity()*(pull > 0 ? pull : 9.81));
}

} // namespace interstice
