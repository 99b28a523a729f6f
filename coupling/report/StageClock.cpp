// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/report/StageClock.hpp"

#include <cstdio>

namespace interstice
{

namespace
{

constexpr int stages = static_cast<int>(Stage::count);

constexpr std::array<const char*, stages> names{
    "DEM", "exchange", "deposit", "smoothing", "momentum", "pressure", "output", "other"};

} // namespace

StageClock::StageClock()
:
    start_(Clock::now()),
    last_(start_)
{}

Stage StageClock::enter(Stage stage)
{
    const Clock::time_point now = Clock::now();
    seconds_[static_cast<int>(current_)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
    const Stage left = current_;
    current_ = stage;
    return left;
}

double StageClock::elapsed() const
{
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

StageTimes StageClock::gather(MPI_Comm communicator)
{
    enter(current_); // up to now, so that the rows add up to the wall time

    int ranks = 1;
    MPI_Comm_size(communicator, &ranks);
    std::array<double, stages> least{};
    std::array<double, stages> sum{};
    std::array<double, stages> most{};
    MPI_Allreduce(seconds_.data(), least.data(), stages, MPI_DOUBLE, MPI_MIN, communicator);
    MPI_Allreduce(seconds_.data(), sum.data(), stages, MPI_DOUBLE, MPI_SUM, communicator);
    MPI_Allreduce(seconds_.data(), most.data(), stages, MPI_DOUBLE, MPI_MAX, communicator);

    StageTimes times;
    for (int s = 0; s < stages; ++s)
    {
        times.rows[s] = {names[s], least[s], sum[s]/ranks, most[s]};
    }
    times.wall = std::chrono::duration<double>(last_ - start_).count();
    MPI_Allreduce(MPI_IN_PLACE, &times.wall, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return times;
}

std::string StageTimes::table() const
{
    std::string text = "    stage           min [s]    mean [s]     max [s]   share\n";
    char line[96];
    for (const Row& row : rows)
    {
        std::snprintf(line, sizeof line, "    %-10s %12.2f%12.2f%12.2f%7.1f %%\n", row.name,
            row.min, row.mean, row.max, wall > 0 ? 100*row.mean/wall : 0.0);
        text += line;
    }
    std::snprintf(line, sizeof line, "    %-10s %36.2f\n", "wall time", wall);
    return text + line;
}

} // namespace interstice
