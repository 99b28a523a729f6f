// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/LiftForces.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

using Vector = std::array<double, 3>;

constexpr GasAtGrain grain{40e-6, airDensity, airViscosity};
constexpr GasAtGrain sphere{1e-3, airDensity, airViscosity};
constexpr double digits = 1e-4; // of the numbers below, reckoned apart from this code

void expectNear(const Vector& found, const Vector& expected)
{
    const double size = std::hypot(expected[0], expected[1], expected[2]);
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_NEAR(found[d], expected[d], digits*size) << "component " << d;
    }
}

} // namespace

// Air along x, faster with y, has its vorticity along -z. A grain that it overtakes moves to where it is
// faster (Saffman 1965).
TEST(ShearLift, PushesASlowGrainToFasterAir)
{
    expectNear(shearLift(grain, {0.1, 0, 0}, {0, 0, -1700}), {0, 4.87944e-11, 0});
    expectNear(shearLift(grain, {-0.1, 0, 0}, {0, 0, -1700}), {0, -4.87944e-11, 0});
}

// 1.615 mu d |u - v| sqrt(rho d^2 G/mu), where neither slip nor shear has inertia of its own.
TEST(ShearLift, IsSaffmansForSmallReynoldsNumbers)
{
    const Vector lift = shearLift(grain, {1e-5, 0, 0}, {0, 0, -1e-6});
    const double saffman = 1.615*airViscosity*40e-6*1e-5
        *std::sqrt(airDensity*40e-6*40e-6*1e-6/airViscosity);

    EXPECT_NEAR(lift[1]/saffman, 1, digits);
}

TEST(ShearLift, IsMeisForLargeReynoldsNumbers)
{
    expectNear(shearLift(sphere, {0, 0, 1}, {100, 0, 0}), {0, 7.33035e-9, 0});
}

TEST(ShearLift, VanishesWithoutSlipAndWithoutShear)
{
    expectNear(shearLift(grain, {0, 0, 0}, {0, 0, -1700}), {0, 0, 0});
    expectNear(shearLift(grain, {0.1, 0, 0}, {0, 0, 0}), {0, 0, 0});
}

// A ball that flies along x through air at rest and turns from x to y (backspin) is lifted.
TEST(SpinLift, LiftsABallWithBackspin)
{
    expectNear(spinLift(grain, {-1e-3, 0, 0}, {0, 0, 10}), {0, 3.07876e-16, 0});
    expectNear(spinLift(sphere, {-1, 0, 0}, {0, 0, 1000}), {0, 3.04979e-7, 0});
}

TEST(SpinLift, VanishesWithoutSlipAndWithoutSpin)
{
    expectNear(spinLift(grain, {0, 0, 0}, {0, 0, 10}), {0, 0, 0});
    expectNear(spinLift(grain, {0.1, 0, 0}, {0, 0, 0}), {0, 0, 0});
}

TEST(SpinDrag, IsThatOfASlowSphereAndGrowsWithInertia)
{
    EXPECT_NEAR(spinDrag(grain, 10)/3.597802e-18, 1, digits);
    EXPECT_NEAR(spinDrag(sphere, 1000)/6.574208e-14, 1, digits);
}

// Both branches at 32: 12.9 sqrt(32) + 128.4 = 201.37 against 64 pi = 201.06.
TEST(SpinDrag, IsContinuousToItsAuthorsDigits)
{
    const double spin = 32*airViscosity/(airDensity*1e-6);

    EXPECT_NEAR(spinDrag(sphere, 1.0001*spin)/spinDrag(sphere, 0.9999*spin), 1, 2e-3);
}
