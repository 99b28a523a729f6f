// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/Smoothing.hpp"

#include "coupling/mesh/OpenVolumes.hpp"

#include "PstreamReduceOps.H"
#include "volFields.H"

#include <algorithm>
#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

// Largest share of a cell that one sweep may exchange: below 1/2 the operator is positive, so
// that repeated sweeps damp every wave without changing its sign.
constexpr double largestExchange = 0.4;

} // namespace

Smoothing::Smoothing(const fvMesh& mesh, const CellHalo& halo, double width)
:
    halo_(halo),
    mesh_(mesh),
    volumes_(mesh.V().field()),
    links_(halo.links())
{
    scalarField exchange(halo.nCells(), Zero); // per diffusivity times time [1/m2]
    for (const CellHalo::Link& link : halo.links())
    {
        exchange[link.cell] += link.conductance/volumes_[link.cell];
        if (link.internal)
        {
            exchange[link.other] += link.conductance/volumes_[link.other];
        }
    }
    const double total = width*width/4;
    sweeps_ = static_cast<int>(std::ceil(total*gMax(exchange)/largestExchange));
    perSweep_ = sweeps_ > 0 ? total/sweeps_ : 0;

    List<DynamicList<label>> neighbours(halo.nCells());
    for (const CellHalo::Link& link : halo.links())
    {
        neighbours[link.cell].append(link.other);
        if (link.internal)
        {
            neighbours[link.other].append(link.cell);
        }
    }
    neighbours_.setSize(halo.nCells());
    forAll(neighbours, celli)
    {
        neighbours_[celli].transfer(neighbours[celli]);
    }
    reached_.assign(halo.size(), 1);
    close(scalarList(halo.size(), 1.0));
}

void Smoothing::close(const scalarList& open)
{
    volumes_ = openVolumes(mesh_, open);
    const std::vector<CellHalo::Link>& faces = halo_.links();
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        const double passage = std::min(open[faces[i].cell], open[faces[i].other]);
        links_[i].conductance = perSweep_*faces[i].conductance*passage;
    }
    gather();
}

// A sweep moves what it smooths by one link. What lies on other ranks, near cells that they share with this one, is not
// known here: those cells count as asked for.
void Smoothing::reach(const std::vector<int>& cells)
{
    reached_.assign(halo_.size(), 0);
    std::vector<label> front;
    const auto enter = [&](label cell)
    {
        if (!reached_[cell])
        {
            reached_[cell] = 1;
            if (cell < halo_.nCells())
            {
                front.push_back(cell);
            }
        }
    };
    std::for_each(cells.begin(), cells.end(), enter);
    std::for_each(halo_.shared().begin(), halo_.shared().end(), enter);
    for (label ghost = halo_.nCells(); ghost < halo_.size(); ++ghost)
    {
        enter(ghost);
    }
    for (int sweep = 0; sweep < sweeps_; ++sweep)
    {
        const std::vector<label> before = std::exchange(front, {});
        for (const label cell : before)
        {
            std::for_each(neighbours_[cell].begin(), neighbours_[cell].end(), enter);
        }
    }
    gather();
}

void Smoothing::gather()
{
    cells_.clear();
    for (label cell = 0; cell < halo_.nCells(); ++cell)
    {
        if (reached_[cell])
        {
            cells_.push_back(cell);
        }
    }
    between_.clear();
    for (const CellHalo::Link& link : links_)
    {
        if (reached_[link.cell] && reached_[link.other])
        {
            between_.push_back(link);
        }
    }
}

} // namespace interstice
