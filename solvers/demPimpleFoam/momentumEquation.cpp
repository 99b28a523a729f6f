// SPDX-License-Identifier: GPL-3.0-or-later
#include "AirFlow.hpp"

#include "fvm.H"

namespace interstice
{

using namespace Foam;

// Inertia, convection and viscosity, all but the forces:
//
//     alpha^n (U - U^n)/dt + U^n d(alpha)/dt^n + div(alphaPhi^n U) - div(alpha tau)
//
// alpha^n and alphaPhi^n are those that met in the continuity equation of the last step.
fvVectorMatrix AirFlow::inertia()
{
    StageClock::Scope timed(clock_, Stage::momentum);
    return fvVectorMatrix
    (
        alpha_.oldTime()*fvm::ddt(U_)
      + fvm::Su(ddtAlpha_.oldTime()*U_.oldTime(), U_)
      + fvm::div(alphaPhi_.oldTime(), U_, "div(alphaPhi,U)")
      + turbulence_->divDevRhoReff(U_)
    );
}

void AirFlow::predictVelocity(fvVectorMatrix& UEqn)
{
    if (pimple_.momentumPredictor())
    {
        StageClock::Scope timed(clock_, Stage::momentum);
        Foam::solve
        (
            UEqn
          + fvm::Sp(resistance_, U_)
         ==
            source_
          - alpha_*gradP_
        );
    }
}

} // namespace interstice
