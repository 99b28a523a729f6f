// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

namespace interstice::dem
{

/// [m^2]
double areaOf(const Triangle& triangle);

/// Whether two triangles have sides of the same lengths, node by node, to a millionth.
bool congruent(const Triangle& a, const Triangle& b);

/// The motion of a rigid body that carries a triangle from `before` to `now` [m], with the
/// present velocities [m/s] of its three nodes. Exact to round-off for a triangle that has kept
/// its shape; the triangle must have an area.
WallPose rigidMotion(const Triangle& before, const Triangle& now, const Triangle& velocities);

} // namespace interstice::dem
