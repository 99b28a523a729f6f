// SPDX-License-Identifier: GPL-3.0-or-later
// How a run is kept, and how one goes on.
#include "coupling/Checkpoint.hpp"
#include "coupling/CoupledPowder.hpp"
#include "coupling/TimeStepChoice.hpp"
#include "coupling/forces/ParcelForces.hpp"
#include "coupling/laws/InputError.hpp"

#include "OSspecific.H"
#include "PstreamReduceOps.H"

namespace interstice
{

using namespace Foam;

wordList CoupledPowder::setAsideIncomplete(const fileName& casePath)
{
    return Checkpoint::setAsideIncomplete(casePath);
}

// Of the start time. Air of a coupled run without its powder is no state to start from.
std::optional<Checkpoint> CoupledPowder::checkpoint() const
{
    const Time& clock = mesh_.time();
    std::optional<Checkpoint> found = Checkpoint::of(clock);
    const bool airAlone = !found && isFile(clock.timePath()/"ddtVoidFraction");
    if (returnReduce(airAlone, orOp<bool>()))
    {
        throw InputError({"A run goes on from a checkpoint that is whole.",
            "air of a coupled run, no powder in " + clock.timeName() + "/uniform/powder",
            "the folder uniform/powder as it was written", clock.timeName(),
            "Copy it to there, or delete this time folder to go on from the one before."});
    }
    return found;
}

Checkpoint CoupledPowder::record() const
{
    Checkpoint c;
    const Time& clock = mesh_.time();
    c.time = clock.value();
    c.start = timeStep_->start();
    c.deltaT = clock.deltaTValue();
    c.timeIndex = clock.timeIndex();
    c.response = response_;
    c.lag = lag_;
    for (const Effect& effect : effects_.effects())
    {
        if (effect.largest)
        {
            c.effects[effect.key] = *effect.largest;
        }
    }
    c.initialMass = state_.initialMass;
    c.lost = state_.lost;
    c.particles = state_.total;
    for (int i = 0; i < state_.count; ++i)
    {
        c.mass += state_.mass[i];
    }
    reduce(c.mass, sumOp<scalar>());
    c.coarseGraining = coarseGraining_;
    c.cells = returnReduce(mesh_.nCells(), sumOp<label>());
    c.bounds = mesh_.bounds(); // of all ranks
    c.owed = state_.momentumRemainder;
    return c;
}

bool CoupledPowder::outputDue() const
{
    return timeStep_->outputDue();
}

void CoupledPowder::beginCheckpoint()
{
    if (!checkpoints_)
    {
        return;
    }
    StageClock::Scope timed(clock_, Stage::output);
    pending_ = std::make_unique<Checkpoint>(record());
    pending_->dem = dem_->writeRestart(Checkpoint::begin(mesh_.time()));
    refreshState(); // particles may lie elsewhere in memory
}

void CoupledPowder::completeCheckpoint()
{
    if (!pending_)
    {
        return;
    }
    StageClock::Scope timed(clock_, Stage::output);
    pending_->complete(mesh_.time());
    pending_.reset();
}

// Of the powder in the start time's folder; the script has read the particles.
void CoupledPowder::resume(const Checkpoint& before)
{
    before.requireSame(record());
    resumed_ = true;
    response_ = before.response;
    lag_ = before.lag;
    forces_->resume(before.effects, before.time);
    state_.initialMass = before.initialMass;
    state_.lost = before.lost;
    Time& clock = const_cast<Time&>(mesh_.time());
    clock.setTime(before.time, before.timeIndex);
    timeStep_->resume(before.start, before.deltaT);
    Info<< "Resumed at " << clock.timeName() << " s with " << label(before.particles)
        << " particles." << nl << endl;
}

} // namespace interstice
