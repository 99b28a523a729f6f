// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fillingModel/Inversion.hpp"
#include "FillingTables.hpp"

#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

// Eq 21 with a ripple, so that the intervals are not of zero width. `share` of its effect of speed is
// kept, about N_v = 68.
FillingModel rippled(double share = 1)
{
    const auto measure = [&](const DieFilling& filling)
    {
        const double ripple = 0.01 * std::sin(1e3 * filling.shoeSpeed + filling.particleDensity);
        const double taken = (1 - share) * 1.77202e-4 * (shoeReynolds(filling) - 68);
        return fillingByEq21(filling) + 60 * taken + ripple;
    };
    return fitFillingModel(syntheticTable(measure, {}, 12), 0.9).model;
}

double planeAt(const FillingModel& model, const DieFilling& filling)
{
    return model.criticalSize.fit.at(groupsOf(PlaneOf::criticalSize, filling));
}

double errorAt(const FillingModel& model, const DieFilling& filling)
{
    return model.criticalSize.fit.quantile()
           * model.criticalSize.fit.errorAt(groupsOf(PlaneOf::criticalSize, filling));
}

} // namespace

// At the limit, d_p/h_D of the powder is the critical one that the plane predicts.
TEST(Inversion, IsTheInverseOfPrediction)
{
    const FillingModel model = rippled();
    const DieFilling given = studyDie(40e-6, 7000, 0.12);
    for (const Sought sought : {Sought::shoeSpeed, Sought::particleDiameter, Sought::dieDepth})
    {
        const DieFilling at = limitOf(sought, model, given).filling;
        EXPECT_NEAR(sizeRatio(at) / planeAt(model, at), 1, 1e-12) << nameOf(sought);
    }
}

TEST(Inversion, OfOneQuantityIsUndoneByAnother)
{
    const FillingModel model = rippled();
    const DieFilling coarse =
        limitOf(Sought::particleDiameter, model, studyDie(0, 7000, 0.12)).filling;

    EXPECT_NEAR(limitOf(Sought::shoeSpeed, model, coarse).value / 0.12, 1, 1e-12);
    EXPECT_NEAR(limitOf(Sought::dieDepth, model, coarse).value / 5e-3, 1, 1e-12);
}

// By hand from Eq 21 at N_v 54.767, rho_p/rho_g 6008.16: 0.00592.
TEST(Inversion, GivesTheSizeOfEq21)
{
    const FillingModel model = fitFillingModel(syntheticTable(fillingByEq21, {}), 0.9).model;
    const Limit limit = limitOf(Sought::particleDiameter, model, studyDie(0, 7360, 0.1));
    EXPECT_NEAR(limit.value, 5e-3 * 0.00592, 2e-8);
}

TEST(Inversion, SaysOnWhichSideTheDieIsFull)
{
    const FillingModel model = rippled();
    const DieFilling given = studyDie(40e-6, 7000, 0.12);
    for (const Sought sought : {Sought::shoeSpeed, Sought::particleDiameter, Sought::dieDepth})
    {
        const Limit limit = limitOf(sought, model, given);
        double DieFilling::*const member = sought == Sought::shoeSpeed ? &DieFilling::shoeSpeed
                                           : sought == Sought::dieDepth
                                               ? &DieFilling::dieDepth
                                               : &DieFilling::particleDiameter;
        DieFilling smaller = limit.filling;
        smaller.*member *= 0.9;
        EXPECT_EQ(sizeRatio(smaller) > planeAt(model, smaller), limit.largest) << nameOf(sought);
    }
    EXPECT_TRUE(limitOf(Sought::shoeSpeed, model, given).largest);
    EXPECT_FALSE(limitOf(Sought::particleDiameter, model, given).largest);
    EXPECT_TRUE(limitOf(Sought::dieDepth, model, given).largest);
}

// Were fast shoes to fill better, the limit would be the slowest.
TEST(Inversion, TurnsRoundWithTheSignOfTheSpeed)
{
    const FillingModel model = rippled(-0.4);
    ASSERT_LT(model.criticalSize.fit.coefficients(1), 0);
    const DieFilling given =
        limitOf(Sought::particleDiameter, model, studyDie(0, 5360, 0.11)).filling;
    const Limit limit = limitOf(Sought::shoeSpeed, model, given);
    EXPECT_NEAR(limit.value, 0.11, 1e-12);
    EXPECT_FALSE(limit.largest);
}

// Fieller's own definition: at either end the plane is t standard errors from the given size.
TEST(Inversion, EndsTheIntervalOfTheSpeedWhereThePlaneIsTStandardErrorsOff)
{
    const FillingModel model = rippled();
    const DieFilling given = studyDie(40e-6, 7000, 0);
    const Limit limit = limitOf(Sought::shoeSpeed, model, given);

    ASSERT_TRUE(limit.low && limit.high);
    EXPECT_LT(*limit.low, limit.value);
    EXPECT_GT(*limit.high, limit.value);
    for (const double speed : {*limit.low, *limit.high})
    {
        DieFilling end = given;
        end.shoeSpeed = speed;
        EXPECT_NEAR(std::abs(planeAt(model, end) - sizeRatio(end)) / errorAt(model, end), 1, 1e-9);
    }
}

TEST(Inversion, HasTheIntervalOfThePlaneForSizeAndDepth)
{
    const FillingModel model = rippled();
    const DieFilling given = studyDie(40e-6, 7000, 0.12);
    const double low = planeAt(model, given) - errorAt(model, given);
    const double high = planeAt(model, given) + errorAt(model, given);

    const Limit size = limitOf(Sought::particleDiameter, model, given);
    EXPECT_NEAR(*size.low, 5e-3 * low, 1e-15);
    EXPECT_NEAR(*size.high, 5e-3 * high, 1e-15);

    const Limit depth = limitOf(Sought::dieDepth, model, given);
    EXPECT_NEAR(*depth.low, 40e-6 / high, 1e-13);
    EXPECT_NEAR(*depth.high, 40e-6 / low, 1e-13);
}

// No effect of speed in the runs: any speed may be the limit.
TEST(Inversion, HasNoIntervalWhereTheEffectOfSpeedIsNotToldFromZero)
{
    const FillingModel model = rippled(0.001);
    const double slope = model.criticalSize.fit.coefficients(1);
    const DieFilling given = [&]
    {
        DieFilling filling = studyDie(0, 7000, 0.12);
        filling.particleDiameter = 5e-3 * planeAt(model, filling);
        return filling;
    }();
    const Limit limit = limitOf(Sought::shoeSpeed, model, given);
    EXPECT_LT(std::abs(slope),
        model.criticalSize.fit.quantile() * model.criticalSize.fit.standardError(1));
    EXPECT_FALSE(limit.low);
    EXPECT_FALSE(limit.high);
}

TEST(Inversion, RefusesALimitThatIsNotPositive)
{
    const FillingModel model = rippled();
    expectSays(messageOf([&] { limitOf(Sought::shoeSpeed, model, studyDie(1e-6, 1000, 0)); }),
        {"no positive shoeSpeed", "m/s", "synthetic.csv"});
    expectSays(messageOf([&] { limitOf(Sought::particleDiameter, model, studyDie(0, 2e5, 0.1)); }),
        {"no positive particleDiameter"});
    expectSays(messageOf([&] { limitOf(Sought::dieDepth, model, studyDie(1e-5, 2e5, 0.1)); }),
        {"no positive dieDepth"});
}
