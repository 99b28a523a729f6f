// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/SpinLift.hpp"

#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/ImplicitDrag.hpp"
#include "coupling/laws/LiftForces.hpp"

namespace interstice
{

using namespace Foam;

namespace
{

std::array<double, 3> components(const vector& v)
{
    return {v.x(), v.y(), v.z()};
}

// Of a particle, less that of the air around it.
vector relativeSpin(const ParticleView& view, int i, const AirMotion::Around& air)
{
    const double* w = view.spin[i];
    return vector(w[0], w[1], w[2]) - 0.5*air.vorticity;
}

} // namespace

Effect SpinLift::effect() const
{
    return {"spinLift", "lift by spin over Stokes' drag", largestLiftShare};
}

double SpinLift::number(AirMotion& air, const DemEngine& dem) const
{
    const std::vector<AirMotion::Around>& around = air.around();
    const ParticleView view = dem.particles();
    double largest = 0;
    for (int i = 0; i < view.count; ++i)
    {
        if (around[i].voidFraction > loneGrainVoidFraction)
        {
            largest = max(largest, magnusShare(2*view.radius[i], air.density, around[i].viscosity,
                                       mag(relativeSpin(view, i, around[i]))));
        }
    }
    return returnReduce(largest, maxOp<double>());
}

void SpinLift::act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own)
{
    dem.useSpinDrag();
    const std::vector<AirMotion::Around>& around = air.around();
    const ParticleView view = dem.particles();
    for (int i = 0; i < view.count; ++i)
    {
        if (!seen(own[i]) || around[i].voidFraction <= loneGrainVoidFraction)
        {
            dem.setSpinDrag(i, {}, 0);
            continue;
        }
        const GasAtGrain gas{2*view.radius[i], air.density, around[i].viscosity};
        const vector spin = relativeSpin(view, i, around[i]);
        const double slowed = spinDrag(gas, mag(spin));
        dem.setSpinDrag(i, components(0.5*around[i].vorticity), slowed);

        // Of the mean spin of the interval, if nothing else turns the grain.
        const double mean = meanSlip(slowed*air.interval/(0.4*view.mass[i]*sqr(view.radius[i])));
        const Vec3& u = own[i].velocity;
        const double* v = view.velocity[i];
        const std::array<double, 3> lift =
            spinLift(gas, {u[0] - v[0], u[1] - v[1], u[2] - v[2]}, components(mean*spin));
        give(own[i], vector(lift[0], lift[1], lift[2]), air.interval);
    }
}

} // namespace interstice
