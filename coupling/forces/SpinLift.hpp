// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Lift of lone grains that spin, and the torque by which the air slows their spin (spinLift() and spinDrag() of
/// LiftForces.hpp). The spin is that relative to the air's, half its vorticity. Not for parcels of many grains:
/// a parcel's spin is nobody's.
class SpinLift : public ParcelForce
{
public:
    Effect effect() const override;
    double number(AirMotion& air, const DemEngine& dem) const override;
    void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own) override;
};

} // namespace interstice
