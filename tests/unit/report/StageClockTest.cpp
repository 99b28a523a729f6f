// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/report/StageClock.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

namespace interstice
{
namespace
{

void wait(double seconds)
{
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

const StageTimes::Row& rowOf(const StageTimes& times, Stage stage)
{
    return times.rows[static_cast<int>(stage)];
}

double sumOfMeans(const StageTimes& times)
{
    double sum = 0;
    for (const StageTimes::Row& row : times.rows)
    {
        sum += row.mean;
    }
    return sum;
}

int thisRank()
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

int ranks()
{
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

// Sleeping lasts at least as long as asked, and on a busy machine longer: so lower bounds are
// sharp here, and upper bounds follow from the wall time.
TEST(StageClock, CountsAStageInsideAnotherOneOnce)
{
    StageClock clock;
    {
        const StageClock::Scope outer(clock, Stage::pressure);
        wait(0.02);
        {
            const StageClock::Scope inner(clock, Stage::smoothing);
            wait(0.04);
        }
        wait(0.02);
    }

    const StageTimes times = clock.gather(MPI_COMM_WORLD);

    const double outer = rowOf(times, Stage::pressure).mean;
    const double inner = rowOf(times, Stage::smoothing).mean;
    EXPECT_GE(outer, 0.04);
    EXPECT_GE(inner, 0.04);
    EXPECT_LE(outer, times.wall - 0.04);
    EXPECT_LE(inner, times.wall - 0.04);
}

TEST(StageClock, GivesEverySecondToExactlyOneStage)
{
    StageClock clock;
    wait(0.01);
    {
        const StageClock::Scope dem(clock, Stage::dem);
        wait(0.01);
        {
            const StageClock::Scope exchange(clock, Stage::exchange);
            const StageClock::Scope deposit(clock, Stage::deposit);
            wait(0.01);
        }
    }
    wait(0.01);

    // The clock of one rank: among several, `wall` is that of the slowest.
    const StageTimes times = clock.gather(MPI_COMM_SELF);

    EXPECT_NEAR(sumOfMeans(times), times.wall, 1e-9);
    EXPECT_GE(rowOf(times, Stage::other).mean, 0.02);
}

TEST(StageClock, CountsTheStageItIsInUpToNow)
{
    StageClock clock;
    const StageClock::Scope momentum(clock, Stage::momentum);
    wait(0.02);

    EXPECT_GE(rowOf(clock.gather(MPI_COMM_WORLD), Stage::momentum).min, 0.02);
}

TEST(StageClock, GivesLeastMeanAndMostOverTheRanks)
{
    const double step = 0.02;
    StageClock clock;
    {
        const StageClock::Scope dem(clock, Stage::dem);
        wait(step*(1 + thisRank()));
    }

    const StageTimes times = clock.gather(MPI_COMM_WORLD);

    const StageTimes::Row& dem = rowOf(times, Stage::dem);
    EXPECT_GE(dem.min, step);
    EXPECT_GE(dem.mean, step*(1 + ranks())/2);
    EXPECT_GE(dem.max, step*ranks());
    EXPECT_LE(dem.min, dem.mean*(1 + 1e-12));
    EXPECT_LE(dem.mean, dem.max*(1 + 1e-12));
    EXPECT_LE(dem.max, times.wall);
}

TEST(StageClock, GivesAllRanksTheSameTimes)
{
    StageClock clock;
    wait(0.001*thisRank());
    const StageTimes times = clock.gather(MPI_COMM_WORLD);

    double firstRanksWall = times.wall;
    MPI_Bcast(&firstRanksWall, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);

    EXPECT_EQ(times.wall, firstRanksWall);
}

TEST(StageClock, PrintsEachStageWithItsShareOfTheWallTime)
{
    StageTimes times{};
    const std::array<const char*, 8> names{
        "DEM", "exchange", "deposit", "smoothing", "momentum", "pressure", "output", "other"};
    for (std::size_t s = 0; s < names.size(); ++s)
    {
        times.rows[s] = {names[s], 0, 0, 0};
    }
    times.rows[0] = {"DEM", 1, 2, 3};
    times.wall = 8;

    const std::string table = times.table();

    EXPECT_NE(table.find("DEM                1.00        2.00        3.00   25.0 %"),
        std::string::npos)
        << table;
    for (const char* name : names)
    {
        EXPECT_NE(table.find(name), std::string::npos) << name;
    }
    EXPECT_NE(table.find("wall time"), std::string::npos);
}

TEST(StageClock, PrintsNoShareOfARunThatTookNoTime)
{
    StageTimes times{};
    for (StageTimes::Row& row : times.rows)
    {
        row = {"stage", 0, 0, 0};
    }

    EXPECT_EQ(times.table().find("nan"), std::string::npos);
}

} // namespace
} // namespace interstice
