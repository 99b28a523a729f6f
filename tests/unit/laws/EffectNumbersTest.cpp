// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/EffectNumbers.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

constexpr double atmosphere = 101325;

double near(double found, double expected)
{
    return std::abs(found/expected - 1);
}

} // namespace

// Reckoned apart from this code, for the powders of linear die filling: columns diameter [um], density,
// share of the lift in a shear of 1700/s, history at the particle's own time, mass that goes along.
TEST(EffectNumbers, AreSmallForTheDieFillingPowders)
{
    constexpr double table[][5]{{20, 3360, 0.03697, 0.02285, 1.823e-4},
        {40, 7360, 0.07394, 0.01544, 8.322e-5}, {60, 11360, 0.11091, 0.01243, 5.392e-5}};

    for (const auto& [um, density, lift, history, mass] : table)
    {
        const double d = 1e-6*um;
        const double time = density*d*d/(18*airViscosity);
        EXPECT_LT(near(saffmanShare(d, airDensity, airViscosity, 1700), lift), 1e-3);
        EXPECT_LT(near(historyShare(d, airViscosity/airDensity, time), history), 1e-3);
        EXPECT_LT(near(virtualMassShare(density, airDensity), mass), 1e-3);
    }
    EXPECT_GT(saffmanShare(60e-6, airDensity, airViscosity, 1700), largestLiftShare);
    EXPECT_LT(saffmanShare(40e-6, airDensity, airViscosity, 1700), largestLiftShare);
}

// 40 um spinning at 6568 rad/s: a tenth of a Reynolds number rho d^2 w/mu = 0.72.
TEST(EffectNumbers, TellTheLiftOfSpinByItsReynoldsNumber)
{
    const double spin = 0.72*airViscosity/(airDensity*40e-6*40e-6);

    EXPECT_NEAR(magnusShare(40e-6, airDensity, airViscosity, spin), 0.03, 1e-12);
}

// A bed 10 mm high over a cavity of 5 mm, alpha_p = 0.6: U_mf by Gidaspow-Huilin, its pressure drop the
// net weight; columns diameter [um], density, U_mf [m/s], C.
TEST(EffectNumbers, TellThatTrappedAirSprings)
{
    constexpr double table[][4]{{60, 11360, 0.0159461, 1.27267}, {40, 7360, 0.00459142, 9.94448},
        {20, 3360, 5.23917e-4, 348.530}};

    for (const auto& [um, density, speed, expected] : table)
    {
        const Powder powder = powderInAir(1e-6*um, density);
        const auto law = makeDragLaw("GidaspowHuilin");
        EXPECT_LT(near(minimumFluidisationVelocity(*law, powder, 0.4, gravity), speed), 0.02);
        const double drop = 0.6*(density - airDensity)*gravity*10e-3;
        EXPECT_LT(near(trappedAirNumber(5e-3, atmosphere, speed/drop, 0.6*density*10e-3), expected), 1e-4);
    }
}

// 0.58 of 7360 kg/m3, 10 mm: 418.8 Pa.
TEST(EffectNumbers, TellHowMuchAirABedSqueezesOut)
{
    EXPECT_LT(near(squeezedAirShare(0.58*7360, 10e-3, gravity, atmosphere), 418.8/atmosphere), 1e-3);
}

// A = 1e-19 J, asperities of 0.1 um at 0.4 nm: 10.42 nN; a grain of 40 um, 7360 kg/m3 weighs 2.4195 nN.
TEST(EffectNumbers, TellThatFinePowderSticks)
{
    EXPECT_LT(near(bondNumber(1e-19, 1e-7, 4e-10, 40e-6, 7360, gravity), 10.4167/2.4195), 1e-3);
}

// 1 m/s over 0.6 mm: 49.7 N/m3 against 72.2 kN/m3; 68 nm of mean free path: 0.43 % of the drag on 40 um.
// Dry air of 20 degrees, 101325 Pa, 1.8193e-5 Pa s: 65.43 nm with a factor of 0.4987 in place of 1/2 (S.G. Jennings,
// J. Aerosol Sci. 19 (1988) 159-166). At a tenth of the pressure, ten times as long.
TEST(EffectNumbers, TellHowFarAMoleculeFlies)
{
    constexpr double expected = 65.43e-9*0.4987/0.5;

    EXPECT_LT(near(meanFreePath(1.2042, 1.8193e-5, atmosphere), expected), 1e-3);
    EXPECT_LT(near(meanFreePath(0.12042, 1.8193e-5, 0.1*atmosphere), 10*expected), 1e-3);
}

// Hard-metal powder of 40 um falls at 0.36 m/s by Stokes' law; a shoe of 0.15 m/s is 42 % of that.
TEST(EffectNumbers, TellThatAWallBlowsGrainsAway)
{
    EXPECT_LT(near(stokesDragShare(0.15, 40e-6, airViscosity, 7360, 9.81), 0.4182), 1e-3);
}

TEST(EffectNumbers, TellWhatElseIsSmall)
{
    EXPECT_LT(near(viscousForceShare(airViscosity, 1, 0.6e-3, 7360, gravity), 6.884e-4), 1e-3);
    EXPECT_LT(near(rarefiedShare(40e-6, 68e-9), 4.284e-3), 1e-3);
    EXPECT_LT(near(machNumber(1, 343), 2.915e-3), 1e-3);
}
