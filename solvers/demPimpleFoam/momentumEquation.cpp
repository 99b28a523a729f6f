// SPDX-License-Identifier: GPL-3.0-or-later
#include "AirFlow.hpp"

#include "fvc.H"
#include "fvm.H"

namespace interstice
{

using namespace Foam;

// Inertia, convection and viscosity, all but the forces:
//
//     alpha^n (U - U^n)/dt + U^n d(alpha)/dt^n + div(alphaPhi^n U) - div(alpha tau)
//
// or - alpha div(tau) if the powder feels the rest of div(tau).
// alpha^n and alphaPhi^n are those that met in the continuity equation of the last step.
fvVectorMatrix AirFlow::inertia()
{
    StageClock::Scope timed(clock_, Stage::momentum);
    return fvVectorMatrix
    (
        alpha_.oldTime()*fvm::ddt(U_)
      + fvm::Su(ddtAlpha_.oldTime()*U_.oldTime(), U_)
      + fvm::div(alphaPhi_.oldTime(), U_, "div(alphaPhi,U)")
      + viscosity()
    );
}

tmp<fvVectorMatrix> AirFlow::viscosity()
{
    if (!divTau_)
    {
        return turbulence_->divDevRhoReff(U_);
    }
    // The powder must feel the same: one part of the velocity as it is here, the other one as it is predicted.
    const volScalarField nuEff(turbulence_->nuEff());
    *divTau_ = fvc::div(nuEff*dev2(T(fvc::grad(U_))), "div(nuEff*dev2(T(grad(U))))");
    return alpha_*fvm::Su(-*divTau_, U_) - alpha_*fvm::laplacian(nuEff, U_, "laplacian(nuEff,U)");
}

tmp<volVectorField> AirFlow::stressGradient() const
{
    const dimensionedScalar rho("rho", dimDensity, density_);
    return divTau_ ? rho*(gradP_ - *divTau_) : rho*gradP_;
}

// Where convection and viscosity will find the air, if it is pushed as in the last step. Not by the last
// step's pressure gradient against the drag of this one: in a bed both are larger than what is left of
// them by orders, and where the bed has just moved they no longer fit each other.
void AirFlow::predictVelocity(fvVectorMatrix& UEqn)
{
    StageClock::Scope timed(clock_, Stage::momentum);
    Foam::solve(UEqn == push_);
    if (divTau_)
    {
        *divTau_ += fvc::laplacian(turbulence_->nuEff(), U_, "laplacian(nuEff,U)");
    }
}

// What a cell would have of alpha^n U/dt if nothing pushed it: its momentum of the step before, and what
// convection and viscosity of the predicted velocity bring, as fluxes between cells that cancel in the
// sum. With OpenFOAM's usual H(U), whose neighbours lag behind the cell itself, a closed box leaks
// momentum until the correctors have converged.
tmp<volVectorField> AirFlow::carried(const fvVectorMatrix& UEqn) const
{
    StageClock::Scope timed(clock_, Stage::momentum);
    const volScalarField rate(alpha_.oldTime()/mesh_.time().deltaT());
    return rate*U_ - (UEqn.A()*U_ - UEqn.H());
}

} // namespace interstice
