// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the air is held by a solid as by a sponge, in a time of milliseconds.
#include "coupling/mesh/SolidsOnMesh.hpp"

#include "zeroGradientFvPatchFields.H"

namespace interstice
{

using namespace Foam;

tmp<volScalarField> SolidsOnMesh::resistance() const
{
    return tmp<volScalarField>::New(
        "solidResistance", covered_*dimensionedScalar("grip", dimless/dimTime, scalar(1000)));
}

} // namespace interstice
