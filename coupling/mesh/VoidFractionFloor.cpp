// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/VoidFractionFloor.hpp"

#include "PstreamReduceOps.H"
#include "volFields.H"

namespace interstice
{

using namespace Foam;

namespace
{

// Excess walks one cell a round; more rounds than this mean that the room is used up.
constexpr int mostRounds = 200;

} // namespace

VoidFractionFloor::VoidFractionFloor(const fvMesh& mesh, const CellHalo& halo, double minimum)
:
    halo_(halo),
    volumes_(mesh.V().field()),
    minimum_(minimum)
{}

VoidFractionFloor::Report VoidFractionFloor::apply(scalarField& solids) const
{
    const double most = 1 - minimum_;
    Report report;
    scalarField excess(solids.size(), Zero); // volume [m3]
    double total = 0;
    forAll(solids, celli)
    {
        if (solids[celli] > most)
        {
            excess[celli] = (solids[celli] - most)*volumes_[celli];
            solids[celli] = most;
            total += excess[celli];
            ++report.cells;
        }
    }
    reduce(report.cells, sumOp<int>());
    if (report.cells == 0)
    {
        return report;
    }
    reduce(total, sumOp<double>());

    double left = total;
    for (int round = 0; round < mostRounds && left > 1e-14*total; ++round)
    {
        left = spread(solids, excess);
    }
    report.clipped = left > 1e-14*total ? left : 0;
    report.moved = total - report.clipped;
    return report;
}

// One round: each cell's excess goes to its face neighbours in proportion to their room (walks on
// unchanged in equal shares where none has any); they keep what fits. Returns what is left.
double VoidFractionFloor::spread(scalarField& solids, scalarField& excess) const
{
    const double most = 1 - minimum_;
    const label own = halo_.nCells();
    constexpr double someRoom = 1e-9; // lets excess walk through full cells

    List<Packed<2>> outgoing(own, Packed<2>(Zero)); // room, share of excess per room
    scalarField room(own, Zero);
    forAll(room, celli)
    {
        outgoing[celli][0] = ((most - solids[celli]) + someRoom)*volumes_[celli];
    }
    halo_.toGhosts(outgoing);
    for (const CellHalo::Link& link : halo_.links())
    {
        room[link.cell] += outgoing[link.other][0];
        if (link.internal)
        {
            room[link.other] += outgoing[link.cell][0];
        }
    }
    for (label celli = 0; celli < own; ++celli)
    {
        outgoing[celli][1] = room[celli] > 0 ? excess[celli]/room[celli] : 0;
    }
    outgoing.setSize(own);
    halo_.toGhosts(outgoing);

    scalarField arriving(own, Zero);
    for (const CellHalo::Link& link : halo_.links())
    {
        arriving[link.cell] += outgoing[link.other][1]*outgoing[link.cell][0];
        if (link.internal)
        {
            arriving[link.other] += outgoing[link.cell][1]*outgoing[link.other][0];
        }
    }
    double left = 0;
    for (label celli = 0; celli < own; ++celli)
    {
        const double kept = room[celli] > 0 ? 0 : excess[celli];
        const double volume = solids[celli]*volumes_[celli] + arriving[celli] + kept;
        solids[celli] = min(volume/volumes_[celli], most);
        excess[celli] = max(volume - most*volumes_[celli], scalar(0));
        left += excess[celli];
    }
    reduce(left, sumOp<double>());
    return left;
}

} // namespace interstice
