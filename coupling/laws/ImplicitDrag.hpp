// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace interstice
{

/// Mean of exp(-s) over 0 < s < x: phi(x) = (1 - exp(-x))/x.
///
/// The share of a frozen slip that is left on average over a time step of x relaxation times.
/// Falls from 1 at x = 0 to 1/x for large x; accurate to round-off everywhere, and without a
/// branch, so that a loop over particles can be vectorised.
///
/// @param x at least 0
inline double meanSlip(double x)
{
    // Below this bound phi is 1 to the last digit, and 0/0 is out of the way.
    const double positive = std::max(x, 1e-300);
    return -std::expm1(-positive) / positive;
}

/// Drag over a time step, exact for air that stands still meanwhile.
///
/// A particle of mass m, drag coefficient b and slip u - v, under another force F, obeys
/// m dv/dt = b (u - v) + F. With u and F constant over dt, and x = b dt/m,
///
///     v(dt) = v + [1 - exp(-x)] [(u - v) + F/b]
///
/// A velocity update v + (F + F_drag) dt/m lands on it if
///
///     F_drag = b phi(x) (u - v) + [phi(x) - 1] F,     phi(x) = [1 - exp(-x)]/x
///
/// which is finite and free of overshoot for any stiffness, b = 0 included. The two factors are
/// the same for the three components:
///
///     const ImplicitDrag drag(b, mass, dt);
///     for each component c:  force[c] += drag.force(u[c] - v[c], force[c]);
class ImplicitDrag
{
public:
    /// @param coefficient b, at least 0 [kg/s]
    /// @param mass        m, above 0 [kg]
    /// @param timeStep    dt, at least 0 [s]
    ImplicitDrag(double coefficient, double mass, double timeStep)
    {
        const double phi = meanSlip(coefficient * timeStep / mass);
        onSlip_ = coefficient * phi;
        onOther_ = phi - 1;
    }

    /// One component of the drag force [N].
    ///
    /// @param slip  that component of u - v at the start of the step [m/s]
    /// @param other that component of all other forces [N]
    double force(double slip, double other) const { return onSlip_ * slip + onOther_ * other; }

    /// Drag per slip at the start of the step [kg/s], of a particle that nothing else pushes:
    /// b_eff = m/dt [1 - exp(-b dt/m)]. Never above m/dt: what the air may count on.
    double effectiveCoefficient() const { return onSlip_; }

private:
    double onSlip_;
    double onOther_;
};

} // namespace interstice
