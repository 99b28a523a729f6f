// SPDX-License-Identifier: GPL-3.0-or-later
#include "DemScene.hpp"

#include "coupling/laws/InputError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

namespace interstice::test
{

namespace
{

/// The path LIGGGHTS takes in one run of its own.
std::map<int, Grain> uninterrupted(const std::string& name, long steps)
{
    DemEngine alone(MPI_COMM_WORLD, optionsFor());
    alone.runScript(script(name));
    alone.command("run " + std::to_string(steps));
    return everyGrain(alone);
}

int rankHere()
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

} // namespace

// Free fall over 10 steps of 1e-5 s: v = -9.81 * 1e-4.
TEST(DemEngine, OpensRunsTenStepsClosesAndOpensAgain)
{
    for (int round = 0; round < 2; ++round)
    {
        const auto dem = coupledScene("cloud.in", {{"gravity", "9.81"}});
        dem->advance(10);
        EXPECT_NEAR(everyGrain(*dem).at(7).velocity[2], -9.81e-4, 1e-16);
        EXPECT_EQ(dem->stepsDone(), 10);
    }
}

// The whole point of advance(): a set-up between intervals would move the paths apart.
TEST(DemEngine, FollowsOneUninterruptedRunBitForBit)
{
    const auto dem = coupledScene("bed.in");
    dem->advance(1);
    dem->advanceWithoutAir(7);
    for (const long steps : {300L, 42L, 650L})
    {
        dem->advance(steps);
    }
    const auto expected = uninterrupted("bed.in", 1000);

    ASSERT_GT(expected.size(), 500u);
    EXPECT_TRUE(everyGrain(*dem) == expected);
}

// 0.2 m/s for 1000 steps of 1e-5 s; a turn of 0.5 s about (0.04, 0.04): 7.2 degrees, so that
// x_now = R (x - c) + c.
TEST(DemEngine, KnowsThePoseOfMovingWallsOnEveryRank)
{
    const auto dem = coupledScene("bed.in");
    EXPECT_EQ(dem->wallPose("floor").translation, (Vector3{0, 0, 0}));
    dem->advance(1000);

    const WallPose floor = dem->wallPose("floor");
    EXPECT_NEAR(floor.translation[0], 0.002, 1e-14);
    EXPECT_NEAR(floor.rotation[0], 1, 1e-13);
    EXPECT_NEAR(floor.velocity[0], 0.2, 1e-14);
    EXPECT_NEAR(floor.angularVelocity[2], 0, 1e-12);

    const double pi = std::acos(-1.0);
    const double angle = 2*pi*0.01/0.5;
    const WallPose paddle = dem->wallPose("paddle");
    EXPECT_NEAR(paddle.rotation[0], std::cos(angle), 1e-11);
    EXPECT_NEAR(paddle.rotation[1], -std::sin(angle), 1e-11);
    EXPECT_NEAR(paddle.translation[0], 0.04*(1 - std::cos(angle) + std::sin(angle)), 1e-12);
    EXPECT_NEAR(paddle.translation[2], 0, 1e-15);
    EXPECT_NEAR(paddle.angularVelocity[2], 4*pi, 1e-4);
    const Vector3 tip = paddle.velocityAt({0.05, 0.04, 0.0175});
    EXPECT_NEAR(tip[0], 0, 1e-5);
    EXPECT_NEAR(tip[1], 4*pi*0.01, 1e-5);
}

TEST(DemEngine, GivesTheTrianglesOfAWallInTheSameOrderOnAllRanks)
{
    const auto dem = coupledScene("bed.in");
    const std::vector<Triangle> plate = dem->wallTriangles("floor");

    ASSERT_EQ(plate.size(), 32u);
    EXPECT_EQ(plate.front()[0], (Vector3{0.015, 0.015, 0.01}));
    EXPECT_THROW(dem->wallTriangles("flor"), InputError);
}

// Free fall is quadratic in time, which velocity Verlet integrates exactly with any steps:
// 100 * 1e-5 + 100 * 5e-6 = 1.5e-3 s. The plate moves on from where it is.
TEST(DemEngine, ChangesTheTimeStepOnTheWay)
{
    const auto cloud = coupledScene("cloud.in", {{"gravity", "10"}});
    const double before = everyGrain(*cloud).at(7).position[2];
    cloud->advance(100);
    cloud->setTimeStep(5e-6);
    cloud->advance(100);
    EXPECT_EQ(cloud->timeStep(), 5e-6);
    EXPECT_NEAR(everyGrain(*cloud).at(7).velocity[2], -1.5e-2, 1e-15);
    EXPECT_NEAR(everyGrain(*cloud).at(7).position[2] - before, -5*1.5e-3*1.5e-3, 1e-15);

    const auto bed = coupledScene("bed.in");
    bed->advance(400);
    bed->setTimeStep(5e-6);
    bed->advance(400);
    EXPECT_NEAR(bed->wallPose("floor").translation[0], 0.2*6e-3, 1e-14);
    EXPECT_THROW(bed->setTimeStep(0), InputError);

    // The falling heap is where it would be with the first step, within a fraction of the
    // overlap of a contact.
    const auto slower = everyGrain(*bed);
    for (const auto& [id, grain] : uninterrupted("bed.in", 600))
    {
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_NEAR(slower.at(id).position[k], grain.position[k], 4e-6);
        }
    }
}

// x = 0.5 a t^2 of a wall whose speed is a t, whatever set-ups there are on the way: 2e-3 m after 20 ms
// at 10 m/s2. A clock that begins again at a set-up would leave it short.
TEST(DemEngine, KeepsLiggghtsClockThroughSetUps)
{
    const auto dem = coupledScene("bed.in");
    dem->command("unfix slide");
    dem->command("variable none equal 0");
    dem->command("variable speed equal 10*time");
    dem->command("fix slide all move/mesh mesh floor linear/variable v_speed v_none v_none");
    dem->advance(500);
    dem->command("variable nothing equal 1");
    dem->advance(500);
    dem->writeRestart("clock.restart");
    dem->advance(500);
    dem->setTimeStep(5e-6);
    dem->advance(1000);

    EXPECT_NEAR(dem->time(), 0.02, 1e-12);
    EXPECT_NEAR(dem->wallPose("floor").translation[0], 2e-3, 2e-6);
}

// A set-up of LIGGGHTS forgets that walls move; for a step they would stand still.
TEST(DemEngine, KeepsTheWallsMovingThroughASetUp)
{
    const auto dem = coupledScene("bed.in");
    dem->advance(10);
    const WallPose paddle = dem->wallPose("paddle");
    dem->setTimeStep(5e-6);
    EXPECT_NEAR(dem->wallPose("floor").velocity[0], 0.2, 1e-15);
    EXPECT_NEAR(dem->wallPose("paddle").angularVelocity[2], paddle.angularVelocity[2], 1e-9);
}

// A set-up finds contact forces with other velocities than a step does; the path must not tell.
TEST(DemEngine, StaysOnItsPathWhenItWritesARestartFile)
{
    const auto dem = coupledScene("bed.in");
    dem->advance(400);
    dem->writeRestart("path.restart");
    dem->advance(10);

    const auto found = everyGrain(*dem);
    double apart = 0; // of velocities
    for (const auto& [id, grain] : uninterrupted("bed.in", 410))
    {
        for (int k = 0; k < 3; ++k)
        {
            apart = std::max(apart, std::abs(grain.velocity[k] - found.at(id).velocity[k]));
        }
    }
    EXPECT_LT(apart, 1e-12);
}

// Particles that fly through the parts of all ranks, slowed down by air: those that have just left a
// rank when a file is written must keep what pushed them.
TEST(DemEngine, StaysOnItsPathWhenItWritesARestartFileAsParticlesChangeRank)
{
    const auto flown = [](bool writes)
    {
        const auto dem = coupledScene("cloud.in");
        dem->command("velocity all ramp vx 0 3 x 0 0.08 units box");
        dem->command("velocity all ramp vy 0 2 y 0 0.08 units box");
        for (int part = 0; part < 20; ++part)
        {
            for (int i = 0; i < dem->particles().count; ++i)
            {
                const double own = dem->particles().id[i] % 7;
                dem->setGas(i, {{-own, 0, own}, 1e-3, {}});
            }
            dem->advance(100);
            if (writes)
            {
                dem->writeRestart("flown.restart");
            }
        }
        return everyGrain(*dem);
    };
    const auto found = flown(true);
    for (const auto& [id, grain] : flown(false))
    {
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_NEAR(found.at(id).velocity[k], grain.velocity[k], 1e-12);
        }
    }
}

// A run that is resumed counts poses from where the walls began, with LIGGGHTS' clock and step.
TEST(DemEngine, ResumesWallsClockAndDragImpulses)
{
    const auto dem = coupledScene("bed.in");
    dem->advance(200);
    dem->setTimeStep(5e-6);
    dem->advance(100);
    if (dem->particles().count > 0)
    {
        dem->setGas(0, {{1, 2, 3}, 1e-6, {}}, {1e-9, 0, 0});
    }
    dem->advance(100);
    const DemClockAndWalls before = dem->writeRestart("resumed.restart");
    EXPECT_NEAR(dem->wallPose("floor").velocity[0], 0.2, 1e-15);
    std::map<int, Vector3> impulses;
    for (int i = 0; i < dem->particles().count; ++i)
    {
        impulses[dem->particles().id[i]] = dem->impulse(i);
    }
    dem->advance(100);

    DemEngine again(MPI_COMM_WORLD, optionsFor({{"checkpoint", "resumed.restart"}}));
    again.runScript(script("bedFromRestart.in"));
    again.couple(before);
    EXPECT_EQ(again.wallPose("floor").velocity, dem->wallPose("floor").velocity);
    for (int i = 0; i < again.particles().count; ++i)
    {
        EXPECT_EQ(again.impulse(i), impulses[again.particles().id[i]]);
    }
    again.advance(100);

    EXPECT_EQ(again.timeStep(), 5e-6);
    EXPECT_EQ(again.time(), dem->time());
    EXPECT_TRUE(everyGrain(again) == everyGrain(*dem));
    for (const char* wall : {"floor", "paddle"})
    {
        EXPECT_EQ(again.wallPose(wall).translation, dem->wallPose(wall).translation);
        EXPECT_NEAR(again.wallTriangles(wall)[5][1][0], dem->wallTriangles(wall)[5][1][0], 1e-15);
    }
}

TEST(DemEngine, RefusesToResumeWithoutTheCheckpointOrWithOtherWalls)
{
    const auto dem = coupledScene("bed.in");
    dem->advance(10);
    const DemClockAndWalls before = dem->writeRestart("refused.restart");
    {
        DemEngine again(MPI_COMM_WORLD, optionsFor());
        again.runScript(script("bed.in"));
        EXPECT_THROW(again.couple(before), InputError);
    }
    DemClockAndWalls other = before;
    other.walls["floor"].atRest[0][0] -= 1e-3;
    DemEngine again(MPI_COMM_WORLD, optionsFor({{"checkpoint", "refused.restart"}}));
    again.runScript(script("bedFromRestart.in"));
    EXPECT_THROW(again.couple(other), InputError);
}

TEST(DemEngine, NamesAScriptThatIsMissing)
{
    DemEngine dem(MPI_COMM_WORLD, optionsFor());
    try
    {
        dem.runScript("nowhere/fill.in");
        FAIL();
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::string(error.what()).find("nowhere/fill.in"), std::string::npos);
    }
    EXPECT_THROW(dem.readRestart("nowhere/fill.restart"), InputError);
    EXPECT_THROW(dem.couple(), InputError);
}

TEST(DemEngine, AsksForAnIntegrator)
{
    DemEngine dem(MPI_COMM_WORLD, optionsFor());
    dem.runScript(script("empty.in"));
    dem.command("unfix motion");

    EXPECT_FALSE(dem.hasIntegrator());
    EXPECT_THROW(dem.couple(), InputError);
}

TEST(DemEngine, RefusesAFileItCannotWriteAndAVariableItCannotName)
{
    DemOptions options = optionsFor();
    options.logFile = "nowhere/log";
    EXPECT_THROW(DemEngine(MPI_COMM_WORLD, options), InputError);
    EXPECT_THROW(DemEngine(MPI_COMM_WORLD, optionsFor({{"shoe speed", "1"}})), InputError);
}

// A negative value must not be taken for a switch of LIGGGHTS' command line.
TEST(DemEngine, HandsVariablesToTheScript)
{
    const auto dem = coupledScene("cloud.in", {{"gravity", "-10"}, {"dt", "2e-5"}});
    dem->advance(50);

    EXPECT_EQ(dem->timeStep(), 2e-5);
    EXPECT_NEAR(everyGrain(*dem).at(7).velocity[2], 0.01, 1e-15);
}

TEST(DemEngine, KeepsWhatLiggghtsPrints)
{
    {
        coupledScene("bed.in");
    }
    MPI_Barrier(MPI_COMM_WORLD);
    if (rankHere() == 0)
    {
        std::ifstream file("screen.liggghts");
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        EXPECT_NE(text.find("Import and parallelization of mesh floor"), std::string::npos);
    }
}

} // namespace interstice::test
