// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fillingModel/LeaveOut.hpp"
#include "FillingTables.hpp"

#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

double rippled(const DieFilling& filling)
{
    return fillingByEq21(filling)
           + 0.005 * std::sin(1e3 * filling.shoeSpeed + filling.particleDensity);
}

FillingFit rippledFit(std::optional<double> error)
{
    return fitFillingModel(syntheticTable(rippled, error), 0.9);
}

} // namespace

// Without the point, the plane does not know it: the same as a fit to the others, done here.
TEST(LeaveOut, PredictsEachSeriesFromAFitToTheOthers)
{
    const FillingFit fit = rippledFit(0.01);
    const LeaveOutCheck check = leaveOutEach(PlaneOf::criticalSize, fit.criticalPoints, "");

    ASSERT_EQ(check.points.size(), fit.criticalPoints.size());
    std::vector<PlanePoint> rest = fit.criticalPoints;
    rest.erase(rest.begin() + 2);
    const Plane plane = fitPlane(PlaneOf::criticalSize, rest, "");
    EXPECT_DOUBLE_EQ(check.points[2].predicted, plane.fit.at(fit.criticalPoints[2].fit.x));
    EXPECT_EQ(check.judged(), static_cast<int>(check.points.size()));
    EXPECT_TRUE(check.needed.empty());
}

TEST(LeaveOut, LeavesOutAllRowsOfASeriesAtOnce)
{
    const FillingFit fit = rippledFit(0.01);
    const LeaveOutCheck check = leaveOutEach(PlaneOf::fillingRatio, fit.ratioPoints, "");

    std::vector<PlanePoint> rest;
    for (const PlanePoint& point : fit.ratioPoints)
    {
        if (point.series != fit.ratioPoints[0].series)
        {
            rest.push_back(point);
        }
    }
    const Plane plane = fitPlane(PlaneOf::fillingRatio, rest, "");
    EXPECT_DOUBLE_EQ(check.points[0].predicted, plane.fit.at(fit.ratioPoints[0].fit.x));
}

TEST(LeaveOut, CombinesTheErrorOfThePlaneWithThatOfThePoint)
{
    LinearFit fit = leastSquares({{{-1}, 0, 1}, {{0}, 3, 0.5}, {{1}, 0, 1}}, {"x"}, "", "");
    // Of the hand calculation: variance of the plane at 0 is 2, chi2 12, scatter^2 6.
    EXPECT_NEAR(combinedError(fit, {{0}, 0, 0.5}), std::sqrt(2 + 12 * 0.25), 1e-12);
    EXPECT_NEAR(combinedError(fit, {{0}, 0, {}}), std::sqrt(2. + 6), 1e-12);
    fit.chiSquare = 0.1;
    EXPECT_NEAR(combinedError(fit, {{0}, 0, 0.5}), std::sqrt(2 + 0.25), 1e-12);
    fit.weighted = false;
    EXPECT_NEAR(combinedError(fit, {{0}, 0, 0.5}), std::sqrt(2. + 6), 1e-12);
}

// A series that is wrong by many errors stands out, where it is left out.
TEST(LeaveOut, FindsASeriesThatIsWrong)
{
    FillingFit fit = rippledFit(0.01);
    PlanePoint& wrong = fit.criticalPoints[4];
    wrong.fit.y += 20 * *wrong.fit.error;
    const LeaveOutCheck check = leaveOutEach(PlaneOf::criticalSize, fit.criticalPoints, "");
    EXPECT_GT(check.points[4].deviation(), 5);
    EXPECT_LT(check.within(2), check.judged());
}

TEST(LeaveOut, NamesASeriesWithoutWhichThereIsNoFit)
{
    FillingFit fit = rippledFit({});
    std::vector<PlanePoint> points;
    for (const PlanePoint& point : fit.criticalPoints)
    {
        // Of all densities but one there is a single series.
        if (point.filling.particleDensity == 7360 || points.size() < 1)
        {
            points.push_back(point);
        }
    }
    points.front().series = 42;
    points.push_back(points.back());
    points.back().series = 77;
    points.back().fit.x[0] += 20;
    const LeaveOutCheck check = leaveOutEach(PlaneOf::criticalSize, points, "");
    ASSERT_EQ(check.needed.size(), 1u);
    EXPECT_EQ(check.needed[0], 42);
    EXPECT_EQ(check.judged(), static_cast<int>(points.size()) - 1);
}

TEST(LeaveOut, RefusesWhereTheFitNeedsEverySeries)
{
    std::vector<PlanePoint> points = rippledFit({}).criticalPoints;
    points = {points[0], points[1], points[3], points[4]};
    expectSays(messageOf([&] { leaveOutEach(PlaneOf::criticalSize, points, "runs.csv"); }),
        {"No series can be left out", "4 series", "at least 5", "runs.csv"});
}

TEST(LeaveOut, JudgesAnotherTableOnlyWithinTheRangeOfTheFit)
{
    const FillingFit fit = rippledFit(0.01);
    std::vector<PlanePoint> points = fit.criticalPoints;
    points[0].filling.dieLength = 6e-3;
    const LeaveOutCheck check =
        leaveOutTable(PlaneOf::criticalSize, fit.model.criticalSize, points);
    EXPECT_FALSE(check.points[0].inRange);
    EXPECT_EQ(check.judged(), static_cast<int>(points.size()) - 1);
    EXPECT_DOUBLE_EQ(check.points[1].predicted, fit.model.criticalSize.fit.at(points[1].fit.x));
}
