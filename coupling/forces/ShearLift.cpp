// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/ShearLift.hpp"

#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/LiftForces.hpp"

namespace interstice
{

using namespace Foam;

Effect ShearLift::effect() const
{
    return {"shearLift", "lift in shear over Stokes' drag", largestLiftShare};
}

// At cells with parcels, for the coarsest grain.
double ShearLift::number(AirMotion& air, const DemEngine& dem) const
{
    const double grain = 2*dem.maximumRadius()/coarseGraining_;
    const volVectorField& vorticity = air.vorticity();
    double largest = 0;
    for (const int celli : air.onMesh.cells())
    {
        if (air.onMesh.voidFraction()[celli] > loneGrainVoidFraction)
        {
            largest = max(largest,
                saffmanShare(grain, air.density, air.density*air.nu[celli], mag(vorticity[celli])));
        }
    }
    return returnReduce(largest, maxOp<double>());
}

void ShearLift::act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own)
{
    const std::vector<AirMotion::Around>& around = air.around();
    const ParticleView view = dem.particles();
    const double grains = pow3(coarseGraining_);
    for (int i = 0; i < view.count; ++i)
    {
        if (!seen(own[i]) || around[i].voidFraction <= loneGrainVoidFraction)
        {
            continue;
        }
        const Vec3& u = own[i].velocity;
        const double* v = view.velocity[i];
        const vector& w = around[i].vorticity;
        const std::array<double, 3> lift =
            shearLift({2*view.radius[i]/coarseGraining_, air.density, around[i].viscosity},
                {u[0] - v[0], u[1] - v[1], u[2] - v[2]}, {w.x(), w.y(), w.z()});
        give(own[i], grains*vector(lift[0], lift[1], lift[2]), air.interval);
    }
}

} // namespace interstice
