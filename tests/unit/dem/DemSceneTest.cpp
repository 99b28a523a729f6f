// SPDX-License-Identifier: GPL-3.0-or-later
// What DemEngine tells of a script and its particles.
#include "DemScene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace interstice::test
{

TEST(DemScene, TellsWhatTheScriptDefined)
{
    const auto dem = coupledScene("bed.in");

    EXPECT_TRUE(dem->hasBox() && dem->hasIntegrator());
    EXPECT_FALSE(dem->hasCohesion() || dem->hasRollingFriction());
    EXPECT_TRUE(dem->hasWalls());
    EXPECT_FALSE(coupledScene("cloud.in")->hasWalls());
    EXPECT_EQ(dem->materialProperty("youngsModulus"), std::vector<double>{5e6});
    EXPECT_EQ(dem->materialProperty("coefficientFriction"), std::vector<double>{0.5});
    EXPECT_TRUE(dem->materialProperty("cohesionEnergyDensity").empty());
    dem->command("fix more all property/global cohesionEnergyDensity peratomtypepair 1 1e3");
    dem->command("pair_style gran model hertz tangential history cohesion sjkr2");
    EXPECT_TRUE(dem->hasCohesion() && !dem->hasRollingFriction());
    dem->command("pair_style gran model hertz tangential history rolling_friction cdt");
    EXPECT_TRUE(!dem->hasCohesion() && dem->hasRollingFriction());
    EXPECT_EQ(dem->timeStep(), 1e-5);
    EXPECT_EQ(dem->box().high, (Vector3{0.08, 0.08, 0.08}));
    EXPECT_FALSE(dem->box().periodic[0]);
    EXPECT_TRUE(coupledScene("cloud.in")->box().periodic[0]);
    EXPECT_EQ(dem->meshWalls(), (std::vector<std::string>{"floor", "paddle"}));
}

// 4x4x4 spheres of 4 mm, 2500 kg/m3: 8.3776e-5 kg each.
TEST(DemScene, KnowsTheGravityOfTheScript)
{
    const auto dem = coupledScene("cloud.in", {{"gravity", "9.81"}});
    EXPECT_EQ(dem->gravity(), (Vector3{0, 0, -9.81}));
    dem->command("fix sideways all gravity 2 vector 1 0 0");
    dem->advance(1);
    EXPECT_EQ(dem->gravity(), (Vector3{2, 0, -9.81}));
}

TEST(DemScene, CountsAndMeasuresTheParticlesOfAllRanks)
{
    const auto dem = coupledScene("cloud.in", {{"gravity", "10"}});
    dem->advance(100);

    EXPECT_EQ(dem->particleCount(), 64);
    EXPECT_EQ(dem->particleTypes(), std::vector<bool>{true});
    EXPECT_DOUBLE_EQ(dem->maximumRadius(), 0.002);
    EXPECT_DOUBLE_EQ(dem->minimumRadius(), 0.002);
    EXPECT_NEAR(dem->minimumDensity(), 2500, 1e-9);
    EXPECT_NEAR(dem->maximumSpeed(), 0.01, 1e-15);
    EXPECT_NEAR(dem->quickestParticle()[1], 2500, 1e-9);
    EXPECT_NEAR(everyGrain(*dem).at(7).mass, 8.37758040957278e-5, 1e-18);
}

// Rayleigh's time goes as r sqrt(rho): a grain twice as large and 25 times as light is 2.5 times as quick.
TEST(DemScene, FindsTheQuickestParticle)
{
    const auto dem = coupledScene("cloud.in");
    dem->command("set atom 7 diameter 0.008");
    dem->command("set atom 7 density 100");
    dem->command("set atom 8 diameter 0.002");

    const auto [radius, density] = dem->quickestParticle();

    EXPECT_DOUBLE_EQ(radius, 0.004);
    EXPECT_NEAR(density, 100, 1e-9);
}

TEST(DemScene, StartsWithoutParticles)
{
    const auto dem = coupledScene("empty.in");
    dem->advance(10);

    EXPECT_EQ(dem->particleCount(), 0);
    EXPECT_EQ(dem->particleTypes(), std::vector<bool>{false});
    EXPECT_EQ(dem->maximumSpeed(), 0);
    EXPECT_EQ(dem->maximumRadius(), 0);
    EXPECT_EQ(dem->minimumRadius(), 0);
    EXPECT_TRUE(std::isinf(dem->minimumDensity()));
    EXPECT_EQ(dem->quickestParticle(), (std::array<double, 2>{0, 0}));
}

} // namespace interstice::test
