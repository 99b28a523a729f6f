// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the remainder counts the carried part of what the air gave, too.
#include "coupling/CoupledPowder.hpp"
#include "coupling/TimeStepChoice.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"

namespace interstice
{

using namespace Foam;

void CoupledPowder::fromAir(
    const volVectorField& U, const volScalarField&, const volVectorField& pressureGradient)
{
    std::vector<GasRecord> own(dem_->particles().count);
    exchange_->toOwners(
        onMesh_->gasAtParcels(U, pressureGradient, mesh_.time().deltaTValue()), own);
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const Vec3 carried = dem_->impulse(static_cast<int>(i));
        Vec3 given;
        for (int d = 0; d < 3; ++d)
        {
            given[d] = -own[i].given[d] - carried[d];
        }
        dem_->setGas(static_cast<int>(i),
            {own[i].velocity, own[i].dragCoefficient, own[i].force}, given);
    }
    dem_->advance(timeStep_->demSteps());
    refreshState();
}

} // namespace interstice
