// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/OpenVolumes.hpp"
#include "coupling/mesh/ParticleWeights.hpp"
#include "coupling/mesh/Smoothing.hpp"

namespace interstice
{

/// From the particles handled on this rank to densities on the mesh, and back.
///
///     deposit:  density = S [ (1/V) sum_i w_i q_i ]          q any extensive quantity, V open
///     sample:   value_i = sum_c w_ic (S field)_c             the adjoint of deposit
///
/// w: weights (DepositKernel), S: Smoothing, V: open volumes. Being adjoint means
/// sum_c V field_c density_c = sum_i q_i value_i, to round-off, on any ranks.
class ParticleMeshTransfer
{
public:
    ParticleMeshTransfer(const Foam::fvMesh& mesh, const CellHalo& halo,
        std::unique_ptr<DepositKernel> kernel, const Smoothing& smoothing);

    /// Local. `open`: uncovered fraction of each cell, own and ghosts. The smoothing is closed by
    /// its owner.
    void close(const Foam::scalarList& open)
    {
        open_ = open;
        volumes_ = openVolumes(mesh_, open);
    }

    /// Where the particles are [m] and the cells that hold them. Local.
    void place(const Foam::pointField& positions, const std::vector<int>& cells)
    {
        weights_ = kernel_->weigh(positions, cells, open_);
    }

    const ParticleWeights& weights() const { return weights_; }

    /// Collective. Density [q/m3 of open volume] in each own cell; quantity(i) gives q of particle i.
    template<unsigned N, class Quantity>
    Foam::List<Packed<N>> deposit(const Quantity& quantity) const;

    /// Collective. The same where each share has a quantity of its own: quantity(i, w) is what
    /// share w of particle i (see ParticleWeights) gives to its cell.
    template<unsigned N, class Quantity>
    Foam::List<Packed<N>> depositShares(const Quantity& quantity) const;

    /// Collective. Field smoothed, on own cells and ghosts: what a share meets in its cell. The
    /// adjoint of depositShares is the sum over shares of their quantity times this.
    template<unsigned N>
    void smoothed(Foam::List<Packed<N>>& field) const
    {
        smoothing_.smooth(field);
        halo_.toGhosts(field);
    }

    /// Collective. Field smoothed and at each particle; `field` is nCells long, used up.
    template<unsigned N>
    std::vector<Packed<N>> sample(Foam::List<Packed<N>>&& field) const
    {
        smoothing_.smooth(field);
        return interpolate(std::move(field));
    }

    /// Collective. As sample, without the smoothing: for what is smooth already.
    template<unsigned N>
    std::vector<Packed<N>> interpolate(Foam::List<Packed<N>>&& field) const;

private:
    const Foam::fvMesh& mesh_;
    const CellHalo& halo_;
    Foam::scalarList open_; // own cells and ghosts
    Foam::scalarField volumes_; // open
    std::unique_ptr<DepositKernel> kernel_;
    const Smoothing& smoothing_;
    ParticleWeights weights_;
};

inline ParticleMeshTransfer::ParticleMeshTransfer(const Foam::fvMesh& mesh, const CellHalo& halo,
    std::unique_ptr<DepositKernel> kernel, const Smoothing& smoothing)
:
    mesh_(mesh),
    halo_(halo),
    open_(halo.size(), 1.0),
    volumes_(mesh.V().field()),
    kernel_(std::move(kernel)),
    smoothing_(smoothing)
{
    weights_.offsets.assign(1, 0);
}

template<unsigned N, class Quantity>
Foam::List<Packed<N>> ParticleMeshTransfer::deposit(const Quantity& quantity) const
{
    int last = -1;
    Packed<N> whole(Foam::Zero);
    return depositShares<N>(
        [&](int i, int w)
        {
            if (i != last)
            {
                whole = quantity(i);
                last = i;
            }
            Packed<N> part;
            for (unsigned n = 0; n < N; ++n)
            {
                part[n] = weights_.shares[w]*whole[n];
            }
            return part;
        });
}

template<unsigned N, class Quantity>
Foam::List<Packed<N>> ParticleMeshTransfer::depositShares(const Quantity& quantity) const
{
    Foam::List<Packed<N>> density(halo_.size(), Packed<N>(Foam::Zero));
    for (int i = 0; i < weights_.count(); ++i)
    {
        for (int w = weights_.offsets[i]; w < weights_.offsets[i + 1]; ++w)
        {
            const Packed<N> q = quantity(i, w);
            Packed<N>& cell = density[weights_.cells[w]];
            for (unsigned n = 0; n < N; ++n)
            {
                cell[n] += q[n];
            }
        }
    }
    halo_.addGhosts(density);
    for (Foam::label c = 0; c < halo_.nCells(); ++c)
    {
        for (unsigned n = 0; n < N; ++n)
        {
            density[c][n] /= volumes_[c];
        }
    }
    smoothing_.smooth(density);
    return density;
}

template<unsigned N>
std::vector<Packed<N>> ParticleMeshTransfer::interpolate(Foam::List<Packed<N>>&& field) const
{
    halo_.toGhosts(field);
    std::vector<Packed<N>> values(weights_.count(), Packed<N>(Foam::Zero));
    for (int i = 0; i < weights_.count(); ++i)
    {
        for (int w = weights_.offsets[i]; w < weights_.offsets[i + 1]; ++w)
        {
            const Packed<N>& cell = field[weights_.cells[w]];
            for (unsigned n = 0; n < N; ++n)
            {
                values[i][n] += weights_.shares[w]*cell[n];
            }
        }
    }
    return values;
}

} // namespace interstice
