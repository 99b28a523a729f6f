// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/ParcelForce.hpp"

namespace interstice
{

/// Dispersion by turbulence: drag follows the air's fluctuations too, which are those of laws/Dispersion.hpp, with k and
/// its dissipation from the case's turbulence model. For lone grains; a parcel takes the path of one of its grains. What
/// grains do to turbulence is the model's matter; those of OpenFOAM know of no grains. The slip that shortens a grain's
/// memory is that of drag in the mean over the last T_L.
///
/// Fluctuation and slip are remembered beside each particle (DemEngine::memory), and its chances belong to particle and step:
/// a run is the same on any ranks, and goes on after a restart as if there had been none.
class Dispersion : public ParcelForce
{
public:
    explicit Dispersion(double coarseGraining) : coarseGraining_(coarseGraining) {}

    Effect effect() const override;
    double number(AirMotion& air, const DemEngine& dem) const override;
    void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own) override;

private:
    double coarseGraining_;
};

} // namespace interstice
