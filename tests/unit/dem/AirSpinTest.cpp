// SPDX-License-Identifier: GPL-3.0-or-later
#include "DemScene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace interstice::test
{

namespace
{

constexpr double dt = 1e-5;                         // of cloud.in
constexpr double inertia = 1.3404128655316451e-10; // 2/5 m r^2: 4 mm, 2500 kg/m3

void turn(DemEngine& dem, double coefficient)
{
    for (int i = 0; i < dem.particles().count; ++i)
    {
        dem.setGas(i, {});
        dem.setSpinDrag(i, {0, 50.0*dem.particles().id[i], -20}, coefficient);
    }
}

} // namespace

// I dw/dt = c (w_air - w), whatever the number of steps and intervals and however stiff.
TEST(AirSpin, FollowsTheExponentialOfAFrozenAir)
{
    for (const double stiffness : {1e-9, 1e-3, 0.1, 1.0, 30.0, 1e3})
    {
        for (const long steps : {1L, 2L, 9L})
        {
            DemEngine dem(MPI_COMM_WORLD, optionsFor());
            dem.runScript(script("cloud.in"));
            dem.couple();
            dem.useSpinDrag();
            turn(dem, stiffness*inertia/dt);
            dem.advance(steps);
            turn(dem, stiffness*inertia/dt);
            dem.advance(3);

            const double reached = -std::expm1(-stiffness*static_cast<double>(steps + 3));
            const ParticleView here = dem.particles();
            for (int i = 0; i < here.count; ++i)
            {
                EXPECT_EQ(here.spin[i][0], 0);
                EXPECT_NEAR(here.spin[i][1], 50*here.id[i]*reached, 1e-10*50*here.id[i]*reached);
                EXPECT_NEAR(here.spin[i][2], -20*reached, 1e-10*20*reached);
            }
        }
    }
}

// A set-up between two intervals finds torques anew; what the air had in them must not count twice.
TEST(AirSpin, GoesOnThroughASetUp)
{
    DemEngine dem(MPI_COMM_WORLD, optionsFor());
    dem.runScript(script("cloud.in"));
    dem.couple();
    dem.useSpinDrag();
    const double c = 0.3*inertia/dt;
    for (int interval = 0; interval < 3; ++interval)
    {
        turn(dem, c);
        dem.advance(4);
        dem.writeRestart("spin.restart");
    }

    const ParticleView here = dem.particles();
    for (int i = 0; i < here.count; ++i)
    {
        EXPECT_NEAR(here.spin[i][2], 20*std::expm1(-0.3*12), 1e-9);
    }
}

} // namespace interstice::test
