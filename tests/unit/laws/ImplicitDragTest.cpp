// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/ImplicitDrag.hpp"

#include <gtest/gtest.h>
#include <cfenv>
#include <cmath>

using namespace interstice;

namespace
{

constexpr double mass = 2.5e-10;
constexpr double timeStep = 1e-5;

double advance(double v, double u, double b, double force, int steps = 1)
{
    const double dt = timeStep / steps;
    const ImplicitDrag drag(b, mass, dt);
    for (int i = 0; i < steps; ++i)
    {
        v += (force + drag.force(u - v, force)) * dt / mass;
    }
    return v;
}

} // namespace

// (1 - 1/e) and (1 - e^-2)/2; the first terms of the series for small x; 1/x for large.
TEST(MeanSlip, HasTheValuesOfTheFormula)
{
    EXPECT_DOUBLE_EQ(meanSlip(0), 1);
    EXPECT_DOUBLE_EQ(meanSlip(1), 0.63212055882855767);
    EXPECT_DOUBLE_EQ(meanSlip(2), 0.43233235838169365);
    EXPECT_DOUBLE_EQ(meanSlip(1e3), 1e-3);
    for (const double x : {1e-4, 1e-6, 1e-9, 1e-12, 1e-15})
    {
        EXPECT_NEAR(meanSlip(x), 1 - x / 2 + x * x / 6 - x * x * x / 24, 3e-16) << x;
    }
}

TEST(MeanSlip, IsFiniteAndFallsEverywhere)
{
    std::feclearexcept(FE_ALL_EXCEPT);
    double last = meanSlip(0);
    for (double x = 1e-18; x < 1e18; x *= 10)
    {
        EXPECT_LE(meanSlip(x), last) << x;
        EXPECT_GT(meanSlip(x), 0) << x;
        last = meanSlip(x);
    }
    EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
}

// v(dt) = v + (1 - exp(-x)) ((u - v) + F/b).
TEST(ImplicitDrag, LandsOnTheExactVelocityInFrozenAir)
{
    const double v = 0.2;
    const double u = -0.5;
    const double force = 3e-9;
    for (const double x : {1e-4, 0.1, 1.0, 10.0, 1e4})
    {
        const double b = x * mass / timeStep;
        const double exact = v + (1 - std::exp(-x)) * (u - v + force / b);
        EXPECT_NEAR(advance(v, u, b, force), exact, 1e-12 * std::abs(exact) + 1e-14) << x;
    }
}

TEST(ImplicitDrag, GivesTheSameInOneStepAsInMany)
{
    const double b = 3 * mass / timeStep;
    EXPECT_NEAR(advance(0.2, -0.5, b, 3e-9, 1), advance(0.2, -0.5, b, 3e-9, 100), 1e-14);
}

TEST(ImplicitDrag, NeverOvershootsTheAir)
{
    for (double x = 1e-6; x < 1e9; x *= 10)
    {
        const double v = advance(1, 0, x * mass / timeStep, 0);
        EXPECT_GE(v, 0) << x;
        EXPECT_LT(v, 1) << x;
    }
}

TEST(ImplicitDrag, LeavesAParticleWithoutDragToTheOtherForce)
{
    EXPECT_DOUBLE_EQ(advance(0.2, -0.5, 0, 3e-9), 0.2 + 3e-9 * timeStep / mass);
}

TEST(ImplicitDrag, OffersTheAirNoMoreThanTheParticleCanTake)
{
    const double inertia = mass / timeStep;
    EXPECT_DOUBLE_EQ(ImplicitDrag(0, mass, timeStep).effectiveCoefficient(), 0);
    EXPECT_NEAR(ImplicitDrag(1e-3 * inertia, mass, timeStep).effectiveCoefficient() / inertia,
        9.995001666e-4, 1e-12);
    EXPECT_NEAR(
        ImplicitDrag(inertia, mass, timeStep).effectiveCoefficient() / inertia, 0.632120559, 1e-9);
    EXPECT_NEAR(
        ImplicitDrag(1e6 * inertia, mass, timeStep).effectiveCoefficient() / inertia, 1, 1e-12);
}
