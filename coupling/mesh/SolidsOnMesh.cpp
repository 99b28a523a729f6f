// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/SolidsOnMesh.hpp"

#include "coupling/mesh/OpenVolumes.hpp"

#include "surfaceInterpolate.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

constexpr double grip = 1e11; // on the air of a cell that is covered all over [1/s]
constexpr double leastShown = 0.1; // of a cell, to the air that the powder meets
constexpr double farAway = -0.5; // depth of a cell that no body is near

// Of a face, to the air. Cells and faces close together but for rounding, and what a cell has left then must not be
// squeezed out of it with any force.
constexpr double leastOpenFace = 1e-3;

// What the surface does to the shear flow along it, times h^2: a cell whose centre is outside gets the
// velocity that a straight profile has there, one whose centre is inside next to none.
double shear(double depth, double open)
{
    constexpr double leastDistance = 0.01; // cells
    return (1/max(0.5 - depth, leastDistance) - 1)*sqr(max(0.5/open, 1.0));
}

} // namespace

SolidsOnMesh::SolidsOnMesh(const fvMesh& mesh)
:
    mesh_(mesh),
    coarsest_(std::cbrt(gMax(mesh.V()))),
    depth_(mesh.nCells(), farAway),
    covered_(IOobject("solid", mesh.time().timeName(), mesh, IOobject::NO_READ,
                 IOobject::AUTO_WRITE),
        mesh, dimensionedScalar(dimless, Zero), zeroGradientFvPatchScalarField::typeName),
    velocity_(IOobject("solidVelocity", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero), zeroGradientFvPatchVectorField::typeName),
    depthOfFaces_(IOobject("solidDepth", mesh.time().timeName(), mesh), mesh,
        dimensionedScalar("farAway", dimless, farAway)),
    flux_(IOobject("solidFlux", mesh.time().timeName(), mesh), mesh,
        dimensionedScalar(dimVelocity*dimArea, Zero))
{
    flux_.setOriented();
}

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
    const std::vector<RigidPose> before(poses_.empty() ? poses : poses_);
    poses_ = poses;
    depth_ = farAway;
    velocity_ = dimensionedVector(dimVelocity, Zero);
    for (std::size_t i = 0; i < solids_.size(); ++i)
    {
        const scalar widest = solids_[i]->cover(poses[i], depth_, velocity_);
        if (mayLeak_[i])
        {
            warnOfLeak(i, returnReduce(widest, maxOp<scalar>()));
        }
    }
    covered_.primitiveFieldRef() = max(depth_, scalar(0));
    covered_.correctBoundaryConditions();
    velocity_.correctBoundaryConditions();
    moveFaces(before);
}

void SolidsOnMesh::moveFaces(const std::vector<RigidPose>& before)
{
    const auto see = [&](label facei, scalar& depth, scalar& flux)
    {
        depth = farAway;
        flux = 0;
        for (std::size_t i = 0; i < solids_.size(); ++i)
        {
            const scalar here = solids_[i]->coverOfFace(before[i], poses_[i], facei);
            if (here > depth)
            {
                const point& x = mesh_.faceCentres()[facei];
                const RigidPose::Vector v = poses_[i].velocityAt({x.x(), x.y(), x.z()});
                depth = here;
                flux = vector(v[0], v[1], v[2]) & mesh_.faceAreas()[facei];
            }
        }
    };
    forAll(mesh_.neighbour(), facei)
    {
        const bool near = max(depth_[mesh_.owner()[facei]], depth_[mesh_.neighbour()[facei]]) > farAway;
        if (near || depthOfFaces_[facei] > farAway)
        {
            see(facei, depthOfFaces_[facei], flux_[facei]);
        }
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        fvsPatchScalarField& depth = depthOfFaces_.boundaryFieldRef()[patch.index()];
        fvsPatchScalarField& flux = flux_.boundaryFieldRef()[patch.index()];
        forAll(patch, i)
        {
            see(patch.start() + i, depth[i], flux[i]);
        }
    }
}

tmp<surfaceScalarField> SolidsOnMesh::openFaces() const
{
    return max(1 - max(depthOfFaces_, scalar(0)), leastOpenFace);
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

tmp<volScalarField> SolidsOnMesh::ofWholeCells(const volScalarField& voidFraction) const
{
    if (!any())
    {
        return voidFraction;
    }
    auto whole = tmp<volScalarField>::New("voidFractionOfCells", voidFraction);
    scalarField& A = whole.ref().primitiveFieldRef();
    A = 1 - max(1 - covered_.primitiveField(), leastOpen)*(1 - A);
    whole.ref().correctBoundaryConditions();
    return whole;
}

tmp<volVectorField> SolidsOnMesh::airInOpenPart(const volVectorField& U,
    const volScalarField& voidFraction) const
{
    if (!any())
    {
        return U;
    }
    auto air = tmp<volVectorField>::New("airInOpenPart", U);
    forAll(covered_, celli)
    {
        const double c = covered_[celli];
        if (c > 0)
        {
            const double left = max((1 - c)*voidFraction[celli], leastShown);
            air.ref()[celli] += c/left*(U[celli] - velocity_[celli]);
        }
    }
    return air;
}

tmp<volScalarField> SolidsOnMesh::friction(const volScalarField& voidFraction, const volScalarField& nu) const
{
    tmp<volScalarField> friction = volScalarField::New(
        "frictionOfSolids", mesh_, dimensionedScalar(dimless/dimTime, Zero));
    forAll(depth_, celli)
    {
        if (depth_[celli] > farAway)
        {
            const double o = max(1 - covered_[celli], leastOpen);
            const double A = 1 - o*(1 - voidFraction[celli]);
            const double viscous = nu[celli]/sqr(std::cbrt(mesh_.V()[celli]));
            friction.ref()[celli] = min(A*viscous*shear(depth_[celli], o), grip);
        }
    }
    friction.ref().correctBoundaryConditions();
    return friction;
}

void SolidsOnMesh::share(const volScalarField& voidFraction, const volScalarField& nu,
    const volScalarField& friction, volScalarField& resistance, volVectorField& source) const
{
    forAll(depth_, celli)
    {
        if (depth_[celli] > farAway)
        {
            const double c = covered_[celli];
            const double o = max(1 - c, leastOpen);
            const double a = voidFraction[celli];
            const double A = 1 - o*(1 - a);
            const double K = resistance[celli];
            const double faded = 1/(1 + K*sqr(std::cbrt(mesh_.V()[celli]))/nu[celli]);
            const double sigma = min(K*c*A/(o*sqr(a)) + faded*friction[celli], grip);
            resistance[celli] = K*A/a + sigma;
            source[celli] = A/a*source[celli] + sigma*velocity_[celli];
        }
    }
    resistance.correctBoundaryConditions();
    source.correctBoundaryConditions();
}

} // namespace interstice
