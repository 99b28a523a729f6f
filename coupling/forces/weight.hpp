// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

#include <cmath>

namespace interstice
{

/// Acceleration by which numbers of effects weigh particles: the scene's gravity, or the earth's if it has none
/// [m/s2]. Local.
inline double pullOn(const DemEngine& dem)
{
    const Vector3 g = dem.gravity();
    const double pull = std::sqrt(g[0]*g[0] + g[1]*g[1] + g[2]*g[2]);
    return pull > 0 ? pull : 9.81;
}

} // namespace interstice
