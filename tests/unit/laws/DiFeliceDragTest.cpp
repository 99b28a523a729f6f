// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/DiFeliceDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

// Dalla Valle's fit gives 4.8^2/24 = 0.96 of Stokes' drag as Re goes to zero.
TEST(DiFeliceDrag, TendsToStokesForALoneSphere)
{
    EXPECT_NEAR(overStokes(DiFeliceDrag(), airAt(0, 1)), 0.96, 1e-5);
}

// By hand at alpha_f Re = 100, alpha_f = 0.6: chi = 3.12638, C_D Re = 123.21, and so
// 0.6^(1 - chi) x 123.21/24 = 15.2114.
TEST(DiFeliceDrag, MatchesTheHandCalculationInADenseBed)
{
    EXPECT_NEAR(overStokes(DiFeliceDrag(), airAt(100 / 0.6, 0.6)), 15.2114, 5e-5);
}

// chi is 3.7 in creeping flow; the least, 3.7 - 0.65 = 3.05, at Re = 10^1.5; 3.7 again beyond.
TEST(DiFeliceDrag, HasTheExponentsOfThePaper)
{
    const DiFeliceDrag law;
    const auto exponent = [&law](double re)
    {
        const double bed = cdRe(law, airAt(re / 0.5, 0.5));
        const double alone = cdRe(law, airAt(re, 1));
        return 1 - std::log(bed / alone) / std::log(0.5);
    };

    EXPECT_NEAR(exponent(1e-9), 3.7, 1e-9);
    EXPECT_NEAR(exponent(std::pow(10, 1.5)), 3.05, 1e-9);
    EXPECT_NEAR(exponent(1e6), 3.7, 1e-4);
}
