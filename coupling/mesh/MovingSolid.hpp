// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/RigidPose.hpp"

#include "fvMesh.H"
#include "volFields.H"

#include <array>
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
/// The closed surface is turned once into a table of signed distances in its own frame. At any pose,
/// the covered fraction of a cell is the mean of eight points' in it, each a ramp of the distance as
/// wide as an eighth of the cell is across the surface; that of a face the mean of four points' and of the time between two
/// poses. In front of a flat surface along the mesh both are exact: what covers more of a cell has
/// come through its faces. What the air and the powder make of it: SolidsOnMesh.
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

    /// Adds this body at a pose to the covered fraction of each cell (largest body wins), which
    /// goes on below zero, to -1/2 where the surface is a whole cell from the centre; and sets the
    /// wall velocity [m/s] where it does. Returns the widest of the cells that its surface crosses
    /// [m], 0 if it crosses none. Local.
    Foam::scalar cover(const RigidPose& pose, Foam::scalarField& covered,
        Foam::volVectorField& velocity) const;

    /// Covered fraction of a face of the mesh on the way from one pose to the next, on below zero to
    /// -1/2 as that of a cell. Local.
    Foam::scalar coverOfFace(const RigidPose& before, const RigidPose& now, Foam::label facei) const;

private:
    /// Signed distance [m], negative inside, and its slope, at the nodes of a box around the body.
    /// Between nodes, of what each of them would say if the surface were flat; so it is exact in front
    /// of a face, and but little too deep where two faces meet.
    struct DistanceTable
    {
        Foam::vector low;
        Foam::scalar spacing;
        int nodes[3];
        std::vector<std::array<float, 4>> tangents; // distance, slope

        Foam::scalar at(const Foam::vector& point) const; ///< `far` outside the box
        Foam::vector gradient(const Foam::vector& point) const; ///< inside the body
        static constexpr Foam::scalar far = 1e30;
    };

    Foam::scalar distance(const RigidPose& pose, const Foam::vector& point) const;
    Foam::scalar share(const RigidPose& pose, Foam::label celli) const; // see cover
    Foam::scalar extent(Foam::label facei, const Foam::vector& direction) const;
    void tabulate(const Foam::fileName& surface, const std::string& where);
    void tabulateLayer(const Foam::triSurfaceMesh& surface, int k);

    const Foam::fvMesh& mesh_;
    std::string name_;
    std::vector<Foam::scalar> width_; // of each cell [m]
    Foam::vectorField extent_; // along x, y and z [m]
    Foam::scalar thickness_;
    DistanceTable table_;
};

} // namespace interstice
