// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudentT.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace interstice
{

namespace
{

// 1/(1 + d_1/(1 + d_2/(1 + ...))) by Lentz's method; fast for x < (a + 1)/(a + b + 2).
double betaFraction(double x, double a, double b)
{
    constexpr double tiny = 1e-300;
    constexpr double precision = 4 * std::numeric_limits<double>::epsilon();
    constexpr int mostTerms = 10000;

    const auto awayFromZero = [](double value) { return std::abs(value) < tiny ? tiny : value; };

    double c = 1;
    double d = 1 / awayFromZero(1 - (a + b) * x / (a + 1));
    double fraction = d;
    const auto append = [&](double term)
    {
        d = 1 / awayFromZero(1 + term * d);
        c = awayFromZero(1 + term / c);
        fraction *= c * d;
        return c * d;
    };
    for (int m = 1; m < mostTerms; ++m)
    {
        append(m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)));
        const double step = append(-(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1)));
        if (std::abs(step - 1) < precision)
        {
            break;
        }
    }
    return fraction;
}

// Regularised incomplete beta function I_x(a, b).
double incompleteBeta(double x, double a, double b)
{
    if (x <= 0 || x >= 1)
    {
        return x <= 0 ? 0 : 1;
    }
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b)
                                  + a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1) / (a + b + 2) ? front * betaFraction(x, a, b) / a
                                     : 1 - front * betaFraction(1 - x, b, a) / b;
}

} // namespace

double studentTProbability(double t, double degreesOfFreedom)
{
    assert(degreesOfFreedom > 0);
    const double x = degreesOfFreedom / (degreesOfFreedom + t * t);
    const double tail = incompleteBeta(x, degreesOfFreedom / 2, 0.5) / 2;
    return t > 0 ? 1 - tail : tail;
}

double studentTQuantile(double probability, double degreesOfFreedom)
{
    assert(probability > 0 && probability < 1);
    if (probability < 0.5)
    {
        return -studentTQuantile(1 - probability, degreesOfFreedom);
    }

    double low = 0;
    double high = 1;
    while (studentTProbability(high, degreesOfFreedom) < probability)
    {
        low = high;
        high *= 2;
    }
    while (high - low > 1e-13 * high)
    {
        const double middle = (low + high) / 2;
        (studentTProbability(middle, degreesOfFreedom) < probability ? low : high) = middle;
    }
    return high;
}

} // namespace interstice
