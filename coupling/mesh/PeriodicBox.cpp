// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/PeriodicBox.hpp"

#include "coupling/laws/InputError.hpp"

#include "PstreamReduceOps.H"
#include "boundBox.H"
#include "coupledPolyPatch.H"

namespace interstice
{

using namespace Foam;

PeriodicBox::PeriodicBox(const polyMesh& mesh)
:
    min_(mesh.bounds().min()),
    period_(Zero)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* coupled = isA<coupledPolyPatch>(patch) ? &refCast<const coupledPolyPatch>(patch)
                                                           : nullptr;
        if (!coupled || !coupled->separated())
        {
            continue;
        }
        for (const vector& shift : coupled->separation())
        {
            for (direction d = 0; d < 3; ++d)
            {
                period_[d] = max(period_[d], mag(shift[d]));
            }
        }
    }
    reduce(period_, maxOp<vector>());

    // A shift along an axis is as long as the mesh there; anything else is no translation of a box.
    const vector span = mesh.bounds().span();
    for (direction d = 0; d < 3; ++d)
    {
        const bool tiny = period_[d] < 1e-9*mag(span);
        if (tiny)
        {
            period_[d] = 0;
        }
        else if (mag(period_[d] - span[d]) > 1e-6*span[d])
        {
            throw InputError({"A cyclic patch pair must be a translation of the whole mesh along an axis.",
                "a shift of " + std::to_string(period_[d]) + " m along axis " + std::to_string(d),
                std::to_string(span[d]) + " m, the length of the mesh", "constant/polyMesh/boundary",
                "Make the periodic direction parallel to x, y or z and the mesh a box there."});
        }
    }
}

} // namespace interstice
