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

// How much less a cell attracts excess than the room next to it, and so on from cell to cell: full
// cells pass it on towards the nearest room. Without a direction it would stroll about, and a
// cluster n cells thick would take n^2 rounds.
constexpr double attractionPerCell = 0.01;

} // namespace

VoidFractionFloor::VoidFractionFloor(const fvMesh& mesh, const CellHalo& halo, double minimum)
:
    halo_(halo),
    volumes_(mesh.V().field()),
    minimum_(minimum),
    open_(halo.size(), 1.0)
{}

VoidFractionFloor::Report VoidFractionFloor::apply(scalarField& solids)
{
    handedOn_.clear();
    rounds_.clear();
    const double most = 1 - minimum_;
    Report report;
    scalarField excess(solids.size(), Zero); // volume [m3]
    double total = 0;
    forAll(solids, celli)
    {
        if (solids[celli] > most)
        {
            excess[celli] = (solids[celli] - most)*volumes_[celli];
            handedOn_.push_back({celli, 1 - most/solids[celli]});
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
    scalarField attraction(solids.size(), Zero);
    for (int round = 0; round < mostRounds && left > 1e-14*total; ++round)
    {
        left = spread(solids, excess, attraction);
    }
    report.clipped = left > 1e-14*total ? left : 0;
    report.moved = total - report.clipped;
    return report;
}

// One round: each cell's excess goes to its face neighbours in proportion to their attraction; they
// keep what fits. Returns what is left.
double VoidFractionFloor::spread(scalarField& solids, scalarField& excess,
    scalarField& attraction)
{
    Round& record = rounds_.emplace_back();
    const double most = 1 - minimum_;
    const label own = halo_.nCells();

    List<Packed<2>> outgoing(own, Packed<2>(Zero)); // attraction, share of excess per attraction
    scalarField strongest(own, Zero); // of the neighbours
    scalarField around(own, Zero); // sum of the neighbours
    forAll(attraction, celli)
    {
        const double room = (most - solids[celli])*volumes_[celli];
        outgoing[celli][0] = open_[celli]*max(room, attraction[celli]);
    }
    halo_.toGhosts(outgoing);
    const auto attract = [&](label cell, label other)
    {
        strongest[cell] = max(strongest[cell], outgoing[other][0]);
        around[cell] += outgoing[other][0];
    };
    for (const CellHalo::Link& link : halo_.links())
    {
        attract(link.cell, link.other);
        if (link.internal)
        {
            attract(link.other, link.cell);
        }
    }
    attraction = attractionPerCell*strongest;
    for (label celli = 0; celli < own; ++celli)
    {
        outgoing[celli][1] = around[celli] > VSMALL ? excess[celli]/around[celli] : 0;
    }
    outgoing.setSize(own);
    halo_.toGhosts(outgoing);

    scalarField arriving(own, Zero);
    const auto send = [&](label from, label to)
    {
        if (excess[from] > 0 && around[from] > VSMALL)
        {
            record.transfers.push_back({from, to, outgoing[to][0]/around[from]});
        }
    };
    for (const CellHalo::Link& link : halo_.links())
    {
        arriving[link.cell] += outgoing[link.other][1]*outgoing[link.cell][0];
        send(link.cell, link.other);
        if (link.internal)
        {
            arriving[link.other] += outgoing[link.cell][1]*outgoing[link.other][0];
            send(link.other, link.cell);
        }
    }
    double left = 0;
    for (label celli = 0; celli < own; ++celli)
    {
        if (excess[celli] > 0 && around[celli] <= VSMALL)
        {
            arriving[celli] += excess[celli]; // nowhere to go
            record.transfers.push_back({celli, celli, 1});
        }
        const double volume = solids[celli]*volumes_[celli] + arriving[celli];
        solids[celli] = min(volume/volumes_[celli], most);
        excess[celli] = max(volume - most*volumes_[celli], scalar(0));
        if (excess[celli] > 0)
        {
            record.kept.push_back({celli, 1 - min(excess[celli]/arriving[celli], 1.0)});
        }
        left += excess[celli];
    }
    reduce(left, sumOp<double>());
    return left;
}

} // namespace interstice
