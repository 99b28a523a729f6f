// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: mobility, void fraction and forces taken to the faces each by itself, as is usual.
#include "solvers/demPimpleFoam/AirFlow.hpp"

#include "fvc.H"
#include "fvm.H"

namespace interstice
{

using namespace Foam;

void AirFlow::correctPressure(const volVectorField& carried, const SolidsOnMesh&)
{
    const volScalarField inertia(alpha_.oldTime()/mesh_.time().deltaT());
    const volScalarField mobility(1/(inertia + resistance_));
    const volVectorField driven(mobility*(carried + source_));
    const surfaceScalarField alphaf(fvc::interpolate(alpha_));
    const surfaceScalarField D(sqr(alphaf)*fvc::interpolate(mobility));
    const surfaceScalarField predicted(fixedFlux_*alphaf*fvc::flux(U_)
        + (1 - fixedFlux_)*alphaf*fvc::flux(driven));

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn(fvm::laplacian(D, p_) == fvc::div(predicted) + ddtAlpha_);
        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));
        alphaPhi_ = predicted - pEqn.flux();
    }
    gradP_ = fvc::grad(p_);
    U_ = driven - mobility*alpha_*gradP_;
    U_.correctBoundaryConditions();
    push_ = inertia*U_ - carried;
}

} // namespace interstice
