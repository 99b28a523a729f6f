// SPDX-License-Identifier: GPL-3.0-or-later
#include "AirFlow.hpp"

#include "fvc.H"
#include "fvm.H"

namespace interstice
{

using namespace Foam;

// Cell values of U^n say less about the fluxes of the last step than these themselves: without this
// term, pressure and velocity decouple into a chequerboard when the time step is short (Rhie & Chow,
// AIAA J. 21 (1983) 1525-1532; limited as OpenFOAM's ddtCorr is). Three quarters of it, so that the
// rest draws the cells' velocity to the fluxes: with all of it nothing does, and alpha U strays from the
// flux where air leaves a bed, by 5 %; with half of it moving walls are noisier. Flux of h [m3/s2].
tmp<surfaceScalarField> AirFlow::memoryOfFlux() const
{
    const surfaceScalarField fromCells
    (
        fvc::flux(alpha_.oldTime()*U_.oldTime())
    );
    const surfaceScalarField& old = alphaPhi_.oldTime();
    const dimensionedScalar tiny("tiny", old.dimensions(), VSMALL);
    tmp<surfaceScalarField> memory
    (
        0.75*(1 - min(mag(old - fromCells)/(mag(old) + tiny), scalar(1)))
       *(old - fromCells)/(fvc::interpolate(alpha_)*mesh_.time().deltaT())
    );
    for (fvsPatchScalarField& patch : memory.ref().boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch = Zero;
        }
    }
    return memory;
}

// div(alpha U) = -d(alpha)/dt, with the flux predicted - D grad(p).
void AirFlow::solvePressure(const surfaceScalarField& D, const surfaceScalarField& predicted)
{
    volScalarField gain(fvc::div(predicted) + ddtAlpha_);
    if (p_.needReference() && !compressible())
    {
        // Nothing can leave a closed box: powder put in or taken out is shared among all cells.
        const dimensionedScalar mean(gain.weightedAverage(mesh_.V()));
        report_.spreadSource = mean.value()*gSum(mesh_.V());
        gain -= mean;
    }

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(D, p_) == gain
        );
        if (compressible())
        {
            const volScalarField taken(storage());
            pEqn -= fvm::Sp(taken, p_) - taken*p_.oldTime();
        }
        else
        {
            pEqn.setReference(pRefCell_, pRefValue_);
        }
        const bool final = pimple_.finalInnerIter();
        report_.pressureIterations +=
            pEqn.solve(mesh_.solver(p_.select(final))).nIterations();

        if (pimple_.finalNonOrthogonalIter())
        {
            alphaPhi_ = predicted - pEqn.flux();
        }
    }
}

// With w = alpha U, the momentum of the air is
//
//     inertia w + bed (w - c U_w)/o + friction (w - alpha U_w) = h + b - grad(p)
//
// with the velocity of the step before in h, and in b all that a cell has for itself: the source of its
// drag, gravity, convection, viscosity. Across faces resistances act in series (see BedFaces.hpp), that of
// the bed on what flows through their open part o; friction of solids fades where there is a bed (see
// SolidsOnMesh.hpp).
void AirFlow::correctPressure(const volVectorField& carried, const SolidsOnMesh& solids)
{
    StageClock::Scope timed(clock_, Stage::pressure);

    const volScalarField A(alpha_.oldTime()/mesh_.time().deltaT());
    const volVectorField before(A*U_.oldTime());
    const volScalarField inertia(A/sqr(alpha_));
    const volVectorField b(bedSource_ + gravity_ + bodyForce_ + (carried - before)/alpha_);
    const volScalarField friction(friction_/sqr(alpha_));
    const volVectorField drawn(friction_/alpha_*solids.velocity());

    const surfaceScalarField inertiaf(bedFaces::inSeries(inertia));
    const surfaceScalarField bed(bedFaces::inSeries(bedResistance_));
    const surfaceScalarField faded(1/(1 + bed*mesh_.magSf()/fvc::interpolate(turbulence_->nuEff())));
    const surfaceScalarField open(solids.openFaces());
    const surfaceScalarField covered((1 - open)*solids.flux());
    const surfaceScalarField D(1/(inertiaf + bed/open + faded*bedFaces::inSeries(friction)));
    const surfaceScalarField h
    (
        (bedFaces::inSeries(volVectorField(before/alpha_)) & mesh_.Sf()) + memoryOfFlux()
    );
    surfaceScalarField predicted
    (
        "predictedFlux",
        D*(h + (bedFaces::inSeries(b) & mesh_.Sf()) + bed/open*covered
          + faded*(bedFaces::inSeries(drawn) & mesh_.Sf()))
    );
    predicted =
        fixedFlux_*fvc::interpolate(alpha_)*fvc::flux(U_) + (1 - fixedFlux_)*predicted;

    solvePressure(D, predicted);

    const surfaceScalarField airFlux((alphaPhi_ - covered)/open);
    gradP_ = bedFaces::pressureGradient(h - inertiaf*alphaPhi_, {bedResistance_, b, airFlux, whole_},
        {friction, drawn, alphaPhi_, faded}, open, fixedFlux_);
    U_ = (carried + source_ - alpha_*gradP_)/(A + resistance_);
    U_.correctBoundaryConditions();
    push_ = A*U_ - carried;
}

} // namespace interstice
