// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/SchillerNaumannDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

TEST(SchillerNaumannDrag, TendsToStokesForALoneSphere)
{
    EXPECT_NEAR(overStokes(SchillerNaumannDrag(), airAt(0, 1)), 1, 1e-12);
}

// The standard drag curve of a sphere (Clift, Grace & Weber, Bubbles, Drops and Particles, 1978)
// has 1.087 at Re = 100.
TEST(SchillerNaumannDrag, IsOnTheStandardDragCurve)
{
    EXPECT_NEAR(cdRe(SchillerNaumannDrag(), airAt(100, 1)) / 100, 1.087, 0.01);
}

TEST(SchillerNaumannDrag, DoesNotKnowTheVoidFraction)
{
    EXPECT_DOUBLE_EQ(
        cdRe(SchillerNaumannDrag(), airAt(10, 0.4)), cdRe(SchillerNaumannDrag(), airAt(10, 1)));
}

// 0.44 x 5000.
TEST(SchillerNaumannDrag, IsNewtonsBeyondThousand)
{
    EXPECT_NEAR(cdRe(SchillerNaumannDrag(), airAt(5000, 1)), 2200, 1e-9);
}

// Terminal slips of the settling cases of MFiX (DEM06) and CFDEMcoupling (settlingTestMPI).
TEST(SchillerNaumannDrag, GivesTheTerminalVelocitiesOfOtherCodes)
{
    const SchillerNaumannDrag law;
    const Powder mfix{100e-6, 2000, 1.2, 1.8e-5};
    const Powder cfdem{100e-6, 3000, 10, 1e-4};

    EXPECT_NEAR(terminalVelocity(law, mfix, 9.80665), 0.457402, 1e-6);
    EXPECT_NEAR(terminalVelocity(law, cfdem, gravity), 0.137337, 1e-6);
}
