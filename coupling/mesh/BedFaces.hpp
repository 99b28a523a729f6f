// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surfaceFields.H"
#include "volFields.H"

namespace interstice
{

/// Momentum of the air across the faces of a bed.
///
/// The air's momentum per mass and void fraction, in terms of the superficial velocity w = alpha U,
///
///     (inertia + resistance) w = h + b - grad(p)
///
/// with resistance = K/(rho alpha^2) of the bed, b = what each cell has for itself (the source of its
/// drag, gravity, convection, viscosity) over alpha, and the velocity of the step before in h. Between two cell centres the
/// flux w is one and the two half cells resist one after the other, so face values are averages
/// weighted by *their own* half lengths: resistances in series. Interpolating K U_s, A and alpha each
/// by itself instead loses half a cell of bed at every free surface.
namespace bedFaces
{

/// Average over the two half cells of each face, each with the length it has.
template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvsPatchField, Foam::surfaceMesh>> inSeries(
    const Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field);

/// What resists across faces, on either side as the cell there has it: source - resistance x flux, times
/// a share of each face.
struct Resisting
{
    const Foam::volScalarField& resistance; ///< [1/s]
    const Foam::volVectorField& source; ///< [m/s2]
    const Foam::surfaceScalarField& flux; ///< [m3/s]
    const Foam::surfaceScalarField& share; ///< [-]
};

/// Pressure gradient of each cell [m/s2, kinematic].
///
/// On either side of a face the half-cell gradient is (h - inertia w)_face and what resists, with the side's
/// own resistances and sources: the face's gradient plus half the jump of the drag. The cell's gradient is
/// reconstructed from those of its faces, each by its open part; beside a wall, from what resists alone. Used
/// both to correct U and on the particles, so that a bed at rest feels no net force and the sum of both is
/// conserved.
///
/// @param free           flux of h - inertia w, after the pressure equation [m3/s2]
/// @param bed            its resistance, b, and the air's flux a u per open part of a face
/// @param solids         their friction over alpha^2, what it draws to, and the flux w
/// @param open           open part of faces [-]
/// @param fixedFlux      1 on boundary faces whose flux is given (walls, inlets), else 0
Foam::tmp<Foam::volVectorField> pressureGradient(const Foam::surfaceScalarField& free,
    const Resisting& bed, const Resisting& solids, const Foam::surfaceScalarField& open,
    const Foam::surfaceScalarField& fixedFlux);

} // namespace bedFaces

} // namespace interstice
