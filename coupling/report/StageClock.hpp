// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <array>
#include <chrono>
#include <string>

namespace interstice
{

/// What a coupled run spends its time on.
enum class Stage
{
    dem,
    exchange,
    deposit,
    smoothing,
    momentum,
    pressure,
    output,
    other,
    count
};

/// Seconds a stage, over all ranks.
struct StageTimes
{
    struct Row
    {
        const char* name;
        double min;
        double mean;
        double max;
    };
    std::array<Row, static_cast<int>(Stage::count)> rows;
    double wall; ///< since the clock was made, slowest rank [s]

    /// A table for the log: seconds min/mean/max over ranks, and share of the wall time.
    std::string table() const;
};

/// Adds up where the time goes. A stage entered inside another one pauses the outer one, so that
/// every second counts once; time in no stage is `other`.
class StageClock
{
public:
    StageClock();

    /// Seconds spent in a stage are those between construction and destruction.
    class Scope
    {
    public:
        Scope(StageClock& clock, Stage stage)
        :
            clock_(clock),
            outer_(clock.enter(stage))
        {}
        ~Scope() { clock_.enter(outer_); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        StageClock& clock_;
        Stage outer_;
    };

    /// Books seconds measured elsewhere from one stage to another.
    void move(Stage from, Stage to, double seconds)
    {
        seconds_[static_cast<int>(from)] -= seconds;
        seconds_[static_cast<int>(to)] += seconds;
    }

    /// Collective: all ranks get the same times.
    StageTimes gather(MPI_Comm communicator);

    /// Seconds of wall time since construction, this rank.
    double elapsed() const;

private:
    using Clock = std::chrono::steady_clock;

    Stage enter(Stage stage);

    Clock::time_point start_;
    Clock::time_point last_;
    Stage current_ = Stage::other;
    std::array<double, static_cast<int>(Stage::count)> seconds_{};
};

} // namespace interstice
