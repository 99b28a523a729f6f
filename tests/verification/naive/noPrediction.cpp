// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the void fraction of a step is that of the powder at its start.
#include "coupling/CoupledPowder.hpp"
#include "coupling/TimeStepChoice.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"

namespace interstice
{

using namespace Foam;

void CoupledPowder::toAir(const volVectorField& U, const volScalarField& nu)
{
    placeParcels(0);
    onMesh_->depositVolume();
    onMesh_->depositDrag(U, density_, nu, mesh_.time().deltaTValue());
}

} // namespace interstice
