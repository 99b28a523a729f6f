// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/ErgunWenYuDrag.hpp"
#include "coupling/laws/drag/GidaspowSwitchDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

// The bubbling bed of Goldschmidt, Beetstra & Kuipers (2004) as OpenFOAM's tutorial has it; the
// roots of Ergun's equation for two packings and two viscosities.
TEST(ErgunWenYuDrag, FluidisesTheGoldschmidtBedAtErgunsVelocity)
{
    const ErgunWenYuDrag law;
    const Powder thin{2.5e-3, 2526, 1.2, 1.2e-5};
    const Powder air{2.5e-3, 2526, 1.2, 1.8e-5};

    EXPECT_NEAR(minimumFluidisationVelocity(law, thin, 0.40, gravity), 1.274, 1e-3);
    EXPECT_NEAR(minimumFluidisationVelocity(law, thin, 0.42, gravity), 1.382, 1e-3);
    EXPECT_NEAR(minimumFluidisationVelocity(law, air, 0.40, gravity), 1.228, 1e-3);
    EXPECT_NEAR(minimumFluidisationVelocity(law, air, 0.42, gravity), 1.336, 1e-3);
}

// Schiller and Naumann's curve gives C_D = 0.438288 at Re = 1000, where Newton's 0.44 takes over.
TEST(ErgunWenYuDrag, StepsToNewtonsDragAtThousand)
{
    EXPECT_NEAR(cdRe(ErgunWenYuDrag(), airAt(999.999, 1)), 438.288, 2e-3);
    EXPECT_NEAR(cdRe(ErgunWenYuDrag(), airAt(1000.001, 1)), 440, 2e-3);
}

// Both curves of a sphere's drag cross at Re = 988.9; between there and 1000 the laws differ.
TEST(ErgunWenYuDrag, DiffersFromTheGidaspowSwitchOnlyJustBelowThousand)
{
    for (const double re : {0.0, 1.0, 100.0, 980.0, 1001.0, 1e5})
    {
        for (const double voidFraction : {0.4, 0.79, 1.0})
        {
            const LocalFlow flow = airAt(re, voidFraction);
            EXPECT_DOUBLE_EQ(cdRe(ErgunWenYuDrag(), flow), cdRe(GidaspowSwitchDrag(), flow))
                << re << ' ' << voidFraction;
        }
    }

    const LocalFlow between = airAt(999, 1);
    const double ratio = cdRe(ErgunWenYuDrag(), between) / cdRe(GidaspowSwitchDrag(), between);
    EXPECT_LT(ratio, 1);
    EXPECT_NEAR(ratio, 1, 4e-3);
}
