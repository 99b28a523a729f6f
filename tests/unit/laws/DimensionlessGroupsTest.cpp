// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DimensionlessGroups.hpp"

#include <gtest/gtest.h>
#include <cfenv>
#include <cmath>

using namespace interstice;

namespace
{

// The reference case: 40 um, 7360 kg/m3, 0.150 m/s.
DieFilling reference()
{
    return {40e-6, 7360, 1.225, 1.7894e-5, 9.81, 0.15, 8e-3, 5e-3};
}

} // namespace

// 2.8e3 for the finest and lightest, 8.5e5 for the coarsest and heaviest powder of the study:
// all of them below the critical value.
TEST(AirSensitivity, SpansTheRangeOfTheStudy)
{
    DieFilling filling = reference();
    filling.particleDiameter = 20e-6;
    filling.particleDensity = 3360;
    EXPECT_NEAR(airSensitivity(filling), 2.8e3, 50);

    filling.particleDiameter = 60e-6;
    filling.particleDensity = 11360;
    EXPECT_NEAR(airSensitivity(filling), 8.5e5, 5e3);
    EXPECT_LT(airSensitivity(filling), criticalAirSensitivity);
}

// Printed in the study as 68.5 and 82.2.
TEST(ShoeReynolds, HasTheValuesOfTheStudy)
{
    DieFilling filling = reference();
    EXPECT_NEAR(shoeReynolds(filling), 82.15, 5e-3);
    filling.shoeSpeed = 0.125;
    EXPECT_NEAR(shoeReynolds(filling), 68.46, 5e-3);
}

TEST(Ratios, AreThoseOfSizesDensitiesAndForces)
{
    EXPECT_DOUBLE_EQ(sizeRatio(reference()), 0.008);
    EXPECT_NEAR(densityRatio(reference()), 6008.163, 1e-3);
    EXPECT_DOUBLE_EQ(forceNumber(6, 3), 2);
}

// OpenFOAM ends the run at a division by zero.
TEST(ForceNumber, IsInfiniteWithoutDragAndDividesByNoZero)
{
    std::feclearexcept(FE_ALL_EXCEPT);
    const double number = forceNumber(6, 0);
    EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO), 0);
    EXPECT_TRUE(std::isinf(number));
}

// 0.00592 for the study's die at 0.1 m/s and 7360 kg/m3; 0.00349 with 6 mm put for 8 mm.
TEST(FillingModel, GivesTheSizeRatioOf90Percent)
{
    DieFilling filling = reference();
    filling.shoeSpeed = 0.1;
    EXPECT_NEAR(sizeRatioFor90Percent(filling), 0.00592, 5e-6);
    filling.dieLength = 6e-3;
    EXPECT_NEAR(sizeRatioFor90Percent(filling), 0.00349, 5e-6);
}

TEST(FillingModel, IsValidForTheStudy)
{
    DieFilling filling = reference();
    EXPECT_TRUE(outsideFillingModel(filling).empty());

    filling.shoeSpeed = 0.2;
    filling.particleDiameter = 60e-6;
    filling.particleDensity = 11360;
    EXPECT_TRUE(outsideFillingModel(filling).empty());
}

TEST(FillingModel, SaysWhichQuantityLeavesItsRange)
{
    DieFilling filling = reference();
    filling.dieLength = 6e-3;
    filling.shoeSpeed = 0.3;
    const std::vector<std::string> outside = outsideFillingModel(filling);

    ASSERT_EQ(outside.size(), 2u);
    EXPECT_EQ(outside[0], "shoe speed 0.3 m/s, fitted for 0.1 to 0.2");
    EXPECT_EQ(outside[1], "die length 0.006 m, fitted for 0.008");
}
