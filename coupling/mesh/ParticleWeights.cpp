// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/ParticleWeights.hpp"

#include "coupling/laws/InputError.hpp"

#include <algorithm>
#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

// By how much the hat of a cell counts that a solid cuts: powder spread evenly up to a flat surface
// along the mesh must leave the same density in the cut cell as in the next one, which asks for 1 in
// cells that are half open or more, and for a fall to 0 from there (exact for 0, 1/2 and 1, within 1 %
// between).
double receives(double open)
{
    return open > 0.5 ? 1 : 1 - std::pow(1 - 2*std::max(open, 0.0), 2.5);
}

} // namespace

std::unique_ptr<DepositKernel> DepositKernel::New(const word& name, const fvMesh& mesh,
    const CellHalo& halo, const PeriodicBox& box, const std::string& where)
{
    if (name == "kernel")
    {
        return std::make_unique<HatKernel>(mesh, halo, box);
    }
    if (name == "centre")
    {
        return std::make_unique<ParticleCentre>();
    }
    throw unknownName("deposit", name, {"kernel", "centre"}, where);
}

// Most cells around a particle are out of its reach along one axis or another.
double HatKernel::Hat::at(const point& x, const PeriodicBox& box) const
{
    double height = 1;
    for (int d = 0; d < 3; ++d)
    {
        const double slope = 1 - std::abs(box.nearest(x[d] - centre[d], d))*perWidth[d];
        if (slope <= 0)
        {
            return 0;
        }
        height *= slope;
    }
    return height;
}

HatKernel::HatKernel(const fvMesh& mesh, const CellHalo& halo, const PeriodicBox& box)
:
    halo_(halo),
    box_(box)
{
    List<Packed<6>> shape(mesh.nCells());
    forAll(shape, celli)
    {
        const boundBox extent(mesh.points(), mesh.cellPoints()[celli], false);
        for (direction d = 0; d < 3; ++d)
        {
            shape[celli][d] = mesh.C()[celli][d];
            shape[celli][d + 3] = 1/extent.span()[d];
        }
    }
    halo.toGhosts(shape);
    for (const Packed<6>& s : shape)
    {
        hats_.push_back({vector(s[0], s[1], s[2]), vector(s[3], s[4], s[5])});
    }
    gather();
}

// Of the neighbourhood of each cell, those whose hats reach into an eighth of what lies around its centre, as far as its own
// hat goes: 8 of 27 on a mesh of boxes.
void HatKernel::gather()
{
    begins_.push_back(0);
    for (label cell = 0; cell < halo_.nCells(); ++cell)
    {
        for (int eighth = 0; eighth < 8; ++eighth)
        {
            const labelList& all = halo_.neighbourhood()[cell];
            forAll(all, n)
            {
                if (reaches(hats_[all[n]], hats_[cell], eighth))
                {
                    reaching_.push_back(static_cast<std::uint16_t>(n));
                }
            }
            begins_.push_back(static_cast<int>(reaching_.size()));
        }
    }
}

// Along each axis, upwards from the centre of `from` where the eighth has a bit, else downwards; any image of the hat.
bool HatKernel::reaches(const Hat& hat, const Hat& from, int eighth) const
{
    constexpr double touching = 1e-9;
    for (int d = 0; d < 3; ++d)
    {
        const double up = eighth & (1 << d) ? 1 : -1;
        const double width = (1 - touching)/hat.perWidth[d];
        const double along = up*(hat.centre[d] - from.centre[d]);
        const double period = box_.period()[d];
        const auto meets = [&](double centre)
        { return centre + width > 0 && centre - width < 1/from.perWidth[d]; };
        if (!meets(along) && !(period > 0 && (meets(along - period) || meets(along + period))))
        {
            return false;
        }
    }
    return true;
}

// Around the centre of a cell; -1 where that cell's own hat does not go.
int HatKernel::eighthOf(const point& x, label cell) const
{
    const Hat& own = hats_[cell];
    int eighth = 0;
    for (int d = 0; d < 3; ++d)
    {
        const double along = box_.nearest(x[d] - own.centre[d], d);
        if (std::abs(along)*own.perWidth[d] > 1)
        {
            return -1;
        }
        eighth |= along > 0 ? 1 << d : 0;
    }
    return eighth;
}

// Those whose hats may be above zero at x, which lies in `cell`, or, beside a wall, next to it.
template<class Visit>
void HatKernel::forCellsAt(const point& x, label cell, const Visit& visit) const
{
    const labelList& all = halo_.neighbourhood()[cell];
    const int eighth = eighthOf(x, cell);
    if (eighth < 0)
    {
        std::for_each(all.begin(), all.end(), visit);
        return;
    }
    const int* begin = &begins_[8*cell + eighth];
    for (int n = begin[0]; n < begin[1]; ++n)
    {
        visit(all[reaching_[n]]);
    }
}

ParticleWeights HatKernel::weigh(const pointField& positions, const std::vector<int>& cells,
    const scalarList& open) const
{
    ParticleWeights weights;
    weights.offsets.reserve(positions.size() + 1);
    weights.cells.reserve(8*positions.size());
    weights.shares.reserve(8*positions.size());
    weights.offsets.push_back(0);

    for (label i = 0; i < positions.size(); ++i)
    {
        double sum = 0;
        forCellsAt(positions[i], cells[i], [&](label cell)
        {
            const double height = hats_[cell].at(positions[i], box_);
            const double share = height > 0 ? height*receives(open[cell]) : 0;
            if (share > 0)
            {
                weights.cells.push_back(cell);
                weights.shares.push_back(share);
                sum += share;
            }
        });
        // A tiny remainder is no better than none: dividing by it would make noise.
        if (sum < 1e-6)
        {
            weights.cells.resize(weights.offsets.back());
            weights.shares.resize(weights.offsets.back());
        }
        for (std::size_t w = weights.offsets.back(); w < weights.shares.size(); ++w)
        {
            weights.shares[w] /= sum;
        }
        weights.offsets.push_back(static_cast<int>(weights.cells.size()));
    }
    return weights;
}

ParticleWeights ParticleCentre::weigh(const pointField& positions, const std::vector<int>& cells,
    const scalarList&) const
{
    ParticleWeights weights;
    weights.offsets.resize(positions.size() + 1);
    for (std::size_t i = 0; i < weights.offsets.size(); ++i)
    {
        weights.offsets[i] = static_cast<int>(i);
    }
    weights.cells = cells;
    weights.shares.assign(cells.size(), 1.0);
    return weights;
}

} // namespace interstice
