// SPDX-License-Identifier: GPL-3.0-or-later
// What CoupledPowder hands to the measures and to the disk.
#include "coupling/CoupledPowder.hpp"

#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/mesh/PowderCloud.hpp"

#include "PstreamReduceOps.H"

#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

vector toFoam(const Vec3& v)
{
    return vector(v[0], v[1], v[2]);
}

Vec3 toVec3(const vector& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

// After the DEM: particles may sit in other slots and on other ranks than when they got their air.
void CoupledPowder::refreshForces()
{
    const label count = hasAir() ? state_.count : 0;
    state_.drag.setSize(count);
    state_.pressureForce.setSize(count);
    state_.stepImpulse = Zero;
    forAll(state_.drag, i)
    {
        const AirAction action = dem_->airAction(i);
        const vector impulse = toFoam(action.dragImpulse);
        state_.drag[i] = impulse/state_.interval;
        state_.pressureForce[i] = toFoam(action.force);
        state_.stepImpulse += impulse;
    }
    reduce(state_.stepImpulse, sumOp<vector>());
    state_.gravity = toFoam(dem_->gravity());
}

// The exchange is planned for where the particles are; the next step plans it anew.
void CoupledPowder::writeCloud()
{
    std::vector<SearchPoint> points;
    std::vector<CloudParcel> own;
    for (int i = 0; i < state_.count; ++i)
    {
        const double* x = state_.position[i];
        const double* v = state_.velocity[i];
        const Vec3 position = toVec3(onMesh_->box().wrap(vector(x[0], x[1], x[2])));
        if (!std::isfinite(position[0] + position[1] + position[2]))
        {
            continue; // the last state of a run that failed has no place for it
        }
        points.push_back({position, position});
        own.push_back({position, {v[0], v[1], v[2]},
            hasAir() ? toVec3(state_.drag[i]) : Vec3{},
            hasAir() ? toVec3(state_.pressureForce[i]) : Vec3{}, 2*state_.radius[i],
            state_.mass[i], state_.id[i]});
    }
    exchange_->plan(points, onMesh_->locator());
    writePowderCloud(mesh_, exchange_->toHandlers(own), exchange_->cells());
}

} // namespace interstice
