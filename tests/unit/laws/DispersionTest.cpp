// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/CounterNoise.hpp"
#include "coupling/laws/Dispersion.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

using namespace interstice;

namespace
{

/// What is linear in the two chances, as weights of them.
struct Weights
{
    explicit Weights(double ratio)
        : kept(LangevinStep(ratio)(1, 0, 0, 0)), first(LangevinStep(ratio)(0, 0, 1, 0)),
          second(LangevinStep(ratio)(0, 0, 0, 1))
    {
    }

    LangevinStep::Result kept, first, second;
};

/// Mean square of the displacement over s T after a number of equal steps from a random start: the variance of the sum of
/// the means, with no chances.
double spread(double ratio, int steps)
{
    const Weights weights(ratio);
    double variance = 1; // of w
    double covariance = 0; // with the displacement
    double square = 0; // of the displacement
    for (int n = 0; n < steps; ++n)
    {
        const double step = ratio*weights.kept.mean; // of the displacement, per w
        const double chance = ratio*weights.first.mean;
        const double rest = ratio*weights.second.mean;
        square += 2*step*covariance + step*step*variance + chance*chance + rest*rest;
        covariance = weights.kept.end*(covariance + step*variance) + weights.first.end*chance;
        variance = weights.kept.end*weights.kept.end*variance + weights.first.end*weights.first.end;
    }
    return square;
}

/// G.I. Taylor, Proc. London Math. Soc. 20 (1922) 196-212: 2 (t/T - 1 + exp(-t/T)).
double taylor(double time)
{
    return time < 1e-3 ? time*time*(1 - time/3) : 2*(time + std::expm1(-time));
}

} // namespace

TEST(LangevinStep, SpreadsAsTaylorFoundWhateverTheStep)
{
    for (const double ratio : {1e-7, 1e-3, 0.0199, 0.0201, 0.5, 1.0, 7.0, 300.0})
    {
        for (const int steps : {1, 2, 50})
        {
            EXPECT_NEAR(spread(ratio, steps)/taylor(ratio*steps), 1, 1e-6) << steps << " steps of " << ratio;
        }
    }
}

TEST(LangevinStep, KeepsItsVariance)
{
    for (const double ratio : {0.0, 1e-9, 0.3, 40.0, HUGE_VAL})
    {
        const Weights weights(ratio);
        EXPECT_NEAR(std::hypot(weights.kept.end, weights.first.end), 1, 1e-12) << ratio;
        EXPECT_EQ(weights.second.end, 0);
    }
}

// dw/dt = -(w - drift)/T without chances: 1 falls to 0.3 + 0.7/e, with a mean of 0.3 + 0.7 (1 - 1/e).
TEST(LangevinStep, TendsToItsDrift)
{
    const LangevinStep::Result found = LangevinStep(1)(1, 0.3, 0, 0);

    EXPECT_NEAR(found.end, 0.557515609, 1e-9);
    EXPECT_NEAR(found.mean, 0.742484391, 1e-9);
}

// k = 1.5 m2/s2 and e = 2 m2/s3: 0.75/2.075 s. A slip of sqrt(3) times s = 1 m/s halves it.
TEST(TurbulentTime, IsOfTheLargeEddies)
{
    EXPECT_NEAR(lagrangianTime(1.5, 2), 0.361445783, 1e-9);
    EXPECT_EQ(lagrangianTime(0, 0), 0);
    EXPECT_NEAR(seenTime(0.4, std::sqrt(3.0), 1), 0.2, 1e-12);
    EXPECT_EQ(seenTime(0.4, 1, 0), 0);
    EXPECT_NEAR(seenTime(0.4, 0, 1e-200), 0.4, 1e-12);
}

// Of neighbours in number and time: none may know of another.
TEST(CounterNoise, IsNormalAndIndependent)
{
    constexpr int count = 200;
    const auto chance = [](int thing, int time)
    {
        CounterNoise noise(thing, time);
        return std::normal_distribution<double>()(noise);
    };
    double mean = 0;
    double square = 0;
    double fourth = 0;
    double things = 0;
    double times = 0;
    for (int i = 1; i <= count; ++i)
    {
        for (int n = 1; n <= count; ++n)
        {
            const double x = chance(i, n);
            mean += x;
            square += x*x;
            fourth += x*x*x*x;
            things += x*chance(i + 1, n);
            times += x*chance(i, n + 1);
        }
    }
    constexpr double samples = count*count;
    constexpr double errors = 4/200.0; // standard errors of a mean of `samples`
    EXPECT_NEAR(mean/samples, 0, errors);
    EXPECT_NEAR(square/samples, 1, errors*std::sqrt(2.0));
    EXPECT_NEAR(fourth/samples, 3, errors*std::sqrt(96.0));
    EXPECT_NEAR(things/samples, 0, errors);
    EXPECT_NEAR(times/samples, 0, errors);
    EXPECT_EQ(chance(7, 9), chance(7, 9));
}
