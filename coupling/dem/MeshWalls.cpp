// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/MeshWalls.hpp"

#include "coupling/dem/RigidMotion.hpp"
#include "coupling/laws/InputError.hpp"

#include <lammps.h>

#include <custom_value_tracker.h>
#include <fix_mesh_surface.h>
#include <modify.h>
#include <tri_mesh.h>

#include <algorithm>
#include <array>

namespace interstice::dem
{

namespace
{

/// A triangle's number and its nodes, as it travels.
constexpr int recordSize = 10;

Triangle nodesOf(LAMMPS_NS::TriMesh& mesh, int element)
{
    Triangle nodes{};
    for (int j = 0; j < 3; ++j)
    {
        mesh.node(element, j, nodes[j].data());
    }
    return nodes;
}

using NodeVelocities = LAMMPS_NS::MultiVectorContainer<double, 3, 3>;

/// None for a wall that nothing moves.
NodeVelocities* velocitiesOf(LAMMPS_NS::TriMesh& mesh)
{
    return mesh.prop().getElementProperty<NodeVelocities>("v");
}

} // namespace

MeshWalls::MeshWalls(LAMMPS_NS::LAMMPS& liggghts, MPI_Comm communicator)
    : liggghts_(liggghts), communicator_(communicator)
{
}

std::vector<LAMMPS_NS::FixMeshSurface*> MeshWalls::surfaces() const
{
    std::vector<LAMMPS_NS::FixMeshSurface*> found;
    for (int i = 0; i < liggghts_.modify->nfix; ++i)
    {
        if (auto* surface = dynamic_cast<LAMMPS_NS::FixMeshSurface*>(liggghts_.modify->fix[i]))
        {
            found.push_back(surface);
        }
    }
    return found;
}

std::vector<std::string> MeshWalls::ids() const
{
    std::vector<std::string> names;
    for (const LAMMPS_NS::FixMeshSurface* surface : surfaces())
    {
        names.emplace_back(surface->id);
    }
    return names;
}

void MeshWalls::record()
{
    for (LAMMPS_NS::FixMeshSurface* surface : surfaces())
    {
        if (walls_.count(surface->id) == 0)
        {
            walls_[surface->id] = gather(*surface);
        }
    }
}

std::map<std::string, WallMarker> MeshWalls::markers() const
{
    std::map<std::string, WallMarker> found;
    for (const auto& [id, wall] : walls_)
    {
        found[id] = {wall.marker.number, wall.marker.atRest, markerNow(id).velocities};
    }
    return found;
}

std::map<std::string, WallPose> MeshWalls::poses() const
{
    std::map<std::string, WallPose> found;
    for (const std::string& id : ids())
    {
        if (walls_.count(id) > 0)
        {
            found[id] = pose(id);
        }
    }
    return found;
}

void MeshWalls::setVelocities(const std::map<std::string, WallPose>& motion)
{
    for (const auto& [id, pose] : motion)
    {
        LAMMPS_NS::TriMesh& mesh = *surface(id).triMesh();
        NodeVelocities* speeds = velocitiesOf(mesh);
        if (!speeds || (pose.velocity == Vector3{} && pose.angularVelocity == Vector3{}))
        {
            continue;
        }
        for (int i = 0; i < mesh.size(); ++i)
        {
            const Triangle nodes = nodesOf(mesh, i);
            for (int j = 0; j < 3; ++j)
            {
                const Vector3 speed = pose.velocityAt(nodes[j]);
                std::copy_n(speed.data(), 3, (*speeds)(i)[j]);
            }
        }
    }
}

void MeshWalls::countFrom(const std::map<std::string, WallMarker>& markers)
{
    for (auto& [id, wall] : walls_)
    {
        const auto before = markers.find(id);
        const auto now = before == markers.end() ? wall.triangles.end()
                                                 : wall.triangles.find(before->second.number);
        if (now == wall.triangles.end() || !congruent(before->second.atRest, now->second))
        {
            throw InputError({"A run goes on with the walls that it began with.",
                "mesh wall " + id + " has another shape, or is new", "",
                "LIGGGHTS script, fix " + id, "Resume with the same surface files."});
        }
        const WallPose moved =
            rigidMotion(before->second.atRest, now->second, before->second.velocities);
        for (auto& [number, triangle] : wall.triangles)
        {
            for (Vector3& node : triangle)
            {
                node = moved.toReference(node);
            }
        }
        wall.marker = before->second;
        setVelocities({{id, moved}});
    }
}

MeshWalls::Wall MeshWalls::gather(LAMMPS_NS::FixMeshSurface& surface) const
{
    LAMMPS_NS::TriMesh& mesh = *surface.triMesh();
    std::vector<double> mine;
    for (int i = 0; i < mesh.sizeLocal(); ++i)
    {
        mine.push_back(mesh.id(i));
        for (const Vector3& node : nodesOf(mesh, i))
        {
            mine.insert(mine.end(), node.begin(), node.end());
        }
    }

    int ranks = 0;
    MPI_Comm_size(communicator_, &ranks);
    const int size = static_cast<int>(mine.size());
    std::vector<int> sizes(ranks);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator_);
    std::vector<int> offsets(ranks + 1, 0);
    for (int rank = 0; rank < ranks; ++rank)
    {
        offsets[rank + 1] = offsets[rank] + sizes[rank];
    }
    std::vector<double> all(offsets[ranks]);
    MPI_Allgatherv(
        mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), offsets.data(), MPI_DOUBLE,
        communicator_);

    // By number, so that the answer does not depend on the ranks.
    Wall wall;
    for (std::size_t at = 0; at < all.size(); at += recordSize)
    {
        Triangle& triangle = wall.triangles[static_cast<int>(all[at])];
        for (int j = 0; j < 3; ++j)
        {
            std::copy_n(all.data() + at + 1 + 3*j, 3, triangle[j].begin());
        }
    }

    double largest = 0;
    for (const auto& [number, triangle] : wall.triangles)
    {
        const double area = areaOf(triangle);
        if (area > largest)
        {
            largest = area;
            wall.marker = {number, triangle, {}};
        }
    }
    return wall;
}

const MeshWalls::Wall& MeshWalls::wall(const std::string& id) const
{
    const auto found = walls_.find(id);
    const std::vector<std::string> existing = ids();
    if (found == walls_.end()
        || std::find(existing.begin(), existing.end(), id) == existing.end())
    {
        throw unknownName("mesh wall", id, existing, "LIGGGHTS script, fix ... mesh/surface");
    }
    return found->second;
}

std::vector<Triangle> MeshWalls::triangles(const std::string& id) const
{
    std::vector<Triangle> all;
    for (const auto& [number, triangle] : wall(id).triangles)
    {
        all.push_back(triangle);
    }
    return all;
}

WallPose MeshWalls::pose(const std::string& id) const
{
    const MarkerNow now = markerNow(id);
    return rigidMotion(wall(id).marker.atRest, now.nodes, now.velocities);
}

LAMMPS_NS::FixMeshSurface& MeshWalls::surface(const std::string& id) const
{
    return *dynamic_cast<LAMMPS_NS::FixMeshSurface*>(
        liggghts_.modify->find_fix_id(id.c_str()));
}

MeshWalls::MarkerNow MeshWalls::markerNow(const std::string& id) const
{
    const Wall& known = wall(id);
    LAMMPS_NS::TriMesh& mesh = *surface(id).triMesh();
    NodeVelocities* speeds = velocitiesOf(mesh);

    // The owner of the marker fills in what all need: owners, nodes, velocities of the nodes.
    std::array<double, 19> mine{};
    for (int i = 0; i < mesh.sizeLocal(); ++i)
    {
        if (mesh.id(i) == known.marker.number)
        {
            mine[0] += 1;
            for (int j = 0; j < 3; ++j)
            {
                mesh.node(i, j, &mine[1 + 3*j]);
                if (speeds)
                {
                    std::copy_n((*speeds)(i)[j], 3, &mine[10 + 3*j]);
                }
            }
        }
    }
    std::array<double, 19> all{};
    MPI_Allreduce(mine.data(), all.data(), 19, MPI_DOUBLE, MPI_SUM, communicator_);
    if (all[0] != 1)
    {
        throw InputError(
            {"A mesh wall must stay inside the box of the DEM.",
             "the largest triangle of wall " + id + " is no longer there", "",
             "LIGGGHTS script, region and fix move/mesh",
             "Make the box longer in the direction in which the wall moves."});
    }
    MarkerNow now;
    for (int j = 0; j < 3; ++j)
    {
        std::copy_n(&all[1 + 3*j], 3, now.nodes[j].begin());
        std::copy_n(&all[10 + 3*j], 3, now.velocities[j].begin());
    }
    return now;
}

} // namespace interstice::dem
