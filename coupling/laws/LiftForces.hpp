// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace interstice
{

/// What the air does to a grain across its slip, and to its spin. All take grains, never parcels.
///
/// slip      u - v, of the air past the grain [m/s]
/// vorticity curl u of the air around it [1/s]
/// spin      of the grain less that of the air, w_p - curl(u)/2 [rad/s]

struct GasAtGrain
{
    double diameter; ///< of the grain [m]
    double density; ///< of the air [kg/m3]
    double viscosity; ///< of the air, dynamic [Pa s]
};

/// Lift of a grain in a shear flow [N],
///
///     1.615 d^2 sqrt(rho mu/|w|) f (u - v) x w,     w = curl u
///
/// with f = 1 where the shear's Reynolds number is well above that of the slip squared, both small:
/// P.G. Saffman, J. Fluid Mech. 22 (1965) 385-400, and 31 (1968) 624. For finite ones, up to 100, f is that of
/// R. Mei, Int. J. Multiphase Flow 18 (1992) 145-147, with b = d |w|/(2 |u - v|) in 0.005 to 0.4:
///
///     (1 - 0.3314 sqrt(b)) exp(-Re/10) + 0.3314 sqrt(b)     up to Re = rho |u - v| d/mu = 40
///     0.0524 sqrt(b Re)                                     beyond
std::array<double, 3> shearLift(const GasAtGrain& gas, const std::array<double, 3>& slip,
    const std::array<double, 3>& vorticity);

/// Lift of a grain that spins [N],
///
///     pi/8 rho d^2 C |u - v| (u - v) x w/|w|,     w the spin
///
/// with C = 0.45 + (d |w|/|u - v| - 0.45) exp(-0.05684 Re_w^0.4 Re^0.3), Re_w = rho d^2 |w|/mu, up to
/// Re = 140: B. Oesterlé & T. Bui Dinh, Exp. Fluids 25 (1998) 16-22. For small Re it is
/// pi/8 rho d^3 (u - v) x w: S.I. Rubinow & J.B. Keller, J. Fluid Mech. 11 (1961) 447-459.
std::array<double, 3> spinLift(const GasAtGrain& gas, const std::array<double, 3>& slip,
    const std::array<double, 3>& spin);

/// How the air slows a spin: torque over spin, positive [N m s],
///
///     pi mu d^3                                  up to Re_w = rho d^2 |w|/mu = 32
///     mu d^3 [12.9 sqrt(Re_w) + 128.4]/64        beyond, up to 1000
///
/// S.C.R. Dennis, S.N. Singh & D.B. Ingham, J. Fluid Mech. 101 (1980) 257-279.
///
/// @param spin |w| [rad/s]
double spinDrag(const GasAtGrain& gas, double spin);

} // namespace interstice
