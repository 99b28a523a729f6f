// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Lift of lone grains in a shear flow (shearLift() of LiftForces.hpp), k^3 of them a parcel. Beds feel and
/// count none: there the law does not hold.
class ShearLift : public ParcelForce
{
public:
    explicit ShearLift(double coarseGraining) : coarseGraining_(coarseGraining) {}

    Effect effect() const override;
    double number(AirMotion& air, const DemEngine& dem) const override;
    void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own) override;

private:
    double coarseGraining_;
};

} // namespace interstice
