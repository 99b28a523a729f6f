// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/RarefiedDrag.hpp"
#include "coupling/laws/drag/StokesDrag.hpp"
#include "coupling/laws/EffectNumbers.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

// Measured on spheres of 0.1 to 0.27 um by J.H. Kim, G.W. Mulholland, S.R. Kukuck & D.Y.H. Pui, J. Res. NIST 110 (2005)
// 31-54: 1 + Kn [1.165 + 0.483 exp(-0.997/Kn)], for Kn of 0.5 to 83.
TEST(CunninghamFactor, AgreesWithMeasurements)
{
    for (const double kn : {0.5, 1.0, 5.0, 20.0, 83.0})
    {
        EXPECT_NEAR(cunninghamFactor(kn)/(1 + kn*(1.165 + 0.483*std::exp(-0.997/kn))), 1, 0.025) << kn;
    }
    EXPECT_EQ(cunninghamFactor(0), 1);
}

// Molecules that meet one another far away only: P.S. Epstein, Phys. Rev. 23 (1924) 710-733, with diffuse reflection
// F = (4 pi/3) r^2 rho c (1 + pi/8) u, and mu = rho c lambda/2: 1.616 Kn. The law's own is 2.6 % above.
TEST(CunninghamFactor, IsEpsteinsInAVacuum)
{
    EXPECT_NEAR(cunninghamFactor(1000)/1616, 1, 0.03);
}

// Of the law by the grain's own size; in air of 1 kPa, where a molecule flies 6.4 um, grains of 40 um lack 29 % of drag.
TEST(RarefiedDrag, DividesAnyLaw)
{
    const LocalFlow flow = airAt(1e-3, 0.6);
    const double path = meanFreePath(airDensity/101.325, airViscosity, 1000);
    const RarefiedDrag stokes(std::make_unique<StokesDrag>(), path);
    const RarefiedDrag blend(makeDragLaw("GidaspowHuilin"), path);

    EXPECT_NEAR(path, 6.45e-6, 0.01e-6);
    EXPECT_NEAR(overStokes(stokes, flow), 0.7094, 1e-3);
    EXPECT_NEAR(overStokes(blend, flow)/overStokes(*makeDragLaw("GidaspowHuilin"), flow), 0.7094, 1e-3);
}
