// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/SolidsOnMesh.hpp"

#include "zeroGradientFvPatchFields.H"

#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

// A cell that is quite covered holds its air with stiffness/holdTime: so hard that what leaks through
// a wall is far below the minimum fluidisation velocity. The time is a fixed one and not the time
// step: a wall that creeps into a cell then stops the air there at the same pace, however short the
// step, and the pressure that this takes converges.
constexpr scalar stiffness = 1e8;
constexpr scalar holdTime = 1e-3; // [s]

} // namespace

SolidsOnMesh::SolidsOnMesh(const fvMesh& mesh)
:
    mesh_(mesh),
    coarsest_(std::cbrt(gMax(mesh.V()))),
    covered_(IOobject("solid", mesh.time().timeName(), mesh, IOobject::NO_READ,
                 IOobject::AUTO_WRITE),
        mesh, dimensionedScalar(dimless, Zero), zeroGradientFvPatchScalarField::typeName),
    velocity_(IOobject("solidVelocity", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), zeroGradientFvPatchVectorField::typeName)
{}

void SolidsOnMesh::add(std::unique_ptr<MovingSolid> solid)
{
    mayLeak_.push_back(solid->leaksIn(coarsest_));
    solids_.push_back(std::move(solid));
}

MovingSolid::Seen SolidsOnMesh::outside(const vector& point) const
{
    MovingSolid::Seen seen{point, 1};
    for (std::size_t i = 0; i < solids_.size(); ++i)
    {
        const MovingSolid::Seen next = solids_[i]->outside(poses_[i], seen.position);
        seen = {next.position, min(seen.presence, next.presence)};
    }
    return seen;
}

void SolidsOnMesh::move(const std::vector<RigidPose>& poses)
{
    poses_ = poses;
    covered_ = dimensionedScalar(dimless, Zero);
    velocity_ = dimensionedVector(dimVelocity, Zero);
    for (std::size_t i = 0; i < solids_.size(); ++i)
    {
        const scalar widest = solids_[i]->cover(poses[i], covered_, velocity_);
        if (mayLeak_[i])
        {
            warnOfLeak(i, returnReduce(widest, maxOp<scalar>()));
        }
    }
    covered_.correctBoundaryConditions();
    velocity_.correctBoundaryConditions();
}

void SolidsOnMesh::warnOfLeak(std::size_t solid, scalar widest)
{
    const MovingSolid& body = *solids_[solid];
    if (!body.leaksIn(widest))
    {
        return;
    }
    mayLeak_[solid] = false;
    Info<< "WARNING: The solid " << body.name().c_str() << ", " << body.thickness()
        << " m at its thinnest, meets cells " << widest << " m wide, and air leaks through what is "
        << "thinner than two cells. Refine the mesh along its way, or thicken it." << nl << endl;
}

tmp<volScalarField> SolidsOnMesh::resistance() const
{
    auto field = tmp<volScalarField>::New(IOobject("solidResistance", mesh_.time().timeName(),
                                              mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh_, dimensionedScalar(dimless/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName);
    scalarField& sigma = field.ref().primitiveFieldRef();
    forAll(sigma, celli)
    {
        sigma[celli] = (std::pow(stiffness, covered_[celli]) - 1)/holdTime;
    }
    field.ref().correctBoundaryConditions();
    return field;
}

} // namespace interstice
