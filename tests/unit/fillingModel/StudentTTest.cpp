// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fillingModel/StudentT.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace interstice;

// Printed tables, for example Abramowitz & Stegun, Table 26.10.
TEST(StudentT, HasTheQuantilesOfPrintedTables)
{
    EXPECT_NEAR(studentTQuantile(0.975, 1), 12.706, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.975, 2), 4.303, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.975, 3), 3.182, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.975, 10), 2.228, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.975, 30), 2.042, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.975, 120), 1.980, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.995, 5), 4.032, 5e-4);
    EXPECT_NEAR(studentTQuantile(0.95, 20), 1.725, 5e-4);
}

// One degree: Cauchy, tan(pi (p - 1/2)). Two: (2p - 1) sqrt(2/(1 - (2p - 1)^2)).
TEST(StudentT, HasTheClosedFormsOfOneAndTwoDegrees)
{
    for (const double p : {0.51, 0.6, 0.9, 0.975, 0.9999})
    {
        const double one = std::tan(M_PI * (p - 0.5));
        EXPECT_NEAR(studentTQuantile(p, 1) / one, 1, 1e-10) << p;
        const double two = (2 * p - 1) * std::sqrt(2 / (1 - (2 * p - 1) * (2 * p - 1)));
        EXPECT_NEAR(studentTQuantile(p, 2) / two, 1, 1e-10) << p;
    }
}

TEST(StudentT, TendsToTheNormalDistribution)
{
    EXPECT_NEAR(studentTQuantile(0.975, 1e7), 1.959964, 1e-6);
}

TEST(StudentT, IsSymmetricAndTheInverseOfItsProbability)
{
    EXPECT_DOUBLE_EQ(studentTQuantile(0.025, 7), -studentTQuantile(0.975, 7));
    EXPECT_DOUBLE_EQ(studentTProbability(0, 4), 0.5);
    for (const double t : {-30., -2.5, -0.1, 0.3, 1., 8.})
    {
        EXPECT_NEAR(studentTQuantile(studentTProbability(t, 6), 6), t, 1e-8) << t;
    }
}
