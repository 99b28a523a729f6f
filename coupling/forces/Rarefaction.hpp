// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Slip of a gas on grains that are not much larger than its mean free path: less drag (laws/drag/RarefiedDrag.hpp). The
/// drag law does what must be done, for grains and air alike (PowderOnMesh::rarefy). Liquids have none.
class Rarefaction : public ParcelForce
{
public:
    /// `pressure` of the air at rest, absolute [Pa].
    Rarefaction(double coarseGraining, double pressure) : coarseGraining_(coarseGraining), pressure_(pressure) {}

    Effect effect() const override;
    std::optional<double> numberAtStart(const AirAtRest& air, const DemEngine& dem) const override;
    double number(AirMotion& air, const DemEngine& dem) const override;
    void act(AirMotion&, DemEngine&, std::vector<GasRecord>&) override {}

    static constexpr double densestGas = 100; ///< [kg/m3]
    static bool isGas(double density) { return density <= densestGas; }

    /// Mean free path of its molecules [m]; zero for a liquid.
    double freePath(const AirAtRest& air) const;

private:
    double coarseGraining_;
    double pressure_;
};

} // namespace interstice
