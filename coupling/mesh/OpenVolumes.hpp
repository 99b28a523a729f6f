// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volFields.H"

namespace interstice
{

/// A cell is taken as open by no less than this, so that what there is per open volume stays finite.
constexpr double leastOpen = 1e-6;

/// Volume [m3] of each own cell that solids leave to powder and air. `open`: uncovered fraction of
/// each cell, own ones first. Densities of powder (solids, drag, what it gives to the air) are per
/// this volume: a cell that a solid cuts holds powder as dense as its neighbours do.
inline Foam::scalarField openVolumes(const Foam::fvMesh& mesh, const Foam::scalarList& open)
{
    Foam::scalarField volumes(mesh.V().field());
    forAll(volumes, celli)
    {
        volumes[celli] *= Foam::max(open[celli], leastOpen);
    }
    return volumes;
}

} // namespace interstice
