// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/Rarefaction.hpp"

#include "coupling/laws/EffectNumbers.hpp"

namespace interstice
{

Effect Rarefaction::effect() const
{
    return {"rarefaction", "share of drag that a gas lacks, 2.5 free paths over d", largestRarefiedShare};
}

double Rarefaction::freePath(const AirAtRest& air) const
{
    return isGas(air.density) ? meanFreePath(air.density, air.viscosity, pressure_) : 0;
}

// Of the smallest grain.
std::optional<double> Rarefaction::numberAtStart(const AirAtRest& air, const DemEngine& dem) const
{
    return dem.particleCount() > 0 ? rarefiedShare(2*dem.minimumRadius()/coarseGraining_, freePath(air)) : 0;
}

double Rarefaction::number(AirMotion& air, const DemEngine& dem) const
{
    return *numberAtStart({air.density, air.largestViscosity()}, dem);
}

} // namespace interstice
