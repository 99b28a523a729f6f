// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/StokesDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

// Force 3 pi mu d (u - v) over the volume pi d^3/6: B = 18 mu/d^2.
TEST(StokesDrag, GivesStokesForceOnASphere)
{
    const double b = 18 * 1.7894e-5 / (40e-6 * 40e-6);
    EXPECT_NEAR(StokesDrag().coefficientPerVolume(airAt(0, 1)) / b, 1, 1e-12);
    EXPECT_NEAR(StokesDrag().coefficientPerVolume(airAt(50, 0.4)) / b, 1, 1e-12);
}

// (rho_p - rho_f) g d^2/(18 mu) = 2990 x 9.81 x 1e-8/1.8e-3.
TEST(StokesDrag, GivesStokesTerminalVelocity)
{
    const Powder powder{100e-6, 3000, 10, 1e-4};
    EXPECT_NEAR(terminalVelocity(StokesDrag(), powder, gravity), 0.162955, 5e-7);
}
