// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: Gauss' gradient of p in place of the one that belongs to the fluxes.
#include "coupling/mesh/BedFaces.hpp"

#include "fvc.H"

namespace interstice
{

using namespace Foam;

tmp<volVectorField> bedFaces::pressureGradient(const surfaceScalarField& free, const Resisting&,
    const Resisting&, const surfaceScalarField&, const surfaceScalarField&)
{
    return fvc::grad(free.mesh().lookupObject<volScalarField>("p"));
}

} // namespace interstice
