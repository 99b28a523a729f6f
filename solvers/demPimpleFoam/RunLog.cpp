// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunLog.hpp"

#include "OSspecific.H"
#include "Pstream.H"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <cstdio>
#include <fstream>

namespace interstice
{

using namespace Foam;

namespace
{

std::string duration(double seconds)
{
    char text[32];
    const long s = std::lround(seconds);
    if (s < 60)
    {
        std::snprintf(text, sizeof text, "%ld s", s);
    }
    else if (s < 3600)
    {
        std::snprintf(text, sizeof text, "%ld min %02ld s", s/60, s % 60);
    }
    else
    {
        std::snprintf(text, sizeof text, "%ld h %02ld min", s/3600, s/60 % 60);
    }
    return text;
}

// Of this rank [bytes].
double peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0*usage.ru_maxrss; // Linux counts in KiB
}

} // namespace

RunLog::RunLog(Time& time, CoupledPowder& powder, StageClock& clock)
:
    time_(time),
    powder_(powder),
    clock_(clock),
    tableEvery_(time.controlDict().getOrDefault<scalar>("timeTableEvery", 60)),
    nextTable_(tableEvery_)
{
    Info<< "Effects, as far as the case tells (effects { KEY auto|on|off; } of couplingProperties):" << nl
        << powder.effects().text().c_str() << endl;
}

void RunLog::step(const AirFlow::Report& air)
{
    const double passed = time_.value() - time_.startTime().value();
    const double whole = time_.endTime().value() - time_.startTime().value();
    const double share = min(passed/whole, 1.0);
    const PowderState& state = powder_.state();

    char line[256];
    std::snprintf(line, sizeof line, "t = %.6g s  %5.1f %%  left %s | %lld particles", time_.value(),
        100*share, duration(clock_.elapsed()*(1 - share)/max(share, 1e-9)).c_str(), state.total);
    std::string text = line;
    for (const auto& note : state.notes)
    {
        text += " | " + note.first + ' ' + note.second;
    }
    std::snprintf(line, sizeof line, " | dt %.3g s (%s, %ld DEM steps)", time_.deltaTValue(),
        powder_.bindingLimit().c_str(), powder_.demSteps());
    text += line;
    if (powder_.hasAir())
    {
        std::snprintf(line, sizeof line, " | air max %.3g m/s, Co %.2f, p iterations %d", air.maxSpeed,
            air.courant, air.pressureIterations);
        text += line;
    }
    if (state.outside)
    {
        text += " | " + std::to_string(state.outside) + " outside the mesh";
    }
    if (state.hidden)
    {
        text += " | " + std::to_string(state.hidden) + " inside a solid";
    }
    if (state.lost)
    {
        text += " | " + std::to_string(state.lost) + " LOST";
    }
    if (state.clippedVolume > 0)
    {
        std::snprintf(line, sizeof line, " | %.2g m3 of powder not seen by the air",
            state.clippedVolume);
        text += line;
    }
    Info<< text.c_str() << endl;

    // Ranks disagree about the wall time; the first one decides for all.
    bool due = clock_.elapsed() > nextTable_;
    Pstream::scatter(due);
    if (due)
    {
        nextTable_ = clock_.elapsed() + tableEvery_;
        table();
    }
}

void RunLog::write()
{
    if (powder_.outputDue())
    {
        writeAll();
    }
}

// The record of the checkpoint comes last: what has it is whole.
void RunLog::writeAll()
{
    powder_.beginCheckpoint();
    {
        StageClock::Scope timed(clock_, Stage::output);
        powder_.writeCloud();
        time_.writeNow();
    }
    powder_.completeCheckpoint();
}

// No checkpoint: the particles may have gone on, or be no numbers.
void RunLog::lastGood()
{
    if (time_.timeIndex() > time_.startTimeIndex())
    {
        powder_.writeCloud();
        time_.writeNow();
        Info<< "The state at " << time_.value() << " s was written before stopping. It is there to "
            << "be looked at; a run goes on from an earlier time." << endl;
    }
    table();
}

void RunLog::stopped(const std::string& why)
{
    if (!powder_.outputDue())
    {
        writeAll();
    }
    Info<< "Stopped by " << why.c_str() << " at " << time_.timeName()
        << " s; " << (powder_.writesCheckpoints()
                ? "a checkpoint was written. Set startFrom latestTime to go on."
                : "checkpoints are off, so that the run cannot go on.") << endl;
    table();
}

void RunLog::end()
{
    const StageTimes times = clock_.gather(MPI_COMM_WORLD);
    Info<< nl << "Effects, as they were met:" << nl << effects(times).text(times.wall).c_str();
    table();
    Info<< "End" << nl << endl;
}

// With the time of the air, which is that of many stages.
EffectTable RunLog::effects(const StageTimes& times) const
{
    EffectTable all = powder_.effects();
    if (powder_.hasAir())
    {
        for (const Stage stage : {Stage::exchange, Stage::deposit, Stage::smoothing, Stage::momentum, Stage::pressure})
        {
            all.spend(all.place("air"), times.rows[static_cast<int>(stage)].mean);
        }
    }
    return all;
}

void RunLog::table()
{
    const StageTimes times = clock_.gather(MPI_COMM_WORLD);
    const CoupledPowder::Traffic traffic = powder_.traffic();
    const double memory = returnReduce(peakMemory(), maxOp<double>());
    char line[160];
    std::snprintf(line, sizeof line,
        "    per coupling step: %.1f bytes sent a particle, %.1f messages a rank; memory at most %.0f "
        "MB a rank\n",
        traffic.bytesPerParticle, traffic.messagesPerRank, memory/1e6);
    Info<< nl << times.table().c_str() << line << endl;
    if (Pstream::master())
    {
        json(times, traffic, memory);
    }
}

// Written beside and renamed, so that a kill leaves the old file or the new one.
void RunLog::json(
    const StageTimes& times, const CoupledPowder::Traffic& traffic, double memory) const
{
    nlohmann::ordered_json out;
    out["time"] = time_.value();
    out["endTime"] = time_.endTime().value();
    out["steps"] = time_.timeIndex();
    out["ranks"] = Pstream::nProcs();
    out["particles"] = powder_.state().total;
    out["wallSeconds"] = times.wall;
    for (const StageTimes::Row& row : times.rows)
    {
        out["stages"][row.name] = {{"min", row.min}, {"mean", row.mean}, {"max", row.max}};
    }
    const EffectTable met = effects(times);
    for (const Effect& effect : met.effects())
    {
        nlohmann::ordered_json number; // null before anybody has looked
        if (effect.largest)
        {
            number = *effect.largest;
        }
        out["effects"][effect.key] = {{"on", effect.on}, {"how", effect.how}, {"by", EffectTable::decidedBy(effect)},
            {"number", number}, {"limit", effect.limit}, {"meaning", effect.number}, {"seconds", effect.seconds}};
    }
    out["bytesPerParticleStep"] = traffic.bytesPerParticle;
    out["messagesPerRankStep"] = traffic.messagesPerRank;
    out["travellingShare"] = traffic.travellers;
    out["peakMemoryBytes"] = memory;
    const fileName folder = time_.globalPath()/"postProcessing";
    mkDir(folder);
    {
        std::ofstream file(folder/"time.json.new");
        file << out.dump(2) << '\n';
    }
    mv(folder/"time.json.new", folder/"time.json");
}

} // namespace interstice
