// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/GidaspowSwitchDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

TEST(GidaspowSwitchDrag, IsErgunInABed)
{
    const Powder powder = powderInAir(60e-6, 7360);
    for (const double voidFraction : {0.36, 0.4, 0.6, 0.79})
    {
        for (const double velocity : {1e-4, 1e-2, 1.0})
        {
            const double found =
                bedPressureGradient(GidaspowSwitchDrag(), powder, voidFraction, velocity);
            const double ergun = ergunPressureGradient(powder, voidFraction, velocity);
            EXPECT_NEAR(found / ergun, 1, 1e-12) << voidFraction << ' ' << velocity;
        }
    }
}

// In creeping flow Wen and Yu's law is Richardson and Zaki's: drag per slip grows with
// alpha_f^-2.65, the pressure force takes one more power, the counter-flow of the gas another.
TEST(GidaspowSwitchDrag, SettlesByRichardsonAndZakiInASuspension)
{
    const Powder creeping = powderInAir(0.1e-6, 3360);
    const GidaspowSwitchDrag law;
    const double alone = terminalVelocity(law, creeping, gravity);
    for (const double voidFraction : {0.8, 0.9, 0.99})
    {
        const double ratio = settlingVelocity(law, creeping, voidFraction, gravity) / alone;
        EXPECT_NEAR(ratio / std::pow(voidFraction, 4.65), 1, 1e-4) << voidFraction;
    }
}

// 200 x 0.2/0.8 = 50 on the side of the bed, 24 x 0.8^-2.65 = 43.3534 on the other.
TEST(GidaspowSwitchDrag, JumpsAtItsSwitch)
{
    EXPECT_NEAR(cdRe(GidaspowSwitchDrag(), airAt(0, 0.8 - 1e-9)), 50, 1e-5);
    EXPECT_NEAR(cdRe(GidaspowSwitchDrag(), airAt(0, 0.8)), 43.3534, 5e-5);
}

// Newton's 0.44 x 2000 for a lone sphere; the viscous branch would give 690.
TEST(GidaspowSwitchDrag, DoesNotFallBelowNewtonsDrag)
{
    EXPECT_NEAR(cdRe(GidaspowSwitchDrag(), airAt(2000, 1)), 880, 1e-9);
}
