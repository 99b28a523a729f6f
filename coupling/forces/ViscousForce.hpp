// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Force of the air's viscous stresses on the volume of a parcel, V div(tau). It comes with the pressure force, and the air
/// then keeps alpha div(tau) for itself; without it the air has div(alpha tau), and the powder nothing (Zhou, Kuang, Chu
/// & Yu, J. Fluid Mech. 661 (2010) 482-510, model A, and its original form).
class ViscousForce : public ParcelForce
{
public:
    Effect effect() const override;
    double number(AirMotion& air, const DemEngine& dem) const override;

    /// The equations of the air and the pressure force know already.
    void act(AirMotion&, DemEngine&, std::vector<GasRecord>&) override {}
};

} // namespace interstice
