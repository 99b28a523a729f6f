// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingTables.hpp"

#include <cmath>
#include <random>

using namespace interstice;
using namespace interstice::test;

namespace
{

LinearFit fitted(const std::vector<FitPoint>& points, const std::vector<std::string>& names = {"x"})
{
    return leastSquares(points, names, "points", "points.csv");
}

// Groups of the size that die filling has, where the constant and the slopes differ by 1e4.
std::vector<FitPoint> onAPlane()
{
    std::vector<FitPoint> points;
    for (const double speed : {55., 68., 82., 110.})
    {
        for (const double density : {2743., 6008., 9273.})
        {
            points.push_back({{speed, density}, 0.003 + 2e-4 * speed - 1e-6 * density, 1e-4});
        }
    }
    return points;
}

} // namespace

// By hand: sum of squares 2.4 over 3 degrees; sum (x - 3)^2 = 10.
TEST(LinearFit, MatchesTheHandCalculation)
{
    const LinearFit fit =
        fitted({{{1}, 2, {}}, {{2}, 4, {}}, {{3}, 5, {}}, {{4}, 4, {}}, {{5}, 5, {}}});

    EXPECT_NEAR(fit.coefficients(0), 2.2, 1e-14);
    EXPECT_NEAR(fit.coefficients(1), 0.6, 1e-14);
    EXPECT_NEAR(fit.rSquared, 0.6, 1e-14);
    EXPECT_NEAR(fit.chiSquare, 0.8, 1e-14);
    EXPECT_NEAR(fit.scatter, std::sqrt(0.8), 1e-14);
    EXPECT_NEAR(fit.covariance(0, 0), 0.8 * (1. / 5 + 9. / 10), 1e-14);
    EXPECT_NEAR(fit.covariance(1, 1), 0.08, 1e-14);
    EXPECT_NEAR(fit.covariance(0, 1), -0.24, 1e-14);
    EXPECT_EQ(fit.degreesOfFreedom(), 3);
    EXPECT_FALSE(fit.weighted);
}

// By hand at x = 5: plane 5.2, variance 0.8 (1/5 + 4/10) = 0.48; t(3) = 3.18245.
TEST(LinearFit, HasTheIntervalsOfTheHandCalculation)
{
    const LinearFit fit =
        fitted({{{1}, 2, {}}, {{2}, 4, {}}, {{3}, 5, {}}, {{4}, 4, {}}, {{5}, 5, {}}});

    EXPECT_NEAR(fit.confidence({5}).low, 5.2 - 3.182446 * std::sqrt(0.48), 1e-5);
    EXPECT_NEAR(fit.confidence({5}).high, 5.2 + 3.182446 * std::sqrt(0.48), 1e-5);
    EXPECT_NEAR(fit.prediction({5}).high, 5.2 + 3.182446 * std::sqrt(1.28), 1e-5);
}

// By hand: weights 1, 4, 1; mean 2, slope 0, S = 4 + 4 + 4.
TEST(LinearFit, WeighsByTheErrorsOfThePoints)
{
    const LinearFit fit = fitted({{{-1}, 0, 1}, {{0}, 3, 0.5}, {{1}, 0, 1}});

    EXPECT_TRUE(fit.weighted);
    EXPECT_NEAR(fit.coefficients(0), 2, 1e-14);
    EXPECT_NEAR(fit.coefficients(1), 0, 1e-14);
    EXPECT_NEAR(fit.chiSquare, 12, 1e-13);
    EXPECT_NEAR(fit.covariance(0, 0), 2, 1e-13);
    EXPECT_NEAR(fit.covariance(1, 1), 6, 1e-13);
    EXPECT_NEAR(fit.scatter, std::sqrt(6.), 1e-13);
}

TEST(LinearFit, IsNotWeightedUnlessEveryErrorIsKnownAndPositive)
{
    EXPECT_FALSE(fitted({{{-1}, 0, 1}, {{0}, 3, {}}, {{1}, 0, 1}}).weighted);
    EXPECT_FALSE(fitted({{{-1}, 0, 1}, {{0}, 3, 0.0}, {{1}, 0, 1}}).weighted);
    EXPECT_NEAR(fitted({{{-1}, 0, 1}, {{0}, 3, 0.0}, {{1}, 0, 1}}).coefficients(0), 1, 1e-14);
}

TEST(LinearFit, RecoversAPlaneToRoundOff)
{
    const LinearFit fit = fitted(onAPlane(), {"N_v", "rho_p/rho_g"});

    EXPECT_NEAR(fit.coefficients(0) / 0.003, 1, 1e-11);
    EXPECT_NEAR(fit.coefficients(1) / 2e-4, 1, 1e-11);
    EXPECT_NEAR(fit.coefficients(2) / -1e-6, 1, 1e-11);
    EXPECT_NEAR(fit.rSquared, 1, 1e-14);
    EXPECT_LT(fit.scatter, 1e-15);
}

// The normal equations, solved directly in long double, say the same.
TEST(LinearFit, HasTheCovarianceOfTheNormalEquations)
{
    std::vector<FitPoint> points = onAPlane();
    std::mt19937 random(1);
    std::normal_distribution<double> scatter(0, 1);
    for (FitPoint& point : points)
    {
        point.error = 1e-4 * (1 + 0.5 * std::abs(scatter(random)));
        point.y += *point.error * scatter(random);
    }
    const LinearFit fit = fitted(points, {"N_v", "rho_p/rho_g"});

    using Matrix = Eigen::Matrix<long double, 3, 3>;
    Matrix normal = Matrix::Zero();
    for (const FitPoint& point : points)
    {
        const Eigen::Matrix<long double, 3, 1> row(1, point.x[0], point.x[1]);
        normal += row * row.transpose() / (*point.error * *point.error);
    }
    const Matrix product = normal * fit.covariance.cast<long double>() / fit.chiSquare;
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(static_cast<double>(product(i, i)), 1, 1e-9) << i;
    }
    EXPECT_NEAR(fit.errorAt({70, 5000}),
        std::sqrt(Eigen::Vector3d(1, 70, 5000).dot(fit.covariance * Eigen::Vector3d(1, 70, 5000))),
        1e-15);
}

TEST(LinearFit, SaysHowManyPointsItLacks)
{
    const std::string message = messageOf([] { fitted({{{1}, 2, {}}, {{2}, 4, {}}}); });
    expectSays(message, {"too few points", "2 for 2 coefficients", "at least 3", "points.csv"});
}

TEST(LinearFit, NamesTheGroupThatDoesNotVary)
{
    std::vector<FitPoint> points = onAPlane();
    for (FitPoint& point : points)
    {
        point.x[1] = 6008;
    }
    const std::string message = messageOf([&] { fitted(points, {"N_v", "rho_p/rho_g"}); });
    expectSays(message, {"rho_p/rho_g does not vary", "6008", "points.csv"});
    EXPECT_EQ(message.find("N_v"), std::string::npos) << message;
}

// Series measured along a diagonal only: fast with heavy, slow with light powder.
TEST(LinearFit, NamesTheGroupsThatVaryOnlyTogether)
{
    std::vector<FitPoint> points = onAPlane();
    for (FitPoint& point : points)
    {
        point.x = {point.x[1], point.x[0], 100 * point.x[0] + 7};
    }
    const std::string message = messageOf([&] { fitted(points, {"a", "b", "c"}); });
    expectSays(message, {": b and c vary only together", "change one of them alone"});
}

TEST(LinearFit, ExplainsNothingWhereNothingVaries)
{
    EXPECT_EQ(fitted({{{1}, 2, {}}, {{2}, 2, {}}, {{3}, 2, {}}}).rSquared, 0);
}
