// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/CoupledPowder.hpp"

#include "coupling/Checkpoint.hpp"
#include "coupling/TimeStepChoice.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/forces/ParcelForces.hpp"
#include "coupling/forces/tell.hpp"
#include "coupling/laws/TimeScales.hpp"
#include "coupling/laws/sphereVolume.hpp"

#include "PstreamReduceOps.H"
#include <algorithm>
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

CoupledPowder::~CoupledPowder() = default;

// Where the walls will be after an interval, like the powder.
void CoupledPowder::moveSolids(double interval)
{
    if (!solids_->any())
    {
        return;
    }
    const EffectTable::Timed timed(effects_, effects_.place("movingWalls"));
    std::vector<RigidPose> poses;
    for (const std::string& wall : solidWalls_)
    {
        RigidPose pose = dem_->wallPose(wall);
        for (int d = 0; d < 3; ++d)
        {
            pose.translation[d] += interval*pose.velocity[d];
        }
        poses.push_back(pose);
    }
    solids_->move(poses);
    onMesh_->cover(solids_->covered());
}

// Parcels travel to the ranks of their cells, at the positions that they will have after an
// interval: the void fraction then belongs to the end of the step, as the pressure does.
void CoupledPowder::placeParcels(double interval)
{
    const ParticleView view = dem_->particles();
    std::vector<SearchPoint> points(view.count);
    std::vector<ParcelRecord> own(view.count);
    const PeriodicBox& box = onMesh_->box();
    const double added = forces_->addedDensity(density_);
    for (int i = 0; i < view.count; ++i)
    {
        const double* x = view.position[i];
        const double* v = view.velocity[i];
        const vector now(x[0], x[1], x[2]);
        const MovingSolid::Seen then =
            solids_->outside(now + interval*vector(v[0], v[1], v[2]));
        points[i] = {toVec3(box.wrap(then.position)), toVec3(box.wrap(now))};
        const double volume = sphereVolume(2*view.radius[i]);
        own[i] = {points[i].position, {v[0], v[1], v[2]}, movesAir() ? dem_->impulse(i) : Vec3{}, 2*view.radius[i],
            view.mass[i] + added*volume, then.presence, view.id[i]};
    }

    std::vector<ParcelRecord> handled;
    {
        StageClock::Scope timed(clock_, Stage::exchange);
        exchange_->plan(points, onMesh_->locator());
        handled = exchange_->toHandlers(own);
    }
    onMesh_->place(std::move(handled), exchange_->cells());
}

void CoupledPowder::adaptDrag()
{
    const double freePath = onMesh_->rarefied() ? 0 : forces_->freePath({density_, viscosity_});
    if (freePath > 0)
    {
        onMesh_->rarefy(freePath);
    }
}

void CoupledPowder::chooseTimeStep(double courant)
{
    TimeStepChoice::Scene scene;
    scene.air = hasAir();
    scene.courant = courant;
    scene.response = movesAir() ? response_ : 0; // a held air cannot swing
    const auto [radius, density] = dem_->quickestParticle();
    scene.radius = radius;
    scene.density = density;
    scene.cell = std::cbrt(gMin(mesh_.V()));
    scene.speed = dem_->maximumSpeed();
    for (const std::string& wall : dem_->meshWalls())
    {
        scene.speed = max(scene.speed, mag(toFoam(dem_->wallPose(wall).velocity)));
    }
    lightest_ = min(lightest_, dem_->minimumDensity());
    timeStep_->choose(scene, *dem_);
}

// The velocity at the start of a step stands for that of the whole step. That is late by half a step, and
// the next step makes up for it: with the displaced mass number M the powder's velocity then grows if
// 2 M + dt/tau_eff (alpha/2 + alpha_p) > 1 (stability map). M is that of the densest packing.
bool CoupledPowder::predicted() const
{
    constexpr double densestPacking = 0.36;
    constexpr double largestMass = 0.09; // stable up to dt = tau_eff
    return displacedMassNumber(densestPacking, lightest_, density_) < largestMass;
}

// Time from now at which the air sees the powder: the end of the coming interval. Light powder is seen
// late by a step, which is stable at any density. Late by the same time while the step changes, as far as
// that goes: what it moves in an interval belongs to that interval, whatever the one before was.
double CoupledPowder::seenAfter(double interval)
{
    constexpr double longestLag = 1.5; // intervals
    lag_ = predicted() ? 0 : min(max(lag_, interval), longestLag*interval);
    return interval - lag_;
}

void CoupledPowder::tellLag()
{
    if (movesAir() && !lagTold_ && !predicted())
    {
        lagTold_ = true;
        Info<< "Powder of " << lightest_ << " kg/m3 in a fluid of " << density_ << " kg/m3 is light: "
            << "the fluid sees it a step late, which is stable and of first order in time." << nl
            << endl;
    }
}

void CoupledPowder::toAir(const volVectorField& U, const volScalarField& nu)
{
    const double interval = mesh_.time().deltaTValue();
    StageClock::Scope timed(clock_, Stage::deposit);
    tellLag();
    const double then = seenAfter(interval);
    moveSolids(then);
    placeParcels(then);
    onMesh_->depositVolume();
    adaptDrag();
    onMesh_->depositDrag(solids_->airInOpenPart(U, onMesh_->voidFraction()), density_, nu, interval);
    response_ = onMesh_->report().shortestResponse;
    clock_.move(Stage::deposit, Stage::smoothing, onMesh_->smoothing().takeSeconds());
}

void CoupledPowder::fromAir(const volVectorField& U, const volScalarField& nu,
    const volVectorField& stressGradient)
{
    const double interval = mesh_.time().deltaTValue();
    std::vector<GasRecord> own(dem_->particles().count);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        // Who is in no cell gets no air, and keeps what it has to give until it is back.
        const Vec3 waiting = dem_->impulse(static_cast<int>(i));
        own[i].given = {-waiting[0], -waiting[1], -waiting[2]};
    }
    {
        StageClock::Scope timed(clock_, Stage::deposit);
        const std::vector<GasRecord> handled =
            onMesh_->gasAtParcels(
                solids_->airInOpenPart(U, onMesh_->voidFraction()), stressGradient, interval);
        clock_.move(Stage::deposit, Stage::smoothing, onMesh_->smoothing().takeSeconds());
        StageClock::Scope exchanging(clock_, Stage::exchange);
        exchange_->toOwners(handled, own);
    }
    {
        StageClock::Scope timed(clock_, Stage::deposit);
        AirMotion air(U, nu, density_, *onMesh_, *exchange_, own.size());
        forces_->act(air, *dem_, own, mesh_.time());
    }
    StageClock::Scope timed(clock_, Stage::dem);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const GasRecord& air = own[i];
        const Vec3 given =
            movesAir() ? Vec3{-air.given[0], -air.given[1], -air.given[2]} : Vec3{}; // nothing is given to a held air
        dem_->setGas(static_cast<int>(i), {air.velocity, air.dragCoefficient, air.force}, given);
    }
    dem_->advance(timeStep_->demSteps());
    refreshState();
}

void CoupledPowder::fall()
{
    StageClock::Scope timed(clock_, Stage::dem);
    if (lookDue(mesh_.time()))
    {
        tell(effects_, airPlace_, airNumber(), mesh_.time().value());
    }
    dem_->advanceWithoutAir(timeStep_->demSteps());
    refreshState();
}

void CoupledPowder::refreshState()
{
    const ParticleView view = dem_->particles();
    state_.count = view.count;
    state_.position = view.position;
    state_.velocity = view.velocity;
    state_.radius = view.radius;
    state_.mass = view.mass;
    state_.id = view.id;
    state_.interval = mesh_.time().deltaTValue();
    refreshForces();
    const PowderOnMesh::Report& report = onMesh_->report();
    state_.clippedVolume = report.floor.clipped;
    state_.movedVolume = report.floor.moved;
    state_.hidden = report.hidden;
    state_.hiddenVolume = report.hiddenVolume;
    state_.outside = returnReduce(label(exchange_->outside().size()), sumOp<label>());
    const long long before = state_.total;
    state_.total = dem_->particleCount();
    state_.lost += std::max(before - state_.total, 0LL);
    state_.momentumRemainder = Zero;
    for (int i = 0; movesAir() && i < view.count; ++i)
    {
        state_.momentumRemainder += toFoam(dem_->impulse(i));
    }
    reduce(state_.momentumRemainder, sumOp<vector>());
    for (const std::string& wall : dem_->meshWalls())
    {
        state_.wallTravel[wall] = toFoam(dem_->wallPose(wall).translation);
    }
    // Last, so that what is good can still be written.
    checkParticles();
}

CoupledPowder::Traffic CoupledPowder::traffic() const
{
    const ParticleExchange::Traffic& mine = exchange_->traffic();
    const auto total = [](double value) { return returnReduce(value, sumOp<double>()); };
    const double bytes = total(mine.bytes);
    const double messages = total(mine.messages);
    const double guests = total(exchange_->handled() - double(exchange_->residents().size()));
    const double particles = max(double(state_.total), 1.0);
    const double steps = max(double(mine.plans), 1.0);
    return {bytes/particles/steps, messages/Pstream::nProcs()/steps, guests/particles};
}

bool CoupledPowder::feelsViscosity() const
{
    return forces_->viscous();
}

const std::string& CoupledPowder::bindingLimit() const
{
    return timeStep_->bindingLimit();
}

long CoupledPowder::demSteps() const
{
    return timeStep_->demSteps();
}

double CoupledPowder::demTimeStep() const
{
    return dem_->timeStep();
}

} // namespace interstice
