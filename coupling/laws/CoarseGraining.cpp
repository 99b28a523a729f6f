// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/CoarseGraining.hpp"

#include "coupling/laws/InputError.hpp"

#include <cmath>
#include <sstream>

namespace interstice
{

CoarseGraining::CoarseGraining(double k, const std::string& where) : k_(k)
{
    if (k >= 1 && std::isfinite(k))
    {
        return;
    }

    std::ostringstream found;
    found << k;
    throw InputError(
        {"The coarse-graining factor k is out of its range.", found.str(), "at least 1", where,
            "Set k to 1 to simulate every grain, or above 1 for parcels of k^3 grains."});
}

} // namespace interstice
