// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/PowderCloud.hpp"

#include "Cloud.H"
#include "IOField.H"
#include "fvMesh.H"
#include "passiveParticle.H"
#include "polyMeshTetDecomposition.H"

namespace interstice
{

using namespace Foam;

namespace
{

using PassiveCloud = Cloud<passiveParticle>;

vector toFoam(const Vec3& v)
{
    return vector(v[0], v[1], v[2]);
}

/// Puts a particle into the tetrahedron of its cell that holds it, or is nearest to holding it.
/// OpenFOAM's own search tracks from the cell's centre and moves what lies behind a wall.
passiveParticle* placed(const fvMesh& mesh, const vector& position, label cell)
{
    tetIndices best;
    barycentric coordinates;
    scalar depth = -GREAT;
    for (const tetIndices& tet : polyMeshTetDecomposition::cellTetIndices(mesh, cell))
    {
        barycentric b;
        tet.tet(mesh).pointToBarycentric(position, b);
        if (cmptMin(b) > depth)
        {
            depth = cmptMin(b);
            coordinates = b;
            best = tet;
        }
    }
    return new passiveParticle(mesh, coordinates, cell, best.face(), best.tetPt());
}

template<class Type, class Value>
void writeField(const PassiveCloud& cloud, const char* name,
    const std::vector<CloudParcel>& parcels, const Value& value)
{
    IOField<Type> field(cloud.fieldIOobject(name, IOobject::NO_READ), cloud.size());
    forAll(field, i)
    {
        field[i] = value(parcels[i]);
    }
    field.write(!field.empty());
}

} // namespace

void writePowderCloud(const fvMesh& mesh, const std::vector<CloudParcel>& parcels,
    const std::vector<int>& cells)
{
    PassiveCloud cloud(mesh, "powder", IDLList<passiveParticle>());
    for (std::size_t i = 0; i < parcels.size(); ++i)
    {
        passiveParticle* particle = placed(mesh, toFoam(parcels[i].position), cells[i]);
        particle->origProc() = 0;
        particle->origId() = parcels[i].id;
        cloud.addParticle(particle);
    }
    cloud.writeObject(mesh.time().writeFormat(), IOstream::currentVersion,
        mesh.time().writeCompression(), true);

    using P = CloudParcel;
    writeField<scalar>(cloud, "d", parcels, [](const P& p) { return p.diameter; });
    writeField<scalar>(cloud, "mass", parcels, [](const P& p) { return p.mass; });
    writeField<label>(cloud, "id", parcels, [](const P& p) { return p.id; });
    writeField<vector>(cloud, "U", parcels, [](const P& p) { return toFoam(p.velocity); });
    writeField<vector>(cloud, "drag", parcels, [](const P& p) { return toFoam(p.drag); });
    writeField<vector>(
        cloud, "pressureForce", parcels, [](const P& p) { return toFoam(p.pressureForce); });
}

} // namespace interstice
