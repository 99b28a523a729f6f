// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingTables.hpp"

using namespace interstice;
using namespace interstice::test;

namespace
{

struct Size
{
    double sizeRatio;
    double measure;
    std::optional<double> error;
};

ResultsTable tableOf(const std::vector<Size>& sizes)
{
    ResultsTable table{"runs.csv", "fillingRatioPassed", {}, 0, true};
    for (const Size& size : sizes)
    {
        table.variants.push_back({studyDie(size.sizeRatio * 5e-3, 7360, 0.1), size.measure,
            size.error, 1, static_cast<int>(table.variants.size()) + 2});
    }
    return table;
}

CriticalSizeRatio critical(const std::vector<Size>& sizes, double threshold = 0.9)
{
    const std::vector<Series> series = seriesOf(tableOf(sizes));
    EXPECT_EQ(series.size(), 1u);
    return criticalSizeRatio(series.at(0), threshold);
}

} // namespace

// By hand: w = 2/3, slope 37.5; se = 4/150 sqrt((0.03/3)^2 + (2 0.02/3)^2) = 4/150/60.
TEST(CriticalSizeRatio, MatchesTheHandCalculation)
{
    const CriticalSizeRatio size = critical({{0.006, 0.8, 0.03}, {0.010, 0.95, 0.02}});

    EXPECT_EQ(size.crossing, Crossing::within);
    EXPECT_NEAR(size.value, 0.006 + 0.004 * 2 / 3, 1e-15);
    ASSERT_TRUE(size.error);
    EXPECT_NEAR(*size.error, 4. / 150 / 60, 1e-15);
    EXPECT_EQ(size.falls, 0);
    EXPECT_NEAR(size.filling.particleDiameter, 5e-3 * size.value, 1e-18);
}

TEST(CriticalSizeRatio, InterpolatesBetweenItsNeighboursOnlyWhateverTheOrderOfTheRows)
{
    const CriticalSizeRatio size =
        critical({{0.012, 0.99, {}}, {0.010, 0.95, 0.02}, {0.004, 0.1, {}}, {0.006, 0.8, 0.03}});
    EXPECT_NEAR(size.value, 0.006 + 0.004 * 2 / 3, 1e-15);
    EXPECT_TRUE(size.error);
}

TEST(CriticalSizeRatio, HasAnErrorOnlyIfThoseOfBothNeighboursAreKnown)
{
    EXPECT_FALSE(critical({{0.006, 0.8, {}}, {0.010, 0.95, 0.02}}).error);
    EXPECT_FALSE(critical({{0.006, 0.8, 0.03}, {0.010, 0.95, {}}}).error);
}

TEST(CriticalSizeRatio, IsAtTheSizeThatJustReachesTheThreshold)
{
    const CriticalSizeRatio size = critical({{0.006, 0.8, 0.03}, {0.010, 0.9, 0.02}});
    EXPECT_EQ(size.crossing, Crossing::within);
    EXPECT_NEAR(size.value, 0.010, 1e-17);
    EXPECT_NEAR(*size.error, 0.02 * 0.004 / 0.1, 1e-17);
}

TEST(CriticalSizeRatio, FollowsTheThreshold)
{
    EXPECT_NEAR(critical({{0.006, 0.8, {}}, {0.010, 0.95, {}}}, 0.875).value, 0.008, 1e-15);
}

TEST(CriticalSizeRatio, IsAboveTheCoarsestOrBelowTheFinestIfTheThresholdIsOutside)
{
    const CriticalSizeRatio above = critical({{0.006, 0.5, 0.03}, {0.010, 0.89, 0.02}});
    EXPECT_EQ(above.crossing, Crossing::above);
    EXPECT_EQ(above.value, 0.010);
    EXPECT_FALSE(above.error);

    const CriticalSizeRatio below = critical({{0.006, 0.91, 0.03}, {0.010, 0.99, 0.02}});
    EXPECT_EQ(below.crossing, Crossing::below);
    EXPECT_EQ(below.value, 0.006);

    EXPECT_EQ(critical({{0.006, 0.91, 0.03}}).crossing, Crossing::below);
    EXPECT_EQ(critical({{0.006, 0.81, 0.03}}).crossing, Crossing::above);
}

// 0.91 at 0.006 by chance, 0.89 at 0.008: from 0.009 on all powders fill.
TEST(CriticalSizeRatio, TakesTheLastCrossingAndCountsTheFalls)
{
    const CriticalSizeRatio size =
        critical({{0.004, 0.7, {}}, {0.006, 0.91, {}}, {0.008, 0.89, {}}, {0.010, 0.91, {}}});
    EXPECT_NEAR(size.value, 0.009, 1e-15);
    EXPECT_EQ(size.falls, 1);
}

TEST(CriticalSizeRatio, IsAboveIfTheCoarsestDoesNotFillThoughAFinerOneDid)
{
    const CriticalSizeRatio size = critical({{0.006, 0.95, {}}, {0.010, 0.85, {}}});
    EXPECT_EQ(size.crossing, Crossing::above);
    EXPECT_EQ(size.falls, 1);
}

// A dip that stays on one side of the threshold changes nothing.
TEST(CriticalSizeRatio, DoesNotMindADipOnOneSideOfTheThreshold)
{
    EXPECT_EQ(critical({{0.004, 0.5, {}}, {0.006, 0.4, {}}, {0.010, 0.95, {}}}).falls, 0);
}

// An error is as good as the worse of the two it is made of.
TEST(CriticalSizeRatio, HasTheFewestPackingsOfItsNeighbours)
{
    Series series = seriesOf(tableOf({{0.006, 0.8, 0.03}, {0.010, 0.95, 0.02}})).at(0);
    series.variants[0].packings = 5;
    series.variants[1].packings = 3;
    EXPECT_EQ(criticalSizeRatio(series, 0.9).packings, 3);
    series.variants[1].packings = 0;
    EXPECT_EQ(criticalSizeRatio(series, 0.9).packings, 5);
}

TEST(SeriesOf, GathersWhatDiffersInSizeAloneAndSortsBySpeedWithinDensity)
{
    const std::vector<Series> all = seriesOf(syntheticTable(fillingByEq21, {}));

    ASSERT_EQ(all.size(), 9u);
    for (const Series& series : all)
    {
        EXPECT_EQ(series.variants.size(), 9u);
        for (std::size_t i = 1; i < series.variants.size(); ++i)
        {
            EXPECT_LT(
                sizeRatio(series.variants[i - 1].filling), sizeRatio(series.variants[i].filling));
        }
    }
    EXPECT_EQ(all[0].variants[0].filling.particleDensity, 5360);
    EXPECT_EQ(all[1].variants[0].filling.shoeSpeed, 0.125);
    EXPECT_EQ(all[3].variants[0].filling.particleDensity, 7360);
}

// A die twice as large in a gas half as dense has the same groups.
TEST(SeriesOf, ComparesGroupsNotParameters)
{
    ResultsTable table = tableOf({{0.006, 0.8, {}}, {0.010, 0.95, {}}});
    DieFilling& filling = table.variants[1].filling;
    filling.dieLength *= 2;
    filling.dieDepth *= 2;
    filling.particleDiameter *= 2;
    filling.gasDensity /= 2;
    filling.particleDensity /= 2;
    EXPECT_EQ(seriesOf(table).size(), 1u);

    filling.dieDepth /= 2;
    filling.particleDiameter /= 2;
    EXPECT_EQ(seriesOf(table).size(), 2u);
}

TEST(SeriesOf, RefusesTwoRowsOfOneVariant)
{
    const ResultsTable table = tableOf({{0.006, 0.8, {}}, {0.010, 0.9, {}}, {0.006, 0.82, {}}});
    expectSays(messageOf([&] { seriesOf(table); }), {"same variant", "lines 2 and 4", "runs.csv"});
}
