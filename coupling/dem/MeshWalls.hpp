// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

namespace LAMMPS_NS
{
class LAMMPS;
class FixMeshSurface;
} // namespace LAMMPS_NS

namespace interstice::dem
{

/// The triangulated walls of a LIGGGHTS run, and how far each has moved as a rigid body.
///
/// LIGGGHTS spreads a mesh over the ranks and moves its nodes step by step; it keeps no pose.
/// The pose is therefore read off one triangle of each wall, the largest.
class MeshWalls
{
public:
    MeshWalls(LAMMPS_NS::LAMMPS& liggghts, MPI_Comm communicator);

    /// Records walls not yet known, where they are. Collective, after LIGGGHTS was set up.
    void record();

    /// The largest triangle of each wall. Collective.
    std::map<std::string, WallMarker> markers() const;

    /// Of the walls that are known and still there. Collective.
    std::map<std::string, WallPose> poses() const;

    /// Gives the nodes of walls the velocities of rigid bodies; walls at rest stay as they are. Local.
    void setVelocities(const std::map<std::string, WallPose>& motion);

    /// From now on poses count from where the walls lay in a run before, not from where they were
    /// recorded, and the walls move as they did there. Throws InputError if a marker is not the same
    /// triangle. Collective, after record().
    void countFrom(const std::map<std::string, WallMarker>& markers);

    /// In the order of the script. Local.
    std::vector<std::string> ids() const;

    /// As they lay when recorded. Collective for the error's sake only.
    std::vector<Triangle> triangles(const std::string& id) const;

    /// Collective.
    WallPose pose(const std::string& id) const;

private:
    struct Wall
    {
        std::map<int, Triangle> triangles; ///< all, by LIGGGHTS' number
        WallMarker marker;               ///< the largest
    };

    std::vector<LAMMPS_NS::FixMeshSurface*> surfaces() const;
    const Wall& wall(const std::string& id) const;
    Wall gather(LAMMPS_NS::FixMeshSurface& surface) const;
    LAMMPS_NS::FixMeshSurface& surface(const std::string& id) const;

    /// Nodes and velocities of a wall's marker, on all ranks.
    struct MarkerNow
    {
        Triangle nodes{};
        Triangle velocities{};
    };
    MarkerNow markerNow(const std::string& id) const;

    LAMMPS_NS::LAMMPS& liggghts_;
    MPI_Comm communicator_;
    std::map<std::string, Wall> walls_;
};

} // namespace interstice::dem
