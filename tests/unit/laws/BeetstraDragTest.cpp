// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/BeetstraDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

TEST(BeetstraDrag, TendsToStokesForALoneSphere)
{
    EXPECT_NEAR(overStokes(BeetstraDrag(), airAt(0, 1)), 1, 1e-12);
}

// By hand at alpha_p = 0.5: 10 x 0.5/0.25 + 0.25 (1 + 1.5 sqrt(0.5)) = 20.515165, and the drag is
// alpha_f times that over Stokes'.
TEST(BeetstraDrag, MatchesTheHandCalculationInCreepingFlow)
{
    EXPECT_NEAR(overStokes(BeetstraDrag(), airAt(0, 0.5)), 0.5 * 20.515165, 1e-6);
}

// As above at a superficial Re of 10, which makes the last denominator 1 + 10^1.5 10^-1.5 = 2:
// 0.413 x 10/6 x (2 + 0.75 + 8.4 x 0.453942)/2 = 2.258804 is added.
TEST(BeetstraDrag, MatchesTheHandCalculationWithInertia)
{
    EXPECT_NEAR(overStokes(BeetstraDrag(), airAt(20, 0.5)), 0.5 * (20.515165 + 2.258804), 2e-6);
}

// By hand for a lone sphere at Re = 100: 1 + 0.413 x 100/24 (1 + 8.4 x 100^-0.343)/(1 + 0.1),
// with 100^-0.343 = 0.206063.
TEST(BeetstraDrag, MatchesTheHandCalculationForALoneSphere)
{
    EXPECT_NEAR(overStokes(BeetstraDrag(), airAt(100, 1)), 5.272249, 1e-6);
}
