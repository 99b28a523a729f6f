// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/BedFaces.hpp"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvMesh.H"
#include "reverseLinear.H"

namespace interstice
{

using namespace Foam;

template<class Type>
tmp<GeometricField<Type, fvsPatchField, surfaceMesh>> bedFaces::inSeries(
    const GeometricField<Type, fvPatchField, volMesh>& field)
{
    return reverseLinear<Type>(field.mesh()).interpolate(field);
}

template tmp<surfaceScalarField> bedFaces::inSeries(const volScalarField&);
template tmp<surfaceVectorField> bedFaces::inSeries(const volVectorField&);

tmp<volVectorField> bedFaces::pressureGradient(const surfaceScalarField& free, const Resisting& bed,
    const Resisting& solids, const surfaceScalarField& open, const surfaceScalarField& fixedFlux)
{
    const fvMesh& mesh = free.mesh();
    const surfaceVectorField& S = mesh.Sf();
    const surfaceScalarField& magS = mesh.magSf();

    auto gradient = tmp<volVectorField>::New(IOobject("pressureGradient",
                                                 mesh.time().timeName(), mesh,
                                                 IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh, dimensionedVector(dimAcceleration, Zero),
        extrapolatedCalculatedFvPatchVectorField::typeName);
    vectorField& sum = gradient.ref().primitiveFieldRef();
    tensorField shape(mesh.nCells(), Zero);

    // `at`: value of a field on the face.
    const auto add = [&](label cell, const vector& area, scalar magArea, scalar freeFlux, const auto& at)
    {
        scalar half = freeFlux;
        for (const Resisting* resisting : {&bed, &solids})
        {
            half += at(resisting->share)
                *((resisting->source[cell] & area) - resisting->resistance[cell]*at(resisting->flux));
        }
        const scalar weight = at(open)/magArea;
        sum[cell] += weight*half*area;
        shape[cell] += weight*area*area;
    };
    forAll(mesh.neighbour(), facei)
    {
        const auto at = [facei](const surfaceScalarField& field) { return field[facei]; };
        add(mesh.owner()[facei], S[facei], magS[facei], free[facei], at);
        add(mesh.neighbour()[facei], S[facei], magS[facei], free[facei], at);
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        const label p = patch.index();
        forAll(patch, i)
        {
            const auto at = [p, i](const surfaceScalarField& field) { return field.boundaryField()[p][i]; };
            const bool given = at(fixedFlux) > 0.5;
            add(patch.faceCells()[i], S.boundaryField()[p][i], magS.boundaryField()[p][i],
                given ? 0 : at(free), at);
        }
    }
    sum = inv(shape) & sum;
    gradient.ref().correctBoundaryConditions();
    return gradient;
}

} // namespace interstice
