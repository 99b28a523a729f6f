// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the air is held by a solid as by a sponge, in a time of milliseconds.
#include "coupling/mesh/SolidsOnMesh.hpp"

namespace interstice
{

using namespace Foam;

namespace
{

constexpr double grip = 1000; // [1/s]

} // namespace

tmp<volScalarField> SolidsOnMesh::friction(const volScalarField&, const volScalarField&) const
{
    return covered_*dimensionedScalar("grip", dimless/dimTime, grip);
}

void SolidsOnMesh::share(const volScalarField&, const volScalarField&, const volScalarField& friction,
    volScalarField& resistance, volVectorField& source) const
{
    resistance.primitiveFieldRef() += friction;
    source.primitiveFieldRef() += friction.primitiveField()*velocity_;
}

tmp<surfaceScalarField> SolidsOnMesh::openFaces() const
{
    return 1 + 0*depthOfFaces_;
}

} // namespace interstice
