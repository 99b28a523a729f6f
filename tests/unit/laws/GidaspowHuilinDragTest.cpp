// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/drag/GidaspowHuilinDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>

using namespace interstice;
using namespace interstice::test;

namespace
{

// Eqs 7-11 of Materials 18(14) (2025) 3261, evaluated apart from this code.
struct Row
{
    double voidFraction;
    double blend;
    double dragCoefficient[4];
};

constexpr double reynolds[4]{0.01, 1, 100, 2000};

constexpr Row table[]{
    {1.00, 0.006062, {2400.59, 27.4468, 1.09926, 0.451478}},
    {0.95, 0.008082, {2752.43, 31.3253, 1.22677, 0.493891}},
    {0.90, 0.012120, {3179.98, 36.0164, 1.37916, 0.545613}},
    {0.85, 0.024205, {3708.46, 41.7692, 1.56871, 0.618303}},
    {0.80, 0.500000, {4680.62, 50.6327, 2.29338, 1.49709}},
    {0.70, 0.987880, {8545.07, 87.8169, 3.18008, 2.35700}},
    {0.60, 0.993938, {13311.4, 135.467, 3.66415, 2.39165}},
    {0.50, 0.995958, {19982.6, 202.181, 4.33533, 2.42908}},
    {0.40, 0.996969, {29994.2, 302.308, 5.34101, 2.48233}},
    {0.36, 0.997244, {35559.4, 357.968, 5.90001, 2.51151}},
};

} // namespace

TEST(GidaspowHuilinDrag, GivesThePublishedBlend)
{
    for (const Row& row : table)
    {
        EXPECT_NEAR(GidaspowHuilinDrag().blend(row.voidFraction), row.blend, 5e-7)
            << "void fraction " << row.voidFraction;
    }
}

TEST(GidaspowHuilinDrag, GivesThePublishedDragCoefficients)
{
    const GidaspowHuilinDrag law;
    for (const Row& row : table)
    {
        for (int i = 0; i < 4; ++i)
        {
            const double found = cdRe(law, airAt(reynolds[i], row.voidFraction)) / reynolds[i];
            EXPECT_NEAR(found / row.dragCoefficient[i], 1, 1e-5)
                << "void fraction " << row.voidFraction << ", Re " << reynolds[i];
        }
    }
}

// Limits of C_D Re as Re goes to zero, from the same source.
TEST(GidaspowHuilinDrag, HasTheCreepingLimitAtZeroSlip)
{
    constexpr double limits[][2]{
        {1.0, 23.8545}, {0.9, 31.6147}, {0.8, 46.6767}, {0.6, 133.0883}, {0.4, 299.9155}};

    for (const auto& [voidFraction, limit] : limits)
    {
        const LocalFlow still = airAt(0, voidFraction);
        const double expected = 0.75 * limit * airViscosity / (still.diameter * still.diameter);
        EXPECT_NEAR(GidaspowHuilinDrag().coefficientPerVolume(still) / expected, 1, 2e-6)
            << "void fraction " << voidFraction;
    }
}

TEST(GidaspowHuilinDrag, IsContinuousAcrossTheBlend)
{
    const GidaspowHuilinDrag law;
    for (const double re : reynolds)
    {
        const double below = cdRe(law, airAt(re, 0.8 - 1e-6));
        const double above = cdRe(law, airAt(re, 0.8 + 1e-6));
        EXPECT_NEAR(below / above, 1, 1e-3) << "Re " << re;
    }
}

// 24 (1 + 0.15 x 1^0.687) = 27.6 of Schiller and Naumann; 200 x 0.6/0.4 + 7/3 of Ergun.
TEST(GidaspowHuilinDrag, IsPureAtBothEndsWithTheCleanBlend)
{
    DragOptions options;
    options.cleanBlend = true;
    const GidaspowHuilinDrag law(options);

    EXPECT_DOUBLE_EQ(law.blend(1), 0);
    EXPECT_DOUBLE_EQ(law.blend(0.8), 0.5);
    EXPECT_DOUBLE_EQ(law.blend(0.6), 1);
    EXPECT_DOUBLE_EQ(law.blend(0.4), 1);
    EXPECT_NEAR(cdRe(law, airAt(1, 1)), 27.6, 1e-9);
    EXPECT_NEAR(cdRe(law, airAt(1, 0.4)), 300 + 7.0 / 3, 1e-9);
}

// Ergun's part alone, by hand at alpha_f = 0.5, Re = 6, S = 0.5: 200/0.25 + 7/1.5 x 6 = 828.
TEST(GidaspowHuilinDrag, CountsTheSphericityInErgunsPart)
{
    DragOptions options;
    options.cleanBlend = true;
    options.sphericity = 0.5;

    EXPECT_NEAR(cdRe(GidaspowHuilinDrag(options), airAt(6, 0.5)), 828, 1e-9);
}
