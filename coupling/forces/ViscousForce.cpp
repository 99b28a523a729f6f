// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/ViscousForce.hpp"

#include "coupling/forces/weight.hpp"
#include "coupling/laws/EffectNumbers.hpp"

namespace interstice
{

using namespace Foam;

Effect ViscousForce::effect() const
{
    return {"viscousForce", "force of viscous stresses over weight", largestViscousForceShare};
}

// Of the lightest particle.
double ViscousForce::number(AirMotion& air, const DemEngine& dem) const
{
    return air.largestViscousForce()/(dem.minimumDensity()*pullOn(dem));
}

} // namespace interstice
