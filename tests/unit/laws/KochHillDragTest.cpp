// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/KochHillDrag.hpp"
#include "coupling/laws/drag/BeetstraDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

TEST(KochHillDrag, TendsToStokesForALoneSphere)
{
    EXPECT_NEAR(overStokes(KochHillDrag(), airAt(0, 1)), 1, 1e-12);
}

// By hand: F0 = 10 x 0.5/0.5^3 = 40, F3 = 0.0673 + 0.106 + 0.0232/0.5^5 = 0.9157; with a
// superficial Re of 10 the drag is 0.5^2 (40 + 5 x 0.9157) = 11.144625 times Stokes'.
TEST(KochHillDrag, MatchesTheHandCalculationInADenseBed)
{
    EXPECT_NEAR(overStokes(KochHillDrag(), airAt(20, 0.5)), 11.144625, 1e-6);
}

// By hand at alpha_p = 0.2: numerator 1 + 0.948683 - 0.678982 + 3.228 = 4.497701, denominator
// 1 + 0.1362 - 0.3392 + 0.06528 = 0.86228; 0.8^2 x 5.216056 = 3.338276.
TEST(KochHillDrag, MatchesTheHandCalculationInASuspension)
{
    EXPECT_NEAR(overStokes(KochHillDrag(), airAt(0, 0.8)), 3.338276, 2e-6);
}

// Carman's permeability d^2 alpha_f^3/(180 alpha_p^2) of a packed bed.
TEST(KochHillDrag, HasCarmansPermeabilityInADenseBed)
{
    const Powder powder = powderInAir(40e-6, 7360);
    const double voidFraction = 0.4;
    const double permeability = 40e-6 * 40e-6 * 0.064 / (180 * 0.36);
    const double velocity = 1e-9;

    EXPECT_NEAR(bedPressureGradient(KochHillDrag(), powder, voidFraction, velocity) * permeability
                    / (airViscosity * velocity),
        1, 1e-8);
}

// The published branches meet at alpha_p = 0.4 with 18.33 and 18.52.
TEST(KochHillDrag, JumpsByOnePercentWhereItsBranchesMeet)
{
    const KochHillDrag law;
    const double dense = cdRe(law, airAt(0, 0.6 - 1e-9));
    const double dilute = cdRe(law, airAt(0, 0.6 + 1e-9));
    EXPECT_NEAR(dense / dilute, 18.5185 / 18.3277, 1e-4);
}

// Both laws fit simulations of the same creeping flow through random arrays. A wrong power of the
// void fraction in one of them would part them by 20 % and more.
TEST(KochHillDrag, AgreesWithTheOtherLatticeBoltzmannFitInCreepingFlow)
{
    for (const double voidFraction : {0.5, 0.6, 0.7, 0.8, 0.9})
    {
        const LocalFlow flow = airAt(0, voidFraction);
        EXPECT_NEAR(cdRe(KochHillDrag(), flow) / cdRe(BeetstraDrag(), flow), 1, 0.08)
            << voidFraction;
    }
}
