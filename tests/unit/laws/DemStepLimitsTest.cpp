// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DemStepLimits.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;

namespace
{

// Parcels of 400 um, 7360 kg/m3, E = 1e8 Pa, nu = 0.3: Rayleigh time 9.39 us; 11.41 us for a dashpot with
// e = 0.5 at 0.5 m/s; an impact on a wall takes 36.55 us at 0.3 m/s, and one of two parcels 2^(-1/5) of that (all
// reckoned apart from this code). The second material is a wall's.
constexpr double radius = 200e-6;
constexpr double density = 7360;
constexpr double soft = 1e8;
constexpr double steel = 2e11;

ContactMaterials powderAndWall(double wall)
{
    ContactMaterials materials;
    materials.youngsModulus = {soft, wall};
    materials.poissonsRatio = {0.3};
    materials.ofParticles = {true, false};
    materials.restitution = 0.5;
    materials.rough = true;
    return materials;
}

DemStepLimits limitsAt(const ContactMaterials& materials, double speed = 0.5)
{
    return demStepLimits(materials, radius, density, speed);
}

} // namespace

TEST(DemStepLimits, AreThoseOfTwoParticlesBesideAWallOfTheirMaterial)
{
    const DemStepLimits limits = limitsAt(powderAndWall(soft));

    EXPECT_NEAR(limits.rayleigh/9.39e-6, 1, 2e-3);
    EXPECT_NEAR(limits.dashpot/11.41e-6, 1, 2e-3);
    EXPECT_NEAR(limitsAt(powderAndWall(soft), 0.3).hertz/(std::pow(2, -0.2)*36.55e-6), 1, 2e-3);
    EXPECT_DOUBLE_EQ(limits.longestStep(), 0.5*limits.rayleigh);
}

// Impacts take as long as Y*^(-2/5), so 2^(-2/5) of it beside steel, however stiff that is.
TEST(DemStepLimits, HardlyFeelHowStiffAWallIs)
{
    const DemStepLimits alike = limitsAt(powderAndWall(soft));
    const DemStepLimits hard = limitsAt(powderAndWall(steel));

    EXPECT_EQ(hard.rayleigh, alike.rayleigh);
    EXPECT_NEAR(hard.hertz/alike.hertz, std::pow(2, -0.4), 1e-3);
    EXPECT_GT(hard.dashpot/alike.dashpot, 0.5);
}

TEST(DemStepLimits, AreThoseOfSteelIfParticlesAreOfIt)
{
    ContactMaterials materials = powderAndWall(steel);
    materials.ofParticles = {false, true};

    EXPECT_NEAR(limitsAt(materials).rayleigh/limitsAt(powderAndWall(soft)).rayleigh,
        std::sqrt(soft/steel), 1e-12);
}

// A smooth contact has no dashpot along the surface, nor has one that gives all back.
TEST(DemStepLimits, HaveNoDashpotWithoutFrictionOrLoss)
{
    ContactMaterials smooth = powderAndWall(soft);
    smooth.rough = false;
    ContactMaterials elastic = powderAndWall(soft);
    elastic.restitution = 1;

    EXPECT_TRUE(std::isinf(limitsAt(smooth).dashpot));
    EXPECT_TRUE(std::isinf(limitsAt(elastic).dashpot));
}

TEST(DemStepLimits, AreInfiniteWithoutParticles)
{
    ContactMaterials walls = powderAndWall(soft);
    walls.ofParticles = {false, false};

    EXPECT_TRUE(std::isinf(limitsAt(walls).longestStep()));
}
