// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/exchange/Bounds.hpp"

#include <vector>

namespace Foam
{
class fvMesh;
}

namespace interstice
{

/// A particle as it is written to disk.
struct CloudParcel
{
    Vec3 position; ///< [m]
    Vec3 velocity; ///< [m/s]
    Vec3 drag; ///< mean over the last time step [N]
    Vec3 pressureForce; ///< -V grad(p) [N]
    double diameter; ///< [m]
    double mass; ///< [kg]
    int id; ///< of LIGGGHTS
};

/// Writes particles to <time>/lagrangian/powder as a Lagrangian cloud of OpenFOAM, with the fields
/// d, mass, U, drag, pressureForce and id (also as origId). reconstructPar, foamToVTK and ParaView
/// show them with the fields of the air.
///
/// Collective, each rank with the particles of its cells: cells[i] holds parcels[i].
void writePowderCloud(const Foam::fvMesh& mesh, const std::vector<CloudParcel>& parcels,
    const std::vector<int>& cells);

} // namespace interstice
