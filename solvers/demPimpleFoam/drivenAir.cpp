// SPDX-License-Identifier: GPL-3.0-or-later
#include "AirFlow.hpp"

#include <algorithm>
#include <initializer_list>

namespace interstice
{

using namespace Foam;

namespace
{

bool among(const word& type, std::initializer_list<const char*> types)
{
    return std::find(types.begin(), types.end(), type) != types.end();
}

} // namespace

// What is not known to leave the air at rest counts as a drive: a condition that follows a table may be zero now.
bool AirFlow::driven() const
{
    bool moved = gMax(mag(U_.primitiveField())) > 0 || gMax(mag(bodyForce_.primitiveField())) > 0;
    for (const fvPatchVectorField& patch : U_.boundaryField())
    {
        const bool quiet = patch.coupled()
            || among(patch.type(), {"fixedValue", "noSlip", "slip", "symmetry", "symmetryPlane", "empty", "zeroGradient",
                                       "inletOutlet", "pressureInletOutletVelocity"});
        moved = moved || !quiet || (!patch.coupled() && patch.size() && max(mag(patch)) > 0);
    }
    scalar low = GREAT;
    scalar high = -GREAT;
    for (const fvPatchScalarField& patch : p_.boundaryField())
    {
        if (patch.type() == "fixedValue" && patch.size())
        {
            low = min(low, min(patch));
            high = max(high, max(patch));
        }
        moved = moved
            || !(patch.coupled()
                || among(patch.type(), {"fixedValue", "zeroGradient", "slip", "symmetry", "symmetryPlane", "empty",
                                           "fixedFluxPressure"}));
    }
    reduce(low, minOp<scalar>());
    reduce(high, maxOp<scalar>());
    return returnReduce(moved, orOp<bool>()) || high > low;
}

} // namespace interstice
