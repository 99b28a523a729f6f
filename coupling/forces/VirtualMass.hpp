// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Mass of the fluid that a sphere takes along, m_a = 1/2 of what it displaces: the sphere feels
///
///     m_a (Du/Dt - dv/dt),     Du/Dt = du/dt + u.grad(u)
///
/// The second part makes the sphere heavier in every DEM step (DemEngine::setAddedMass). The same of a parcel as
/// of its grains, since their volumes are the same.
///
/// M.R. Maxey & J.J. Riley, Phys. Fluids 26 (1983) 883-889, eq. 45; one half also among other spheres.
class VirtualMass : public ParcelForce
{
public:
    static constexpr double coefficient = 0.5;

    Effect effect() const override;
    std::optional<double> numberAtStart(const AirAtRest& air, const DemEngine& dem) const override;
    double number(AirMotion& air, const DemEngine& dem) const override;
    void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own) override;
};

} // namespace interstice
