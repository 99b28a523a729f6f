// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/RigidPose.hpp"

#include "fvMesh.H"
#include "volFields.H"

#include <string>
#include <vector>

namespace Foam
{
class triSurfaceMesh;
}

namespace interstice
{

/// A rigid body that moves through a static mesh, as the air sees it.
///
/// The closed surface is turned once into a table of signed distances in its own frame; at any
/// pose, the covered fraction of a cell follows from the distance of its centre: a ramp as wide as
/// the cell, continuous in the pose. Where cells are covered the air is held to the body's velocity
/// by a resistance
///
///     sigma = (stiffness^covered - 1)/holdTime                    [1/s]
///
/// whose logarithm is linear in the covered fraction, so that nothing switches when the body
/// creeps into a cell (Brinkman penalisation: Angot, Bruneau & Fabrie, Numer. Math. 81 (1999)
/// 497-520; the ramp is ours).
/// A cell that is covered by a few per cent holds its air already, so that the air sees the body
/// larger by up to half a cell on each side (what it costs: foam_cases/dieFilling/studies).
class MovingSolid
{
public:
    /// Reads a closed triangulated surface [m], in the reference place of its pose. Same call on
    /// all ranks. Throws InputError if the file is missing, the surface open, or thinner than two
    /// of the finest cells (air would leak through it wherever it goes).
    MovingSolid(const Foam::fvMesh& mesh, const std::string& name, const Foam::fileName& surface,
        const std::string& where);

    const std::string& name() const { return name_; }

    /// Where it is thinnest [m].
    Foam::scalar thickness() const { return thickness_; }

    /// Whether cells as wide [m] let air leak through it.
    bool leaksIn(Foam::scalar width) const { return thickness_ < 1.99*width; }

    /// A point as the air may see it.
    struct Seen
    {
        Foam::vector position; ///< the point itself, or the nearest one on the surface [m]
        Foam::scalar presence; ///< 1 outside; falls to 0 as the point sinks half a cell deep
    };

    /// What sinks into a body would move air that cannot move: it fades from the air's sight, and
    /// meanwhile is seen on the surface. Local.
    Seen outside(const RigidPose& pose, const Foam::vector& point) const;

    /// Adds this body at a pose to the covered fraction of each cell (largest body wins) and
    /// sets the wall velocity [m/s] where it covers something. Returns the widest of the cells that
    /// its surface crosses [m], 0 if it crosses none. Local.
    Foam::scalar cover(const RigidPose& pose, Foam::volScalarField& covered,
        Foam::volVectorField& velocity) const;

private:
    /// Signed distance [m], negative inside, at the nodes of a box around the body.
    struct DistanceTable
    {
        Foam::vector low;
        Foam::scalar spacing;
        int nodes[3];
        std::vector<float> distance;

        Foam::scalar at(const Foam::vector& point) const; ///< `far` outside the box
        Foam::vector gradient(const Foam::vector& point) const; ///< inside the body
        static constexpr Foam::scalar far = 1e30;
    };

    void tabulate(const Foam::fileName& surface, const std::string& where);
    void tabulateLayer(const Foam::triSurfaceMesh& surface, int k);

    const Foam::fvMesh& mesh_;
    std::string name_;
    std::vector<Foam::scalar> width_; // of the ramp in each cell [m]
    Foam::scalar thickness_;
    DistanceTable table_;
};

} // namespace interstice
