// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/CellHalo.hpp"

namespace interstice
{

/// Keeps the void fraction of every cell at or above a floor by handing what is too much to
/// neighbouring cells that have room. Powder volume is conserved; what finds no room anywhere
/// stays where it is cut off and is reported, never dropped in silence.
class VoidFractionFloor
{
public:
    struct Report
    {
        int cells = 0; ///< cells that held too much, all ranks
        double moved = 0; ///< volume handed to neighbours [m3], all ranks
        double clipped = 0; ///< volume that found no room [m3], all ranks: not seen by the air
    };

    /// `minimum`: smallest void fraction allowed, in (0, 1).
    VoidFractionFloor(const Foam::fvMesh& mesh, const CellHalo& halo, double minimum);

    /// Local. `open`: uncovered fraction of each cell (see MovingSolid); no powder is handed into
    /// a solid.
    void close(const Foam::scalarList& open) { open_ = open; }

    /// Collective. `solids`: volume fraction of powder, nCells long; changed in place.
    Report apply(Foam::scalarField& solids) const;

    double minimum() const { return minimum_; }

private:
    double spread(Foam::scalarField& solids, Foam::scalarField& excess,
        Foam::scalarField& attraction) const;

    const CellHalo& halo_;
    const Foam::scalarField& volumes_;
    double minimum_;
    Foam::scalarList open_;
};

} // namespace interstice
