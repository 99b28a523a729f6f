// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "AirFlow.hpp"

namespace interstice
{

/// What the user sees of a run: one line a step, the table of stages at intervals and at the end,
/// and postProcessing/time.json, rewritten at each table, which survives a kill.
class RunLog
{
public:
    RunLog(Foam::Time& time, CoupledPowder& powder, StageClock& clock);

    /// Collective, after each step.
    void step(const AirFlow::Report& air);

    /// Writes fields and particles if it is time. Collective.
    void write();

    /// Writes what is left of a run that failed. Collective.
    void lastGood();

    /// Writes a checkpoint now, and says so. Collective.
    void stopped(const std::string& why);

    /// The last table.
    void end();

private:
    void writeAll();
    EffectTable effects(const StageTimes& times) const;
    void table();
    void json(const StageTimes& times, const CoupledPowder::Traffic& traffic, double memory) const;

    Foam::Time& time_;
    CoupledPowder& powder_;
    StageClock& clock_;
    double tableEvery_; // [s of wall time]
    double nextTable_;
};

} // namespace interstice
