// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/ParticleMeshTransfer.hpp"
#include "tests/unit/mesh/MeshTest.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interstice
{

/// A cloud, the same on all ranks, and its deposit on these.
class PowderScene
{
public:
    PowderScene(const Ground& ground, const Foam::word& kernel, double smoothingWidth = 0)
    :
        ground_(ground),
        smoothing_(ground.mesh, ground.halo, smoothingWidth),
        transfer_(ground.mesh, ground.halo,
            DepositKernel::New(kernel, ground.mesh, ground.halo, ground.box, ""), smoothing_)
    {}

    /// Collective. `open` of own cells.
    void close(const Foam::scalarField& open)
    {
        Foam::scalarList everywhere(open);
        ground_.halo.toGhosts(everywhere);
        smoothing_.close(everywhere);
        transfer_.close(everywhere);
    }

    /// Collective.
    void place(const std::vector<Foam::point>& all)
    {
        handled_ = handle(ground_, all);
        transfer_.place(handled_.positions, handled_.cells);
    }

    /// Collective. q of particle i of the list, as a density [q/m3].
    template<class Quantity>
    Foam::scalarField deposit(const Quantity& quantity) const
    {
        const Foam::List<Packed<1>> packed = transfer_.deposit<1>(
            [&](int i) { return Packed<1>(Foam::scalar(quantity(handled_.ids[i]))); });
        Foam::scalarField density(packed.size());
        forAll(density, cell)
        {
            density[cell] = packed[cell][0];
        }
        return density;
    }

    const Handled& handled() const { return handled_; }
    const ParticleMeshTransfer& transfer() const { return transfer_; }
    const Smoothing& smoothing() const { return smoothing_; }

private:
    const Ground& ground_;
    Smoothing smoothing_;
    ParticleMeshTransfer transfer_;
    Handled handled_;
};

/// Largest value over all ranks.
inline double largest(const Foam::scalarField& field)
{
    return Foam::gMax(Foam::mag(field)());
}

/// Collective. The places of all ranks, in the order of the ranks.
inline std::vector<Foam::point> ofAllRanks(const std::vector<Foam::point>& mine)
{
    const int numbers = 3*int(mine.size());
    std::vector<int> counts(Foam::Pstream::nProcs());
    MPI_Allgather(&numbers, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::vector<int> offsets(counts.size() + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), offsets.begin() + 1);
    std::vector<Foam::point> all(offsets.back()/3);
    MPI_Allgatherv(mine.data(), numbers, MPI_DOUBLE, all.data(), counts.data(),
        offsets.data(), MPI_DOUBLE, MPI_COMM_WORLD);
    return all;
}

} // namespace interstice
