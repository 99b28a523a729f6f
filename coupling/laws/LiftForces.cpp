// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/LiftForces.hpp"

#include <algorithm>
#include <cmath>

namespace interstice
{

namespace
{

using Vector = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;
constexpr double tiny = 1e-300;

double magnitude(const Vector& a)
{
    return std::sqrt(a[0]*a[0] + a[1]*a[1] + a[2]*a[2]);
}

Vector scaledCross(double factor, const Vector& a, const Vector& b)
{
    return {factor*(a[1]*b[2] - a[2]*b[1]), factor*(a[2]*b[0] - a[0]*b[2]),
        factor*(a[0]*b[1] - a[1]*b[0])};
}

double finiteReynolds(double reynolds, double shear)
{
    constexpr double slow = 40;
    const double root = 0.3314*std::sqrt(shear);
    return reynolds <= slow ? (1 - root)*std::exp(-0.1*reynolds) + root
                            : 0.0524*std::sqrt(shear*reynolds);
}

} // namespace

Vector shearLift(const GasAtGrain& gas, const Vector& slip, const Vector& vorticity)
{
    const double d = gas.diameter;
    const double speed = std::max(magnitude(slip), tiny);
    const double rate = std::max(magnitude(vorticity), tiny);
    const double factor = finiteReynolds(gas.density*speed*d/gas.viscosity, 0.5*d*rate/speed);
    return scaledCross(1.615*d*d*std::sqrt(gas.density*gas.viscosity/rate)*factor, slip, vorticity);
}

Vector spinLift(const GasAtGrain& gas, const Vector& slip, const Vector& spin)
{
    const double d = gas.diameter;
    const double speed = std::max(magnitude(slip), tiny);
    const double rate = std::max(magnitude(spin), tiny);
    const double reynolds = gas.density*speed*d/gas.viscosity;
    const double ofSpin = gas.density*d*d*rate/gas.viscosity;
    const double fade = std::exp(-0.05684*std::pow(ofSpin, 0.4)*std::pow(reynolds, 0.3));
    // C |u - v|, which stays finite where the slip is none.
    const double lift = 0.45*speed*(1 - fade) + d*rate*fade;
    return scaledCross(pi/8*gas.density*d*d*lift/rate, slip, spin);
}

double spinDrag(const GasAtGrain& gas, double spin)
{
    const double d = gas.diameter;
    const double reynolds = gas.density*d*d*spin/gas.viscosity;
    constexpr double slow = 32;
    const double factor = reynolds <= slow ? pi : (12.9*std::sqrt(reynolds) + 128.4)/64;
    return factor*gas.viscosity*d*d*d;
}

} // namespace interstice
