// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/MovingSolid.hpp"

namespace interstice
{

/// All rigid bodies that the air sees, as three fields: what they cover, how they move, and how
/// hard they hold the air.
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

    const Foam::volScalarField& covered() const { return covered_; } ///< [0, 1]
    const Foam::volVectorField& velocity() const { return velocity_; } ///< [m/s]

    /// Coefficient of the Brinkman force resistance (velocity - U), per mass of air [1/s]:
    /// zero where nothing is covered. See MovingSolid.
    Foam::tmp<Foam::volScalarField> resistance() const;

private:
    void warnOfLeak(std::size_t solid, Foam::scalar widest);

    const Foam::fvMesh& mesh_;
    Foam::scalar coarsest_; // width of a cell, of all ranks [m]
    std::vector<std::unique_ptr<MovingSolid>> solids_;
    std::vector<bool> mayLeak_; // in some cell of the mesh, and it has not been said
    std::vector<RigidPose> poses_;
    Foam::volScalarField covered_;
    Foam::volVectorField velocity_;
};

} // namespace interstice
