// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/CellHalo.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace interstice
{

/// Conservative smoothing of cell densities by explicit diffusion sweeps, equivalent to a
/// Gaussian exp(-r^2/b^2) (Sun & Xiao, J. Comput. Phys. 300 (2015) 161-182: D T = b^2/4).
///
/// One linear operator S for every deposited field. It keeps the volume integral, never leaves
/// the range of its input, and is its own adjoint in the product weighted with open volumes
/// (sum V a S(b) = sum V b S(a)); so sampling S(u) with the deposit's weights returns to the
/// particles exactly the momentum that the air gives away. No flux through walls.
class Smoothing
{
public:
    /// `width`: b [m]; zero: no smoothing.
    Smoothing(const Foam::fvMesh& mesh, const CellHalo& halo, double width);

    /// Local. `open`: uncovered fraction of each cell, own and ghosts. Densities are per open volume
    /// from now on; a face lets through what the less open of its cells does.
    void close(const Foam::scalarList& open);

    /// Local. From now on leaves out the cells that no sweep connects with these ones (compact indices), until the next
    /// call: of a density that is zero elsewhere the result is the same everywhere, of any other field it is the same in
    /// these cells, to the last bit.
    void reach(const std::vector<int>& cells);

    /// Share of this rank's cells that take part. Local.
    double share() const { return double(cells_.size())/std::max(halo_.nCells(), Foam::label(1)); }

    /// Collective. Smooths N densities at once; `density` is nCells long.
    template<unsigned N>
    void smooth(Foam::List<Packed<N>>& density) const;

    /// Wall time of smooth() since the last call [s].
    double takeSeconds() const { return std::exchange(seconds_, 0.0); }

    int sweeps() const { return sweeps_; }

    /// The links of the mesh with what each lets through in one sweep [m3].
    const std::vector<CellHalo::Link>& open() const { return links_; }

private:
    void gather();

    const CellHalo& halo_;
    const Foam::fvMesh& mesh_;
    Foam::scalarField volumes_; // open
    int sweeps_ = 0;
    double perSweep_ = 0; // diffusivity times time of one sweep [m2]
    Foam::labelListList neighbours_; // of own cells through links, compact
    std::vector<CellHalo::Link> links_; // all
    std::vector<char> reached_; // own cells and ghosts
    std::vector<Foam::label> cells_; // own, of those
    std::vector<CellHalo::Link> between_; // links of those
    mutable double seconds_ = 0;
};

template<unsigned N>
void Smoothing::smooth(Foam::List<Packed<N>>& density) const
{
    const auto start = std::chrono::steady_clock::now();
    const Foam::label own = halo_.nCells();
    Foam::List<Packed<N>> gain(own);
    for (int sweep = 0; sweep < sweeps_; ++sweep)
    {
        halo_.toGhosts(density);
        for (const Foam::label c : cells_)
        {
            gain[c] = Packed<N>(Foam::Zero);
        }
        for (const CellHalo::Link& link : between_)
        {
            Packed<N>& here = gain[link.cell];
            const Packed<N>& a = density[link.cell];
            const Packed<N>& b = density[link.other];
            if (link.internal)
            {
                Packed<N>& there = gain[link.other];
                for (unsigned n = 0; n < N; ++n)
                {
                    const double flux = link.conductance*(b[n] - a[n]);
                    here[n] += flux;
                    there[n] -= flux;
                }
            }
            else
            {
                for (unsigned n = 0; n < N; ++n)
                {
                    here[n] += link.conductance*(b[n] - a[n]);
                }
            }
        }
        density.setSize(own);
        for (const Foam::label c : cells_)
        {
            for (unsigned n = 0; n < N; ++n)
            {
                density[c][n] += gain[c][n]/volumes_[c];
            }
        }
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    seconds_ += spent.count();
}

} // namespace interstice
