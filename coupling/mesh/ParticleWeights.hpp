// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/CellHalo.hpp"
#include "coupling/mesh/PeriodicBox.hpp"

#include "pointField.H"
#include "volFields.H"

#include <cstdint>
#include <memory>
#include <vector>

namespace interstice
{

/// Which cells share a particle, and in what shares. One evaluation a step serves every field,
/// on the way to the mesh and (transposed) on the way back.
struct ParticleWeights
{
    std::vector<int> offsets; ///< those of particle i: [offsets[i], offsets[i + 1])
    std::vector<int> cells; ///< compact index, see CellHalo
    std::vector<double> shares; ///< >= 0; sum 1 for each particle that any cell receives

    bool received(int i) const { return offsets[i + 1] > offsets[i]; }

    int count() const { return static_cast<int>(offsets.size()) - 1; }
};

/// Distributes a particle over cells.
class DepositKernel
{
public:
    virtual ~DepositKernel() = default;

    /// `open`: uncovered fraction of each cell, own and ghosts (see MovingSolid). A cell receives
    /// in proportion to its open volume.
    virtual ParticleWeights weigh(const Foam::pointField& positions,
        const std::vector<int>& cells, const Foam::scalarList& open) const = 0;

    /// By the name of entry `deposit`: `kernel` (default) or `centre`.
    static std::unique_ptr<DepositKernel> New(const Foam::word& name, const Foam::fvMesh& mesh,
        const CellHalo& halo, const PeriodicBox& box, const std::string& where);
};

/// Trilinear in the particle's position: product of hat functions, as wide as the cell on either
/// side of its centre, normalised to one. On a uniform hexahedral mesh these are the linear
/// weights of the eight nearest centres; at a wall the outer half of the hat falls to the wall
/// cell. Continuous in the position (also where neighbouring cells differ by a factor of two),
/// which the time derivative of the void fraction needs: see ParticleCentre.
class HatKernel final : public DepositKernel
{
public:
    HatKernel(const Foam::fvMesh& mesh, const CellHalo& halo, const PeriodicBox& box);

    ParticleWeights weigh(const Foam::pointField& positions, const std::vector<int>& cells,
        const Foam::scalarList& open) const override;

private:
    struct Hat
    {
        Foam::vector centre;
        Foam::vector perWidth; // 1/m

        double at(const Foam::point& x, const PeriodicBox& box) const;
    };

    void gather();
    bool reaches(const Hat& hat, const Hat& from, int eighth) const;
    int eighthOf(const Foam::point& x, Foam::label cell) const;
    template<class Visit>
    void forCellsAt(const Foam::point& x, Foam::label cell, const Visit& visit) const;

    const CellHalo& halo_;
    const PeriodicBox& box_;
    std::vector<Hat> hats_; // own cells and ghosts
    std::vector<std::uint16_t> reaching_; // places in a cell's neighbourhood, see gather
    std::vector<int> begins_; // of these, by own cell and eighth
};

/// All of a particle in the cell that holds its centre. For comparison only: the void fraction
/// jumps when a particle crosses a face, and d(alpha)/dt with it, whatever smoothing follows.
class ParticleCentre final : public DepositKernel
{
public:
    ParticleWeights weigh(const Foam::pointField& positions, const std::vector<int>& cells,
        const Foam::scalarList& open) const override;
};

} // namespace interstice
