// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/BedFormulas.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

// Numbers of this file: roots and closed forms found apart from this code, to the digits shown.

// 1 mm, 2000 kg/m3, in a fluid of 10 kg/m3 and 1.5e-4 m2/s, 15.6 mm of bed at 0.451335.
TEST(BedPressureGradient, HasTheDropsOfThePackedBedCase)
{
    const Powder powder{1e-3, 2000, 10, 1.5e-3};
    const double length = 0.0156;
    constexpr double table[][3]{{0.002, 22.992, 22.978}, {0.005, 57.505, 57.469},
        {0.010, 115.091, 115.023}, {0.015, 172.758, 172.660}, {0.020, 230.507, 230.379}};

    const std::unique_ptr<DragLaw> blend = makeDragLaw("GidaspowHuilin");
    for (const auto& [velocity, ergun, blended] : table)
    {
        EXPECT_NEAR(length * ergunPressureGradient(powder, 0.451335, velocity), ergun, 1e-3);
        EXPECT_NEAR(
            length * bedPressureGradient(*blend, powder, 0.451335, velocity), blended, 1e-3);
    }
}

// Columns: diameter in um, then U_mf in mm/s for 3360, 7360, 11360 kg/m3, at 0.4.
TEST(MinimumFluidisation, HasTheVelocitiesOfTheDieFillingPowders)
{
    constexpr double densities[]{3360, 7360, 11360};
    constexpr double table[][4]{
        {20, 0.524, 1.148, 1.772}, {40, 2.095, 4.590, 7.084}, {60, 4.713, 10.322, 15.925}};

    const std::unique_ptr<DragLaw> law = makeDragLaw("GidaspowHuilin");
    for (const auto& row : table)
    {
        for (int i = 0; i < 3; ++i)
        {
            const Powder powder = powderInAir(1e-6 * row[0], densities[i]);
            EXPECT_NEAR(
                1e3 * minimumFluidisationVelocity(*law, powder, 0.4, gravity), row[i + 1], 6e-4)
                << row[0] << " um, " << densities[i];
        }
    }
}

// 0.014509 m/s by Ergun, 0.014517 m/s by the blend; without the pressure force it would be
// 0.03208 m/s.
TEST(MinimumFluidisation, CountsThePressureForce)
{
    const Powder powder{1e-3, 2000, 10, 1.5e-3};
    EXPECT_NEAR(minimumFluidisationVelocity(*makeDragLaw("ErgunWenYu"), powder, 0.451335, gravity),
        0.014509, 1e-6);
    EXPECT_NEAR(
        minimumFluidisationVelocity(*makeDragLaw("GidaspowHuilin"), powder, 0.451335, gravity),
        0.014517, 1e-6);
}

// At U_mf the pressure drop carries the weight that the gas does not: alpha_p (rho_p - rho_f) g.
// In the coarse, over-packed bed the coefficient of Di Felice falls with the slip.
TEST(MinimumFluidisation, IsWhereThePressureDropCarriesTheBed)
{
    constexpr double beds[][2]{{40e-6, 0.4}, {400e-6, 0.25}};
    for (const auto& [diameter, voidFraction] : beds)
    {
        const Powder powder = powderInAir(diameter, 7360);
        const double load = (1 - voidFraction) * (7360 - airDensity) * gravity;
        for (const DragLawEntry& entry : dragLaws())
        {
            const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
            const double velocity =
                minimumFluidisationVelocity(*law, powder, voidFraction, gravity);
            EXPECT_NEAR(bedPressureGradient(*law, powder, voidFraction, velocity) / load, 1, 1e-12)
                << entry.name << ' ' << diameter;
        }
    }
}

// Columns: diameter in um, then m/s for 3360, 7360, 11360 kg/m3.
TEST(TerminalVelocity, HasTheValuesOfTheDieFillingPowders)
{
    constexpr double densities[]{3360, 7360, 11360};
    constexpr double table[][4]{{20, 0.0403, 0.0872, 0.1330}, {30, 0.0885, 0.1882, 0.2838},
        {40, 0.1521, 0.3174, 0.4721}, {50, 0.2283, 0.4667, 0.6848}, {60, 0.3141, 0.6295, 0.9120}};

    const std::unique_ptr<DragLaw> law = makeDragLaw("GidaspowHuilin");
    for (const auto& row : table)
    {
        for (int i = 0; i < 3; ++i)
        {
            const Powder powder = powderInAir(1e-6 * row[0], densities[i]);
            EXPECT_NEAR(terminalVelocity(*law, powder, gravity), row[i + 1], 6e-5)
                << row[0] << " um, " << densities[i];
        }
    }
}

// Settling cases of CFDEMcoupling and of MFiX with the blend.
TEST(TerminalVelocity, HasTheValuesOfOtherCodesCases)
{
    const std::unique_ptr<DragLaw> law = makeDragLaw("GidaspowHuilin");
    EXPECT_NEAR(terminalVelocity(*law, {100e-6, 3000, 10, 1e-4}, gravity), 0.138007, 1e-6);
    EXPECT_NEAR(terminalVelocity(*law, {100e-6, 2000, 1.2, 1.8e-5}, 9.80665), 0.459250, 1e-6);
}

// Over the velocity of a lone grain. Columns: solid fraction, 20 um and 3360 kg/m3, 40 um and
// 7360 kg/m3.
TEST(SettlingVelocity, IsHinderedAsTheBlendSays)
{
    constexpr double table[][3]{{0.01, 0.9548, 0.9576}, {0.05, 0.7894, 0.8008},
        {0.10, 0.6148, 0.6321}, {0.15, 0.4713, 0.4908}, {0.20, 0.3321, 0.3572},
        {0.30, 0.1396, 0.1547}, {0.40, 0.0658, 0.0732}, {0.50, 0.0305, 0.0339}};

    const std::unique_ptr<DragLaw> law = makeDragLaw("GidaspowHuilin");
    const Powder fine = powderInAir(20e-6, 3360);
    const Powder coarse = powderInAir(40e-6, 7360);
    for (const auto& [solid, ofFine, ofCoarse] : table)
    {
        const auto ratio = [&law, voidFraction = 1 - solid](const Powder& powder)
        {
            return settlingVelocity(*law, powder, voidFraction, gravity)
                   / terminalVelocity(*law, powder, gravity);
        };
        EXPECT_NEAR(ratio(fine), ofFine, 6e-5) << solid;
        EXPECT_NEAR(ratio(coarse), ofCoarse, 6e-5) << solid;
    }
}
