// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingTables.hpp"

using namespace interstice;
using namespace interstice::test;

namespace
{

// Coefficients unlike those of Eq 21.
double otherPlane(const DieFilling& filling)
{
    return 0.4 + 70 * sizeRatio(filling) - 0.008 * shoeReynolds(filling)
           + 5e-5 * densityRatio(filling);
}

double bounded(const DieFilling& filling)
{
    return std::min(std::max(otherPlane(filling), 0.01), 0.995);
}

} // namespace

// With filling ratio s0 + s1 d/h + s2 N + s3 R, the critical size is (0.9 - s0 - s2 N - s3 R)/s1.
TEST(FillingModel, RecoversKnownCoefficientsToRoundOff)
{
    const FillingModel model = fitFillingModel(syntheticTable(otherPlane, 0.01, 13), 0.9).model;

    const Eigen::VectorXd& size = model.criticalSize.fit.coefficients;
    EXPECT_NEAR(size(0) / (0.5 / 70), 1, 1e-11);
    EXPECT_NEAR(size(1) / (0.008 / 70), 1, 1e-11);
    EXPECT_NEAR(size(2) / (-5e-5 / 70), 1, 1e-11);

    ASSERT_TRUE(model.fillingRatio);
    const Eigen::VectorXd& ratio = model.fillingRatio->fit.coefficients;
    EXPECT_NEAR(ratio(0) / 0.4, 1, 1e-11);
    EXPECT_NEAR(ratio(1) / 70, 1, 1e-11);
    EXPECT_NEAR(ratio(2) / -0.008, 1, 1e-11);
    EXPECT_NEAR(ratio(3) / 5e-5, 1, 1e-11);
}

// Empty and full dies are on no plane: with them, the coefficients would be others.
TEST(FillingModel, LeavesSaturatedRowsOutOfThePlaneOfTheFillingRatio)
{
    const ResultsTable table = syntheticTable(bounded, 0.01, 15);
    int below = 0;
    int above = 0;
    for (const Variant& variant : table.variants)
    {
        below += variant.measure < 0.05 ? 1 : 0;
        above += variant.measure > 0.98 ? 1 : 0;
    }
    ASSERT_GT(above, 5);

    const FillingFit fit = fitFillingModel(table, 0.9);
    EXPECT_EQ(fit.rowsBelow, below);
    EXPECT_EQ(fit.rowsAbove, above);
    EXPECT_EQ(fit.ratioPoints.size() + below + above, table.variants.size());
    EXPECT_NEAR(fit.model.fillingRatio->fit.coefficients(1) / 70, 1, 1e-11);
}

// 20 um to 60 um: some series never reach the threshold, and say nothing but a side.
TEST(FillingModel, LeavesSeriesThatDoNotReachTheThresholdOutOfTheFit)
{
    const FillingFit fit = fitFillingModel(syntheticTable(fillingByEq21, 0.01, 5), 0.9);

    int within = 0;
    for (const CriticalSizeRatio& size : fit.critical)
    {
        within += size.crossing == Crossing::within ? 1 : 0;
    }
    EXPECT_EQ(fit.critical.size(), 9u);
    EXPECT_LT(within, 9);
    EXPECT_EQ(static_cast<int>(fit.model.series.size()), within);
    EXPECT_EQ(fit.model.criticalSize.fit.points, within);
    EXPECT_NEAR(fit.model.criticalSize.fit.coefficients(1) / 1.77202e-4, 1, 1e-10);
}

TEST(FillingModel, IsWeightedWhereErrorsAreKnown)
{
    EXPECT_TRUE(
        fitFillingModel(syntheticTable(otherPlane, 0.01, 13), 0.9).model.criticalSize.fit.weighted);
    EXPECT_FALSE(
        fitFillingModel(syntheticTable(otherPlane, {}, 13), 0.9).model.criticalSize.fit.weighted);

    ResultsTable table = syntheticTable(otherPlane, 0.01, 13);
    for (Variant& variant : table.variants)
    {
        variant.error = variant.line < 50 ? variant.error : std::nullopt;
    }
    EXPECT_FALSE(fitFillingModel(table, 0.9).model.criticalSize.fit.weighted);
}

TEST(FillingModel, IsNotWeightedByErrorsFromFewPackingsUnlessTheyAreTrusted)
{
    ResultsTable table = syntheticTable(otherPlane, 0.01, 13);
    for (Variant& variant : table.variants)
    {
        variant.packings = variant.filling.shoeSpeed == 0.1 ? 3 : 20;
    }
    EXPECT_FALSE(fitFillingModel(table, 0.9).model.fillingRatio->fit.weighted);
    for (Variant& variant : table.variants)
    {
        variant.packings = 3;
    }
    EXPECT_FALSE(fitFillingModel(table, 0.9).model.criticalSize.fit.weighted);
    const FillingModel trusted = fitFillingModel(table, 0.9, Errors::trusted).model;
    EXPECT_TRUE(trusted.criticalSize.fit.weighted);
    EXPECT_TRUE(trusted.fillingRatio->fit.weighted);
}

TEST(FillingModel, FollowsTheThreshold)
{
    const FillingModel model = fitFillingModel(syntheticTable(otherPlane, {}, 13), 0.7).model;
    EXPECT_NEAR(model.criticalSize.fit.coefficients(0) / (0.3 / 70), 1, 1e-11);
    EXPECT_EQ(model.threshold, 0.7);
}

TEST(FillingModel, KnowsTheRangeOfItsPoints)
{
    const FillingModel model = fitFillingModel(syntheticTable(otherPlane, {}, 13), 0.9).model;
    const ValidRange& range = model.criticalSize.range;
    EXPECT_NEAR(range[1].low, 54.767, 1e-3);
    EXPECT_NEAR(range[1].high, 82.150, 1e-3);
    EXPECT_NEAR(range[2].low, 5360 / 1.225, 1e-9);
    EXPECT_EQ(range[3].low, 8e-3);
    EXPECT_EQ(range[4].high, 5e-3);
    EXPECT_LT(range[0].low, range[0].high);
}

TEST(FillingModel, RefusesTooFewSeries)
{
    ResultsTable table = syntheticTable(otherPlane, 0.01, 13);
    table.variants.resize(3 * 13);
    expectSays(messageOf([&] { fitFillingModel(table, 0.9); }),
        {"too few series", "3 for 3 coefficients", "at least 4", "synthetic.csv"});
}

TEST(FillingModel, NamesTheGroupThatDoesNotVary)
{
    ResultsTable table = syntheticTable(otherPlane, 0.01, 13);
    for (Variant& variant : table.variants)
    {
        // One density; the four speeds differ, so that series stay apart.
        variant.filling.shoeSpeed += 1e-6 * variant.filling.particleDensity;
        variant.filling.particleDensity = 7360;
        variant.measure = otherPlane(variant.filling);
    }
    const std::string message = messageOf([&] { fitFillingModel(table, 0.9); });
    expectSays(message, {"rho_p/rho_g does not vary", "synthetic.csv"});
}

// One size below and one above, both saturated: critical sizes are known, filling ratios are not.
TEST(FillingModel, DoesWithoutAPlaneOfTheFillingRatioAndSaysWhy)
{
    const auto step = [](const DieFilling& filling)
    { return otherPlane(filling) > 0.9 ? 0.99 : 0.01; };
    const FillingFit fit = fitFillingModel(syntheticTable(step, 0.01, 13), 0.9);
    EXPECT_FALSE(fit.model.fillingRatio);
    expectSays(fit.whyNoFillingRatio, {"too few rows", "0 for 4 coefficients"});
}
