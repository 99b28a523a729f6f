// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fillingModel/PublishedModel.hpp"
#include "FillingTables.hpp"
#include "solvers/fillingModel/Report.hpp"

using namespace interstice;
using namespace interstice::test;

TEST(PublishedModel, HasTheCoefficientsPrintedInTheStudy)
{
    const std::array<double, 3> coefficients = publishedCoefficients();
    EXPECT_NEAR(coefficients[0] / 0.00256, 1, 1e-12);
    EXPECT_NEAR(coefficients[1] / 1.77202e-4, 1, 1e-12);
    EXPECT_NEAR(coefficients[2] / -1.05607e-6, 1, 1e-12);
}

// A table made of Eq 21 gives its numbers back, as printed: through series, interpolation and fit.
TEST(PublishedModel, IsRecoveredFromATableMadeOfIt)
{
    const FillingModel model = fitFillingModel(syntheticTable(fillingByEq21, 0.01), 0.9).model;
    const Eigen::VectorXd& coefficients = model.criticalSize.fit.coefficients;
    EXPECT_NEAR(coefficients(0) / 0.00256, 1, 1e-10);
    EXPECT_NEAR(coefficients(1) / 1.77202e-4, 1, 1e-10);
    EXPECT_NEAR(coefficients(2) / -1.05607e-6, 1, 1e-10);
    EXPECT_NEAR(model.criticalSize.fit.rSquared, 1, 1e-12);
}

TEST(PublishedModel, TakesOnlySeriesOfItsOwnDieAirAndPowder)
{
    FillingModel model = fitFillingModel(syntheticTable(fillingByEq21, 0.01), 0.9).model;
    model.series.resize(3);
    model.series[1].filling.dieLength = 6e-3;
    for (CriticalSizeRatio& size : model.series)
    {
        size.filling.particleDiameter = 40e-6;
    }
    const std::vector<PublishedSeries> inRange = seriesInPublishedRange(model);
    ASSERT_EQ(inRange.size(), 2u);
    EXPECT_NEAR(inRange[0].measured.value, inRange[0].published, 1e-15);
    EXPECT_NEAR(inRange[0].fitted, inRange[0].published, 1e-15);
    EXPECT_EQ(inRange[0].error, *model.series[0].error);
}

TEST(PublishedModel, TakesTheScatterWhereASeriesHasNoError)
{
    FillingModel model = fitFillingModel(syntheticTable(fillingByEq21, {}), 0.9).model;
    model.criticalSize.fit.scatter = 3e-4;
    EXPECT_EQ(seriesInPublishedRange(model).at(0).error, 3e-4);
}

// Eq 21 is for 90 %: at another threshold the numbers are not to be compared without a word.
TEST(PublishedModel, IsComparedWithAWarningAtAnotherThreshold)
{
    const ResultsTable table = syntheticTable(fillingByEq21, 0.01);
    EXPECT_EQ(publishedReport(fitFillingModel(table, 0.9).model).find("beware"), std::string::npos);
    expectSays(publishedReport(fitFillingModel(table, 0.8).model), {"beware", "0.8", "0.9"});
}
