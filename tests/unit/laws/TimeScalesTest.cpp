// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/TimeScales.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

constexpr double pi = 3.14159265358979323846;

// Of the powder of linear die filling, at the start of a slip.
ExchangeScales scales(double diameter, double density, double voidFraction)
{
    const Powder powder = powderInAir(diameter, density);
    const double b =
        makeDragLaw("GidaspowHuilin")->coefficientPerVolume(flowAround(powder, voidFraction, 0));
    return {voidFraction, density, airDensity, b};
}

} // namespace

// E = 1e8 Pa, nu = 0.3; diameter in um, density, factor k, time.
TEST(RayleighTime, HasTheValuesOfTheDieFillingPowders)
{
    constexpr double table[][4]{{20, 3360, 1, 3.17e-7}, {20, 3360, 10, 3.17e-6},
        {40, 7360, 1, 9.39e-7}, {40, 7360, 4, 3.76e-6}, {40, 7360, 10, 9.39e-6},
        {60, 11360, 1, 1.75e-6}, {60, 11360, 10, 1.75e-5}};

    for (const auto& [diameter, density, k, expected] : table)
    {
        const double radius = 0.5e-6 * k * diameter;
        EXPECT_NEAR(rayleighTime(radius, density, 1e8, 0.3) / expected, 1, 2e-3)
            << diameter << ' ' << density << ' ' << k;
    }
}

// A parcel of 400 um, 7360 kg/m3, at 0.3 m/s against a wall of its own material (E = 1e8 Pa,
// nu = 0.3): t = 2.943 delta_max/v with delta_max/d = 0.00931, integrated: 3.655e-5 s.
TEST(HertzTime, IsTheDurationOfAnElasticImpact)
{
    const double radius = 200e-6;
    const double mass = 7360 * 4.0 / 3 * pi * radius * radius * radius;
    const double modulus = 1e8 / (2 * (1 - 0.3 * 0.3));

    EXPECT_NEAR(hertzTime(mass, radius, modulus, 0.3) / 3.655e-5, 1, 2e-3);
}

// Two parcels of 400 um, 7360 kg/m3, E = 1e8 Pa, nu = 0.3 at 5 m/s with e = 0.1: overlap 30.8 um, 2.624 us;
// at 0.5 m/s with e = 0.5: 11.41 us. Reckoned apart from this code.
TEST(TangentialDampingTime, IsShortForHardImpactsThatHardlyBounce)
{
    const double radius = 100e-6; // of the pair
    const double mass = 0.5 * 7360 * 4.0 / 3 * pi * 8 * radius * radius * radius;
    const double modulus = 1e8 / (2 * (1 - 0.3 * 0.3));
    const double shear = 1e8 / (4 * 1.7 * 1.3);

    EXPECT_NEAR(
        tangentialDampingTime(mass, radius, modulus, shear, 0.1, 5) / 2.6237027e-6, 1, 1e-7);
    EXPECT_NEAR(
        tangentialDampingTime(mass, radius, modulus, shear, 0.5, 0.5) / 1.1409377e-5, 1, 1e-7);
}

// Glass (2500) in water at 0.36: 0.711; hard metal (7360) in air: 3e-4.
TEST(DisplacedMassNumber, TellsLightPowderFromHeavy)
{
    EXPECT_NEAR(displacedMassNumber(0.36, 2500, 1000), 0.4 * 0.64 / 0.36, 1e-15);
    EXPECT_LT(displacedMassNumber(0.36, 7360, 1.225), 3e-4);
}

// Columns: diameter in um, density, tau_p, tau_eff, explicit limit, limit with implicit drag in
// ms, at a void fraction of 0.4; derived apart from this code, to the digits shown.
TEST(ExchangeScales, HaveTheValuesOfTheDieFillingPowders)
{
    constexpr double table[][6]{{20, 3360, 0.334, 0.0534, 0.107, 0.157},
        {20, 11360, 1.13, 0.181, 0.361, 0.531}, {40, 7360, 2.93, 0.468, 0.936, 1.38},
        {60, 11360, 10.2, 1.63, 3.25, 4.78}};

    for (const auto& [diameter, density, particle, bed, freezing, implicit] : table)
    {
        const ExchangeScales s = scales(1e-6 * diameter, density, 0.4);
        EXPECT_NEAR(1e3 * s.particleTime() / particle, 1, 6e-3) << diameter << ' ' << density;
        EXPECT_NEAR(1e3 * s.sealedBedTime() / bed, 1, 5e-3) << diameter << ' ' << density;
        EXPECT_NEAR(1e3 * s.explicitLimit() / freezing, 1, 5e-3) << diameter << ' ' << density;
        EXPECT_NEAR(1e3 * s.implicitDragLimit() / implicit, 1, 5e-3) << diameter << ' ' << density;
        EXPECT_NEAR(1e3 * s.recommendedStep() / (0.2 * bed), 1, 5e-3) << diameter << ' ' << density;
    }
}

// 2.00 and 2.94 tau_eff at a void fraction of 0.4.
TEST(ExchangeScales, LimitTheCouplingStepByMultiplesOfTheBedTime)
{
    const ExchangeScales s = scales(40e-6, 7360, 0.4);
    EXPECT_NEAR(1e3 * s.sealedBedTime(), 0.4681, 1e-4);
    EXPECT_NEAR(s.explicitLimit() / s.sealedBedTime(), 2, 1e-12);
    EXPECT_NEAR(s.implicitDragLimit() / s.sealedBedTime(), 2.941, 1e-3);
}

TEST(ExchangeScales, SetNoLimitToImplicitDragInALooseSuspension)
{
    EXPECT_TRUE(std::isfinite(scales(40e-6, 7360, 0.707).implicitDragLimit()));
    EXPECT_TRUE(std::isinf(scales(40e-6, 7360, 0.7072).implicitDragLimit()));
    EXPECT_TRUE(std::isinf(scales(40e-6, 7360, 0.99).implicitDragLimit()));
}

// A tenth of the volume is powder. Air and 40 um, 7360 kg/m3: beta = 2.652e4 kg/m3/s,
// tau = 4.151e-5 s. Water and 1 mm, 2600 kg/m3, at 1e-6 m/s: tau = 0.08494 s.
TEST(ExchangeScales, GiveTheDecayOfTheSlipWhenBothSidesYield)
{
    const ExchangeScales inAir = scales(40e-6, 7360, 0.9);
    EXPECT_NEAR(0.1 * inAir.coefficientPerVolume / 2.652e4, 1, 2e-4);
    EXPECT_NEAR(inAir.mutualTime() / 4.151e-5, 1, 2e-4);

    const Powder inWater{1e-3, 2600, 998, 1e-3};
    const double b =
        makeDragLaw("GidaspowHuilin")->coefficientPerVolume(flowAround(inWater, 0.9, 1e-6));
    EXPECT_NEAR((ExchangeScales{0.9, 2600, 998, b}.mutualTime()) / 0.08494, 1, 2e-4);
}

// Gas inertia is quasi-static in a bed: about 1 us and less.
TEST(ExchangeScales, MakeTheGasInABedFast)
{
    EXPECT_LT(scales(60e-6, 3360, 0.4).gasTime(), 1.1e-6);
    EXPECT_NEAR(scales(40e-6, 7360, 0.4).gasTime(), 0.4 * 1.225 / 1.5094e6, 1e-10);
}

// 10 mm of powder (40 um, 7360 kg/m3, void fraction 0.4) on 5 mm of air: 677 rad/s, 9.3 ms.
TEST(TrappedAirFrequency, IsThatOfAPlugOnAnAirSpring)
{
    const double frequency = trappedAirFrequency(101325, 5e-3, 0.6, 7360, 10e-3);
    EXPECT_NEAR(2 * pi * frequency, 677, 1);
    EXPECT_NEAR(1e3 / frequency, 9.3, 0.05);
}
