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
/// with resistance = (K/rho + sigma)/alpha^2 of drag and solids, b = what each cell has for itself (their
/// sources, gravity, convection, viscosity) over alpha, and the velocity of the step before in h. Between two cell centres the
/// flux w is one and the two half cells resist one after the other, so face values are averages
/// weighted by *their own* half lengths: resistances in series. Interpolating K U_s, A and alpha each
/// by itself instead loses half a cell of bed at every free surface.
namespace bedFaces
{

/// Average over the two half cells of each face, each with the length it has.
template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvsPatchField, Foam::surfaceMesh>> inSeries(
    const Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field);

/// Pressure gradient of each cell [m/s2, kinematic].
///
/// On either side of a face the half-cell gradient is (h - inertia w)_face + b - resistance w with
/// the side's own b and resistance: the face's gradient plus half the jump of the drag. The cell's
/// gradient is reconstructed from those of its faces; beside a wall, from b and resistance alone. Used both
/// to correct U and on the particles, so that a bed at rest feels no net force and the sum of both
/// is conserved.
///
/// @param alphaPhi       flux of alpha U after the pressure equation [m3/s]
/// @param free           flux of h - inertia w on the same faces [m3/s2]
/// @param resistance     [1/s]
/// @param source         b [m/s2]
/// @param fixedFlux      1 on boundary faces whose flux is given (walls, inlets), else 0
Foam::tmp<Foam::volVectorField> pressureGradient(const Foam::surfaceScalarField& alphaPhi,
    const Foam::surfaceScalarField& free, const Foam::volScalarField& resistance,
    const Foam::volVectorField& source, const Foam::surfaceScalarField& fixedFlux);

} // namespace bedFaces

} // namespace interstice
