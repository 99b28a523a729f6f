// SPDX-License-Identifier: GPL-3.0-or-later
// Effects besides drag and pressure: which a scene calls for, and what they do to the parcels. What an
// effect gives a parcel is owed by the air like a remainder of drag, and taken from it in the next step.
#include "coupling/CoupledPowder.hpp"

#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/LiftForces.hpp"
#include "coupling/mesh/Parameters.hpp"

#include "fvc.H"

namespace interstice
{

using namespace Foam;

namespace
{

const word shearLiftKey = "shearLift";
constexpr double alone = 0.9; // void fraction above which a grain is lifted like a lone sphere
constexpr int lookEvery = 20; // steps between two looks at an effect that is off

} // namespace

void CoupledPowder::readEffects(const dictionary& dict)
{
    const Parameters p(dict);
    Effect effect;
    effect.key = shearLiftKey;
    effect.number = "lift in shear over Stokes' drag";
    effect.limit = largestLiftShare;
    effect.wish = EffectTable::wish(p.name(shearLiftKey, "auto"), p.where(shearLiftKey));
    effects_.add(effect);
    p.allKnown();
}

void CoupledPowder::addEffects(
    const volVectorField& U, const volScalarField& nu, std::vector<GasRecord>& own)
{
    // By the index of the step, which a run that goes on takes over.
    const bool look = mesh_.time().timeIndex() % lookEvery == 1;
    if (!look && !effects_.on(shearLiftKey))
    {
        return;
    }
    StageClock::Scope timed(clock_, Stage::deposit);
    const volVectorField vorticity(fvc::curl(U));
    if (look)
    {
        const std::string news =
            effects_.meet(shearLiftKey, shearNumber(vorticity, nu), mesh_.time().value());
        if (!news.empty())
        {
            Info<< "    " << news.c_str() << endl;
        }
    }
    if (effects_.on(shearLiftKey))
    {
        liftInShear(vorticity, nu, own);
    }
}

// The largest at a parcel outside of beds, for the coarsest grain.
double CoupledPowder::shearNumber(const volVectorField& vorticity, const volScalarField& nu) const
{
    const double grain = 2*dem_->maximumRadius()/coarseGraining_;
    double largest = 0;
    for (const int celli : onMesh_->cells())
    {
        if (onMesh_->voidFraction()[celli] > alone)
        {
            largest = max(
                largest, saffmanShare(grain, density_, density_*nu[celli], mag(vorticity[celli])));
        }
    }
    return returnReduce(largest, maxOp<double>());
}

void CoupledPowder::liftInShear(const volVectorField& vorticity, const volScalarField& nu,
    std::vector<GasRecord>& own) const
{
    List<Packed<5>> cells(mesh_.nCells());
    forAll(cells, celli)
    {
        const vector& w = vorticity[celli];
        cells[celli] = {w.x(), w.y(), w.z(), density_*nu[celli], onMesh_->voidFraction()[celli]};
    }
    const std::vector<Packed<5>> handled = onMesh_->atParcels(std::move(cells));
    std::vector<Packed<5>> air(own.size(), Packed<5>(Zero));
    exchange_->toOwners(handled, air);

    const ParticleView view = dem_->particles();
    const double interval = mesh_.time().deltaTValue();
    const double grains = pow3(coarseGraining_);
    for (int i = 0; i < view.count; ++i)
    {
        GasRecord& gas = own[i];
        if (!(gas.dragCoefficient > 0 && air[i][4] > alone))
        {
            continue; // in no cell, inside a solid, or in a bed
        }
        const double* v = view.velocity[i];
        const std::array<double, 3> lift = shearLift(
            {2*view.radius[i]/coarseGraining_, density_, air[i][3]},
            {gas.velocity[0] - v[0], gas.velocity[1] - v[1], gas.velocity[2] - v[2]},
            {air[i][0], air[i][1], air[i][2]});
        for (int d = 0; d < 3; ++d)
        {
            gas.force[d] += grains*lift[d];
            gas.given[d] -= interval*grains*lift[d];
        }
    }
}

} // namespace interstice
