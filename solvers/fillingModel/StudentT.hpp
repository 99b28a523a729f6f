// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interstice
{

/// Probability that a Student t variable of `degreesOfFreedom` > 0 is at most t.
///
///     F(t) = 1 - I_x(n/2, 1/2)/2,   x = n/(n + t^2),   t >= 0
///
/// I_x is the regularised incomplete beta function, by its continued fraction.
/// M. Abramowitz & I.A. Stegun, Handbook of Mathematical Functions (1964), 26.5.8 and 26.7.1.
double studentTProbability(double t, double degreesOfFreedom);

/// The t that a Student t variable stays below with the given probability, 0 < probability < 1.
double studentTQuantile(double probability, double degreesOfFreedom);

} // namespace interstice
