// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/ParticleWeights.hpp"

#include "coupling/laws/InputError.hpp"

#include <cmath>

namespace interstice
{

using namespace Foam;

namespace
{

// A cell that is open less than this receives no powder. Half covered is where the surface of a solid
// is; a particle that touches it from outside finds a cell that receives for this bound, and would
// for none above one half.
constexpr double leastOpen = 0.25;

double receives(double open)
{
    return std::max(0.0, (open - leastOpen)/(1 - leastOpen));
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
        for (const label cell : halo_.neighbourhood()[cells[i]])
        {
            const Hat& hat = hats_[cell];
            const vector x = box_.nearest(positions[i] - hat.centre);
            const double share = receives(open[cell])
                *std::max(0.0, 1 - std::abs(x.x())*hat.perWidth.x())
                *std::max(0.0, 1 - std::abs(x.y())*hat.perWidth.y())
                *std::max(0.0, 1 - std::abs(x.z())*hat.perWidth.z());
            if (share > 0)
            {
                weights.cells.push_back(cell);
                weights.shares.push_back(share);
                sum += share;
            }
        }
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
