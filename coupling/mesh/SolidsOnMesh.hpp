// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/MovingSolid.hpp"

#include "surfaceFields.H"

namespace interstice
{

/// All rigid bodies that the air sees, as fields: what they cover, and how they move.
///
/// A cell that a body cuts is shared. Its covered part, c, moves with the body, at U_w; powder and air
/// share the open one, o = 1 - c, with void fraction a in it. The cell as the air's equations have it
/// counts the body as air: void fraction A = 1 - o (1 - a), and A U = c U_w + o a u, with the
/// velocity u of the air itself. What u meets, drag (K, per open volume) and the body's surface, is
/// then in terms of U
///
///     K A/a (U - U_s) + sigma (U - U_w),     sigma = K c A/(o a^2) + A nu/h^2 (h/s - 1)      [1/s, over density]
///
/// so that clear air, in a cell of width h whose centre is s from the surface, has the velocity of a
/// straight profile. (Next to none if s < 0. In a bed, of nu/h^2 << K, friction goes no further than the pores:
/// its part fades.)
///
/// Between cells it is the face that is shared, by its own covered part c: of the flux w = A U through
/// it, w - c U_w is the air's, and that is what the powder on either side resists. So of a bed along a
/// surface that lies anywhere in a cell, there flows what its open part lets through; and a surface that
/// moves through a cell displaces air as it passes its faces, without pushing it through what is left
/// of the cell: with c of the cell in its place, air that goes with wall and bed seems to slip,
/// by 1 - a of their speed, and its pressure grows without bound until the cell is covered. Of a bed, a
/// face that is covered all over lets through a thousandth; of clear air, that in a covered cell is held
/// so hard that what leaks through a wall is far below the minimum fluidisation velocity. (Brinkman
/// penalisation: Angot, Bruneau & Fabrie, Numer. Math. 81 (1999) 497-520; what becomes of cut cells and
/// faces is ours.)
class SolidsOnMesh
{
public:
    explicit SolidsOnMesh(const Foam::fvMesh& mesh);

    void add(std::unique_ptr<MovingSolid> solid);
    const std::vector<std::unique_ptr<MovingSolid>>& solids() const { return solids_; }
    bool any() const { return !solids_.empty(); }

    /// Poses in the order of solids(). Warns, once for a body, of cells so wide that air leaks
    /// through it there. Same call on all ranks.
    void move(const std::vector<RigidPose>& poses);

    /// A point as the air may see it, at the poses of the last move(). Local.
    MovingSolid::Seen outside(const Foam::vector& point) const;

    const Foam::volScalarField& covered() const { return covered_; } ///< c, [0, 1]
    const Foam::volVectorField& velocity() const { return velocity_; } ///< U_w [m/s]

    /// A of a cell, from a.
    Foam::tmp<Foam::volScalarField> ofWholeCells(const Foam::volScalarField& voidFraction) const;

    /// u, from U and a: the air that the powder meets. Where less than a tenth of a cell is left to
    /// air, as if it were a tenth.
    Foam::tmp<Foam::volVectorField> airInOpenPart(
        const Foam::volVectorField& U, const Foam::volScalarField& voidFraction) const;

    /// By what the surface holds the clear air of a cell to velocity(), nu A/h^2 (h/s - 1), and in covered
    /// ones the grip [1/s].
    Foam::tmp<Foam::volScalarField> friction(
        const Foam::volScalarField& voidFraction, const Foam::volScalarField& nu) const;

    /// From K/rho and its source, per open volume, to all that the air of a cell meets, with friction() that
    /// fades where there is a bed [1/s, m/s2].
    void share(const Foam::volScalarField& voidFraction, const Foam::volScalarField& nu,
        const Foam::volScalarField& friction, Foam::volScalarField& resistance,
        Foam::volVectorField& source) const;

    /// Of each face, on the way since the move before: what a flux passes through in a step.
    Foam::tmp<Foam::surfaceScalarField> openFaces() const; ///< 1 - c, more than zero
    const Foam::surfaceScalarField& flux() const { return flux_; } ///< U_w . S [m3/s]

private:
    void warnOfLeak(std::size_t solid, Foam::scalar widest);
    void moveFaces(const std::vector<RigidPose>& before);

    const Foam::fvMesh& mesh_;
    Foam::scalar coarsest_; // width of a cell, of all ranks [m]
    std::vector<std::unique_ptr<MovingSolid>> solids_;
    std::vector<bool> mayLeak_; // in some cell of the mesh, and it has not been said
    std::vector<RigidPose> poses_;
    Foam::scalarField depth_; // covered fraction, on below zero to -1/2 (see MovingSolid)
    Foam::volScalarField covered_;
    Foam::volVectorField velocity_;
    Foam::surfaceScalarField depthOfFaces_; // as depth_, on the way since the move before
    Foam::surfaceScalarField flux_;
};

} // namespace interstice
