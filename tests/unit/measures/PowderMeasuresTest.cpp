// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/measures/MeasureTest.hpp"

#include "coupling/mesh/measures/DieFlowRate.hpp"
#include "coupling/mesh/measures/ForceNumber.hpp"
#include "coupling/mesh/measures/PowderBalance.hpp"
#include "coupling/mesh/measures/SurfaceSlope.hpp"

#include <cmath>

namespace interstice
{
namespace
{

using Foam::vector;

const std::string die = "die { low (0 0 -0.005); high (0.008 0.008 0); } ";

class SurfaceSlopeTest : public MeasureTest
{
protected:
    /// Slope, R^2 and bins of spheres below a surface z(x), in cells of 0.25 mm.
    template<class Height>
    std::vector<double> slopeUnder(const Height& height, const std::string& keys)
    {
        Spheres spheres;
        for (int n = 0; n < 32*8*20; ++n)
        {
            const vector p =
                2.5e-4*vector(n % 32 + 0.5, 4*(n/32 % 8) + 0.5, n/256 - 19.5);
            const double surface = height(p.x());
            if (p.z() < surface - 2e-4)
            {
                spheres.add(p, 1e-4);
            }
            if (n < 32*8)
            {
                spheres.add({p.x(), p.y(), surface - 1e-4}, 1e-4);
            }
        }
        spheres.show(powder);
        const auto slope = make<SurfaceSlope>(die + keys);
        slope->execute();
        return slope->values();
    }
};

// 14.52 degrees is what the study reports for k = 1.
TEST_F(SurfaceSlopeTest, IsTheAngleOfATiltedPlane)
{
    const double tilt = std::tan(14.52*M_PI/180);
    const auto rising =
        slopeUnder([&](double x) { return -0.003 + tilt*(x - 0.004); }, "bins 8;");
    EXPECT_NEAR(rising[0], 14.52, 1e-6);
    EXPECT_NEAR(rising[1], 1, 1e-9);
    EXPECT_EQ(rising[2], 8);

    const auto against = slopeUnder(
        [&](double x) { return -0.003 + tilt*(x - 0.004); }, "bins 8; direction (-2 0 0);");
    EXPECT_NEAR(against[0], -14.52, 1e-6);
}

// A tent has no slope on the whole, and no line fits it.
TEST_F(SurfaceSlopeTest, SaysByRSquaredThatATentIsNotALine)
{
    const auto tent =
        slopeUnder([](double x) { return -0.002 - 0.5*std::abs(x - 0.004); }, "bins 8;");
    EXPECT_NEAR(tent[0], 0, 1e-6);
    EXPECT_LT(tent[1], 0.01);
}

// By hand, points (0 0) (1 1) (2 3): b = 3/2, a = -1/6, R^2 = 27/28.
TEST(FitLine, MatchesTheHandCalculation)
{
    const Line line = fitLine({0, 1, 2}, {0, 1, 3});
    EXPECT_NEAR(line.slope, 1.5, 1e-12);
    EXPECT_NEAR(line.intercept, -1.0/6, 1e-12);
    EXPECT_NEAR(line.determination, 27.0/28, 1e-12);
    EXPECT_EQ(fitLine({2, 2}, {0, 1}).slope, 0);
    EXPECT_EQ(fitLine({}, {}).slope, 0);
}

TEST_F(SurfaceSlopeTest, SaysWhatIsWrongInItsDictionary)
{
    EXPECT_NE(problemOf([&] { make<SurfaceSlope>(die + "direction (0 0 1);"); })
                  .where.find("direction"),
        std::string::npos);
    EXPECT_NE(
        problemOf([&] { make<SurfaceSlope>(die + "bins 1;"); }).where.find("bins"),
        std::string::npos);
}

class DieFlowRateTest : public MeasureTest
{
protected:
    static constexpr double volume = 4.0/3.0*M_PI*8e-12; // of a sphere of 0.2 mm radius

    void at(int step, double time) { foamTime().setTime(time, step); }
};

// One sphere in each 0.1 ms from 0 to 5 ms, three in each until 10 ms, none after that.
TEST_F(DieFlowRateTest, IsTheMeanOverItsWindow)
{
    const auto rate = make<DieFlowRate>(die + "window 1e-3;");
    Spheres spheres;
    for (int step = 0; step <= 150; ++step)
    {
        at(step, 1e-4*step);
        for (int n = 0; n < (step <= 50 ? 1 : step <= 100 ? 3 : 0); ++n)
        {
            spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
        }
        spheres.show(powder);
        rate->execute();
        const double flow = rate->values()[0]/(volume/1e-4);
        if (step == 40)
        {
            EXPECT_NEAR(flow, 1, 1e-9);
        }
        else if (step == 55)
        {
            EXPECT_NEAR(flow, 2, 1e-9); // half of the window before the change, half after it
        }
        else if (step == 90)
        {
            EXPECT_NEAR(flow, 3, 1e-9);
        }
        else if (step == 150)
        {
            EXPECT_NEAR(flow, 0, 1e-9);
        }
    }
    EXPECT_NEAR(rate->values()[1], 201*volume, 1e-9*volume);
    EXPECT_NEAR(rate->values()[2], 3*volume/1e-4, 1e-6*volume/1e-4);
    EXPECT_GT(rate->values()[3], 0.0059);
    EXPECT_LT(rate->values()[3], 0.0101);
}

// Steps of 0.3 ms do not fit into a window of 1 ms: 1/3 of the step before is in it.
TEST_F(DieFlowRateTest, CutsAStepThatIsHalfInTheWindow)
{
    const auto rate = make<DieFlowRate>(die + "window 1e-3;");
    Spheres spheres;
    const int fallen[] = {1, 1, 4, 1, 1, 1};
    for (int step = 0; step < 6; ++step)
    {
        at(step, 3e-4*step);
        for (int n = 0; n < fallen[step]; ++n)
        {
            spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
        }
        spheres.show(powder);
        rate->execute();
    }
    EXPECT_NEAR(rate->values()[0]/(volume/1e-3), 3 + 4.0/3, 1e-9);
}

// Half of it: what rushes in with the first step must not count as a rate over the whole window.
TEST_F(DieFlowRateTest, KnowsNoMaximumBeforeItsWindowHasPassed)
{
    const auto rate = make<DieFlowRate>(die + "window 1;");
    Spheres spheres;
    for (int step = 0; step < 3; ++step)
    {
        at(step, 1e-4*step);
        spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
        spheres.show(powder);
        rate->execute();
    }
    EXPECT_NEAR(rate->values()[0], volume/1e-4, 1e-6*volume/1e-4);
    EXPECT_EQ(rate->values()[2], 0);
}

class PowderBalanceTest : public MeasureTest
{
};

// Spheres everywhere; the shoe has gone 5 mm. Each one is counted once, whatever the place.
TEST_F(PowderBalanceTest, FindsEverySphereInOnePlace)
{
    Spheres spheres;
    const double one = Spheres::massOf(2e-4);
    for (int n = 0; n < 7; ++n)
    {
        spheres.add(vector(1e-3*n + 5e-4, 0.001, -0.001), 2e-4); // in the die
    }
    for (int n = 0; n < 11; ++n)
    {
        spheres.add(vector(1e-3*n - 7.5e-3, 0.001, 0.001), 2e-4); // in the shoe, now
    }
    spheres.add(vector(-8.5e-3, 0.001, 0.001), 2e-4); // where the shoe was
    spheres.add(vector(0.004, 0.009, -0.001), 2e-4); // beside the die
    spheres.show(powder);
    powder.initialMass = 21*one;
    powder.outside = 2;
    powder.lost = 1;
    powder.momentumRemainder = vector(1, 2, 3);
    powder.stepImpulse = vector(4, 5, 6);
    powder.clippedVolume = 7;
    powder.movedVolume = 8;
    powder.hiddenVolume = 9;
    powder.wallTravel["shoe"] = vector(0.005, 0, 0);

    const auto balance = make<PowderBalance>(
        die + "shoe { low (-0.013 0 0); high (-0.001 0.008 0.03); }");
    balance->execute();
    const std::vector<double>& v = balance->values();
    EXPECT_NEAR(v[0]/one, 7, 1e-12);
    EXPECT_NEAR(v[1]/one, 11, 1e-12);
    EXPECT_NEAR(v[2]/one, 2, 1e-12);
    EXPECT_EQ(v[3], 21*one);
    EXPECT_NEAR(v[4]/one, 1, 1e-12);
    EXPECT_NEAR((v[0] + v[1] + v[2] + v[4])/v[3], 1, 1e-15);
    EXPECT_EQ(std::vector<double>(v.begin() + 5, v.end()),
        (std::vector<double>{20, 2, 1, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

class ForceNumberTest : public MeasureTest
{
};

// Drag of a quarter of the weight in the die and of the weight outside; pressure upwards, as large
// as the drag in the die. By hand: 1/(1/4) = 4, 1/(1/4 + 1/4) = 2; over all, with as many spheres
// here and there: 2/(1/4 + 1) = 1.6 and 2/(1/2 + 1) = 4/3.
TEST_F(ForceNumberTest, IsWeightOverWhatTheAirDoes)
{
    Spheres spheres;
    for (int n = 0; n < 20; ++n)
    {
        spheres.add(vector(0.004, 0.004, n % 2 ? -0.001 : 0.001), 2e-4);
    }
    spheres.show(powder);
    const double weight = Spheres::massOf(2e-4)*9.81;
    powder.gravity = vector(0, 0, -9.81);
    powder.drag.setSize(powder.count);
    powder.pressureForce.setSize(powder.count);
    forAll(powder.drag, i)
    {
        const bool inDie = powder.position[i][2] < 0;
        powder.drag[i] = vector(0, 0, inDie ? 0.25*weight : -weight);
        powder.pressureForce[i] = vector(0, 0, inDie ? 0.25*weight : 0);
    }
    const auto number = make<ForceNumber>(die);
    number->execute();
    const std::vector<double>& v = number->values();
    EXPECT_NEAR(v[0], 4, 1e-12);
    EXPECT_NEAR(v[1], 2, 1e-12);
    EXPECT_EQ(v[2], 10);
    EXPECT_NEAR(v[3], 1.6, 1e-12);
    EXPECT_NEAR(v[4], 4.0/3, 1e-12);
    EXPECT_EQ(v[5], 20);
}

// A sphere of twice the diameter weighs 8 times as much, and its forces count so: with drag
// b on both, sum m W/sum m F = (1 + 64) W/((1 + 8) F).
TEST_F(ForceNumberTest, IsAMeanByMass)
{
    Spheres spheres;
    spheres.add(vector(0.004, 0.004, -0.001), 1e-4);
    spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
    spheres.show(powder);
    powder.drag = Foam::vectorField(powder.count, vector(0, 0, 1));
    powder.pressureForce = Foam::vectorField(powder.count, vector::zero);
    const auto number = make<ForceNumber>(die + "gravity (0 0 -2);");
    number->execute();
    EXPECT_NEAR(number->values()[0], 65.0/9*2*Spheres::massOf(1e-4), 1e-15);
}

TEST_F(ForceNumberTest, IsInfiniteWithoutAirAndNoNumberWithoutPowder)
{
    Spheres spheres;
    spheres.add(vector(0.004, 0.004, 0.001), 1e-4);
    spheres.show(powder);
    powder.gravity = vector(0, 0, -9.81);
    const auto number = make<ForceNumber>(die);
    number->execute();
    EXPECT_TRUE(std::isnan(number->values()[0]));
    EXPECT_TRUE(std::isinf(number->values()[3]));
}

// With the names by which a controlDict finds them.
TEST_F(PowderBalanceTest, IsMadeByName)
{
    for (const char* type : {"fillingRatio", "dieFlowRate", "forceNumber", "surfaceSlope",
             "powderBalance"})
    {
        const std::string keys = std::string("writeToFile off; type ") + type + "; " + die
            + (std::string(type) == "fillingRatio" ? "fullMass 1;" : "")
            + (std::string(type) == "dieFlowRate" ? "window 1;" : "");
        EXPECT_EQ(Foam::functionObject::New("measure", foamTime(), dictionary(keys))->type(), type);
    }
}

TEST(PowderMeasure, AsksForTheSolverWhereThereIsNoPowder)
{
    Foam::fvMesh mesh(Foam::IOobject(Foam::fvMesh::defaultRegion, "0", foamTime()));
    Foam::IStringStream text("writeToFile off; " + die);
    PowderBalance balance("balance", foamTime(), Foam::dictionary(text));
    EXPECT_NE(problemOf([&] { balance.execute(); }).wanted.find("demPimpleFoam"),
        std::string::npos);
}

} // namespace
} // namespace interstice
