// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/CellHalo.hpp"
#include "coupling/mesh/OpenVolumes.hpp"

namespace interstice
{

/// Keeps the void fraction of every cell at or above a floor by handing what is too much to
/// neighbouring cells that have room. Powder volume is conserved; what finds no room anywhere
/// stays where it is cut off and is reported, never dropped in silence.
///
/// The powder of a cell is mixed: each grain in it is moved in the same shares. So what acts on the
/// cells that the air sees it in acts on the grain, by adjoint().
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

    /// Local. `open`: uncovered fraction of each cell; solids are per open volume from now on.
    void close(const Foam::scalarList& open) { volumes_ = openVolumes(mesh_, open); }

    /// Collective. `solids`: fraction of powder in the open volume, nCells long; changed in place.
    Report apply(Foam::scalarField& solids);

    /// Collective. The adjoint of the last apply() as a map of volumes: of `values` (intensities, nCells
    /// long, changed in place) each cell gets the mean over the cells that hold its powder. Cut off
    /// powder gets zero. The sum of volume times value is the same before apply() and after it.
    template<unsigned N>
    void adjoint(Foam::List<Packed<N>>& values) const;

    double minimum() const { return minimum_; }

private:
    struct CellShare
    {
        Foam::label cell;
        double share;
    };
    struct Transfer
    {
        Foam::label from; // own
        Foam::label to; // compact
        double share; // of the excess of `from`
    };
    struct Round
    {
        std::vector<Transfer> transfers;
        std::vector<CellShare> kept; // of what arrives; all of it in cells that are not listed
    };

    struct Pull
    {
        Foam::List<Packed<1>> of; // each cell, own and ghosts [m3]
        Foam::scalarField strongest; // of its neighbours
        Foam::scalarField around; // sum of its neighbours
    };

    Pull pull(const Foam::scalarField& solids, const Foam::scalarField& behind) const;
    double spread(Foam::scalarField& solids, Foam::scalarField& excess, Foam::scalarField& behind);

    const Foam::fvMesh& mesh_;
    const CellHalo& halo_;
    Foam::scalarField volumes_; // open
    double minimum_;
    std::vector<CellShare> handedOn_; // of what was deposited
    std::vector<Round> rounds_;
};

template<unsigned N>
void VoidFractionFloor::adjoint(Foam::List<Packed<N>>& values) const
{
    if (rounds_.empty())
    {
        return;
    }
    const auto blend = [](const Packed<N>& a, double share, const Packed<N>& b)
    {
        Packed<N> both;
        for (unsigned n = 0; n < N; ++n)
        {
            both[n] = (1 - share)*a[n] + share*b[n];
        }
        return both;
    };
    // What the excess of each cell will see from a round on. From the last round: nothing.
    Foam::List<Packed<N>> excess(halo_.nCells(), Packed<N>(Foam::Zero));
    for (auto round = rounds_.rbegin(); round != rounds_.rend(); ++round)
    {
        Foam::List<Packed<N>> arriving(values);
        for (const CellShare& part : round->kept)
        {
            arriving[part.cell] = blend(excess[part.cell], part.share, values[part.cell]);
        }
        halo_.toGhosts(arriving);
        excess = Packed<N>(Foam::Zero);
        for (const Transfer& transfer : round->transfers)
        {
            for (unsigned n = 0; n < N; ++n)
            {
                excess[transfer.from][n] += transfer.share*arriving[transfer.to][n];
            }
        }
    }
    for (const CellShare& part : handedOn_)
    {
        values[part.cell] = blend(values[part.cell], part.share, excess[part.cell]);
    }
}

} // namespace interstice
