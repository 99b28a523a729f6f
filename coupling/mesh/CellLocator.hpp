// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/exchange/ParticleExchange.hpp"

#include "polyMesh.H"

#include <vector>

namespace interstice
{

/// Finds the cell of this rank that holds a point.
///
/// A grid of bins about as large as a cell lists the cells that reach into each bin; a point is
/// tested against the face planes of the cells of its bin. No search tree, no memory per particle,
/// no communication. The mesh must not change.
class CellLocator
{
public:
    explicit CellLocator(const Foam::polyMesh& mesh);

    /// The cell of a point [m], or that of its fallback (see ParticleExchange). A point beyond
    /// every cell by less than a twentieth of a cell still counts as a fallback there.
    Location operator()(const SearchPoint& point) const;

    /// Box around this rank's cells, empty if it has none.
    const Bounds& bounds() const { return bounds_; }

private:
    /// The face n.x = d of a cell, n outward and of unit length.
    struct Plane
    {
        double n[3];
        double d;
    };

    struct Nearest
    {
        int cell = -1;
        double beyond = 0; ///< distance outside the cell, relative to its size; <= 0: inside
    };

    void collectPlanes(const Foam::polyMesh& mesh);
    void fillBins(const Foam::polyMesh& mesh);
    Nearest nearest(const Vec3& point) const;
    int binOf(const Vec3& point) const;

    Bounds bounds_;
    int bins_[3] = {0, 0, 0};
    double perBin_[3] = {0, 0, 0}; // bins per metre
    std::vector<int> binStart_;
    std::vector<int> binCells_;
    std::vector<int> planeStart_;
    std::vector<Plane> planes_;
    std::vector<double> perSize_; // 1/m of each cell
};

} // namespace interstice
