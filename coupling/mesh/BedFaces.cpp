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

tmp<volVectorField> bedFaces::pressureGradient(const surfaceScalarField& alphaPhi,
    const surfaceScalarField& free, const volScalarField& resistance,
    const volVectorField& source, const surfaceScalarField& fixedFlux)
{
    const fvMesh& mesh = alphaPhi.mesh();
    const surfaceVectorField& S = mesh.Sf();
    const surfaceScalarField& magS = mesh.magSf();

    auto gradient = tmp<volVectorField>::New(IOobject("pressureGradient",
                                                 mesh.time().timeName(), mesh,
                                                 IOobject::NO_READ, IOobject::NO_WRITE, false),
        mesh, dimensionedVector(dimAcceleration, Zero),
        extrapolatedCalculatedFvPatchVectorField::typeName);
    vectorField& sum = gradient.ref().primitiveFieldRef();
    tensorField shape(mesh.nCells(), Zero);

    const auto add = [&](label cell, const vector& area, scalar magArea, scalar freeFlux, scalar flux)
    {
        const scalar half = freeFlux + (source[cell] & area) - resistance[cell]*flux;
        sum[cell] += area/magArea*half;
        shape[cell] += area*area/magArea;
    };
    forAll(mesh.neighbour(), facei)
    {
        add(mesh.owner()[facei], S[facei], magS[facei], free[facei], alphaPhi[facei]);
        add(mesh.neighbour()[facei], S[facei], magS[facei], free[facei], alphaPhi[facei]);
    }
    for (const fvPatch& patch : mesh.boundary())
    {
        const label p = patch.index();
        forAll(patch, i)
        {
            const bool given = fixedFlux.boundaryField()[p][i] > 0.5;
            add(patch.faceCells()[i], S.boundaryField()[p][i], magS.boundaryField()[p][i],
                given ? 0 : free.boundaryField()[p][i], alphaPhi.boundaryField()[p][i]);
        }
    }
    sum = inv(shape) & sum;
    gradient.ref().correctBoundaryConditions();
    return gradient;
}

} // namespace interstice
