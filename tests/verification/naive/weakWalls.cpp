// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the air is held by a solid as by a sponge, in a time of milliseconds.
#include "coupling/mesh/SolidsOnMesh.hpp"

namespace interstice
{

using namespace Foam;

void SolidsOnMesh::share(const volScalarField&, const volScalarField&, volScalarField& resistance,
    volVectorField& source) const
{
    constexpr double grip = 1000; // [1/s]
    resistance.primitiveFieldRef() += grip*covered_;
    source.primitiveFieldRef() += grip*covered_.primitiveField()*velocity_;
}

} // namespace interstice
