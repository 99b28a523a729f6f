// SPDX-License-Identifier: GPL-3.0-or-later
#include "DemScene.hpp"

#include <gtest/gtest.h>

namespace interstice::test
{

namespace
{

double mark(int id, int column)
{
    return 10.0*id + column + 0.25;
}

void writeMarks(DemEngine& dem)
{
    dem.useMemory();
    for (int i = 0; i < dem.particles().count; ++i)
    {
        for (int column = 0; column < DemEngine::memorySize; ++column)
        {
            EXPECT_EQ(dem.memory(i)[column], 0);
            dem.memory(i)[column] = mark(dem.particles().id[i], column);
        }
    }
}

void expectMarks(DemEngine& dem, const char* when)
{
    for (int i = 0; i < dem.particles().count; ++i)
    {
        for (int column = 0; column < DemEngine::memorySize; ++column)
        {
            EXPECT_EQ(dem.memory(i)[column], mark(dem.particles().id[i], column)) << when;
        }
    }
}

} // namespace

// Through the parts of all ranks, and set-ups, of which the first after its definition fills what is new by itself.
TEST(ParticleMemory, GoesWithItsParticle)
{
    const auto dem = coupledScene("cloud.in");
    dem->command("velocity all ramp vx 0 3 x 0 0.08 units box");
    dem->command("velocity all ramp vy 0 2 y 0 0.08 units box");
    dem->advance(100);
    writeMarks(*dem);
    for (int part = 0; part < 20; ++part)
    {
        dem->advance(100);
        expectMarks(*dem, "flying");
        dem->writeRestart("memory.restart");
        expectMarks(*dem, "after a set-up");
        dem->useMemory();
        expectMarks(*dem, "asked for again");
    }
}

TEST(ParticleMemory, LiesInRestartFiles)
{
    for (const bool used : {true, false})
    {
        const auto dem = coupledScene("bed.in");
        dem->advance(100);
        if (used)
        {
            writeMarks(*dem);
        }
        const DemClockAndWalls before = dem->writeRestart("memory.restart");

        DemEngine again(MPI_COMM_WORLD, optionsFor({{"checkpoint", "memory.restart"}}));
        again.runScript(script("bedFromRestart.in"));
        again.couple(before);
        if (used)
        {
            again.useMemory();
            expectMarks(again, "read back");
        }
        else
        {
            writeMarks(again);
        }
        again.advance(10);
        expectMarks(again, "gone on");
    }
}

} // namespace interstice::test
