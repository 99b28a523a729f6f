// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/VoidFractionFloor.hpp"

#include "PstreamReduceOps.H"
#include "volFields.H"

namespace interstice
{

using namespace Foam;

namespace
{

// Excess walks one cell a round; more rounds than this mean that it cannot reach the room there is.
constexpr int mostRounds = 500;

// A cell draws excess by its own room, and by so much of what its neighbours draw by: full cells pass
// it on towards the nearest room. Without a direction it would stroll about, and a cluster n cells
// thick would take n^2 rounds.
constexpr double pullPerCell = 0.25;

// Cells from which room draws before anything is moved. If only the next ones did, all excess would go
// to whichever side has the first trace of room, and jump as powder moves.
constexpr int farthestRoom = 6;

} // namespace

VoidFractionFloor::VoidFractionFloor(const fvMesh& mesh, const CellHalo& halo, double minimum)
:
    mesh_(mesh),
    halo_(halo),
    volumes_(mesh.V().field()),
    minimum_(minimum)
{}

VoidFractionFloor::Report VoidFractionFloor::apply(scalarField& solids)
{
    handedOn_.clear();
    rounds_.clear();
    const double most = 1 - minimum_;
    Report report;
    scalarField excess(solids.size(), Zero); // volume [m3]
    double total = 0;
    double room = 0;
    forAll(solids, celli)
    {
        room += max(most - solids[celli], scalar(0))*volumes_[celli];
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
    reduce(room, sumOp<double>());

    scalarField behind(solids.size(), Zero);
    for (int cell = 0; cell < farthestRoom; ++cell)
    {
        behind = pullPerCell*pull(solids, behind).strongest;
    }
    const double negligible = 1e-14*total;
    double left = total;
    int round = 0;
    do
    {
        left = spread(solids, excess, behind);
    }
    while (left > negligible && room - (total - left) > negligible && ++round < mostRounds);
    report.clipped = left > negligible ? left : 0;
    report.moved = total - report.clipped;
    return report;
}

// By what each cell draws excess [m3]: its room, and what draws from `behind`.
VoidFractionFloor::Pull VoidFractionFloor::pull(const scalarField& solids,
    const scalarField& behind) const
{
    const double most = 1 - minimum_;
    const label own = halo_.nCells();
    Pull result{List<Packed<1>>(own), scalarField(own, Zero), scalarField(own, Zero)};
    for (label celli = 0; celli < own; ++celli)
    {
        const double room = (most - solids[celli])*volumes_[celli];
        const bool closed = volumes_[celli] < 2*leastOpen*mesh_.V()[celli];
        result.of[celli][0] = closed ? 0 : room + behind[celli];
    }
    halo_.toGhosts(result.of);
    const auto draw = [&](label cell, label other)
    {
        const double strength = result.of[other][0];
        result.strongest[cell] = max(result.strongest[cell], strength);
        result.around[cell] += strength;
    };
    for (const CellHalo::Link& link : halo_.links())
    {
        draw(link.cell, link.other);
        if (link.internal)
        {
            draw(link.other, link.cell);
        }
    }
    return result;
}

// One round: each cell's excess goes to its face neighbours in proportion to their pull; they keep what
// fits. Returns what is left.
double VoidFractionFloor::spread(scalarField& solids, scalarField& excess, scalarField& behind)
{
    Round& record = rounds_.emplace_back();
    const double most = 1 - minimum_;
    const label own = halo_.nCells();

    const Pull drawing = pull(solids, behind);
    const scalarField& around = drawing.around;
    behind = pullPerCell*drawing.strongest;
    List<Packed<1>> offered(own); // excess per pull
    for (label celli = 0; celli < own; ++celli)
    {
        offered[celli][0] = around[celli] > VSMALL ? excess[celli]/around[celli] : 0;
    }
    halo_.toGhosts(offered);

    scalarField arriving(own, Zero);
    const auto send = [&](label from, label to)
    {
        if (excess[from] > 0 && around[from] > VSMALL)
        {
            record.transfers.push_back({from, to, drawing.of[to][0]/around[from]});
        }
    };
    for (const CellHalo::Link& link : halo_.links())
    {
        arriving[link.cell] += offered[link.other][0]*drawing.of[link.cell][0];
        send(link.cell, link.other);
        if (link.internal)
        {
            arriving[link.other] += offered[link.cell][0]*drawing.of[link.other][0];
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
        const double room = max((most - solids[celli])*volumes_[celli], scalar(0));
        excess[celli] = max(arriving[celli] - room, scalar(0));
        solids[celli] = excess[celli] > 0 ? most : solids[celli] + arriving[celli]/volumes_[celli];
        if (excess[celli] > 0)
        {
            record.kept.push_back({celli, room/arriving[celli]});
        }
        left += excess[celli];
    }
    reduce(left, sumOp<double>());
    return left;
}

} // namespace interstice
