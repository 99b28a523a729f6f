// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/CellLocator.hpp"

#include "primitiveMesh.H"

#include <cmath>

namespace interstice
{

namespace
{

// Planes of neighbouring cells differ by round-off: a point on a face must be in one of them.
constexpr double onTheFace = 1e-9;

// How far outside, in cell sizes, a point may lie and still be given to a cell.
constexpr double nearby = 0.05;

Vec3 toVec3(const Foam::vector& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

CellLocator::CellLocator(const Foam::polyMesh& mesh)
{
    if (mesh.nCells() == 0)
    {
        return;
    }
    for (const Foam::point& p : mesh.points())
    {
        bounds_.add(toVec3(p));
    }
    bounds_.grow(nearby*std::cbrt(Foam::max(mesh.cellVolumes())));
    collectPlanes(mesh);
    fillBins(mesh);
}

void CellLocator::collectPlanes(const Foam::polyMesh& mesh)
{
    const Foam::vectorField& areas = mesh.faceAreas();
    const Foam::pointField& centres = mesh.faceCentres();
    planeStart_.push_back(0);
    for (Foam::label celli = 0; celli < mesh.nCells(); ++celli)
    {
        for (const Foam::label facei : mesh.cells()[celli])
        {
            const double sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
            const Foam::vector n = sign*areas[facei]/Foam::mag(areas[facei]);
            planes_.push_back({{n.x(), n.y(), n.z()}, n & centres[facei]});
        }
        planeStart_.push_back(static_cast<int>(planes_.size()));
        perSize_.push_back(1/std::cbrt(mesh.cellVolumes()[celli]));
    }
}

void CellLocator::fillBins(const Foam::polyMesh& mesh)
{
    const double size = std::cbrt(Foam::sum(mesh.cellVolumes())/mesh.nCells());
    int count = 1;
    for (int d = 0; d < 3; ++d)
    {
        const double span = bounds_.max[d] - bounds_.min[d];
        bins_[d] = std::max(1, static_cast<int>(std::round(span/size)));
        perBin_[d] = bins_[d]/span;
        count *= bins_[d];
    }

    // Two passes over the cells: count what each bin lists, then write the lists.
    binStart_.assign(count + 1, 0);
    const auto forEachBin = [&](Foam::label celli, auto&& action)
    {
        Bounds box;
        for (const Foam::label pointi : mesh.cellPoints()[celli])
        {
            box.add(toVec3(mesh.points()[pointi]));
        }
        box.grow(nearby/perSize_[celli]);
        int low[3];
        int high[3];
        for (int d = 0; d < 3; ++d)
        {
            const auto index = [&](double x)
            {
                const int i = static_cast<int>((x - bounds_.min[d])*perBin_[d]);
                return std::min(std::max(i, 0), bins_[d] - 1);
            };
            low[d] = index(box.min[d]);
            high[d] = index(box.max[d]);
        }
        for (int k = low[2]; k <= high[2]; ++k)
        {
            for (int j = low[1]; j <= high[1]; ++j)
            {
                for (int i = low[0]; i <= high[0]; ++i)
                {
                    action(i + bins_[0]*(j + bins_[1]*k));
                }
            }
        }
    };
    for (Foam::label celli = 0; celli < mesh.nCells(); ++celli)
    {
        forEachBin(celli, [&](int bin) { ++binStart_[bin + 1]; });
    }
    for (int bin = 0; bin < count; ++bin)
    {
        binStart_[bin + 1] += binStart_[bin];
    }
    binCells_.resize(binStart_.back());
    std::vector<int> next(binStart_.begin(), binStart_.end() - 1);
    for (Foam::label celli = 0; celli < mesh.nCells(); ++celli)
    {
        forEachBin(celli, [&](int bin) { binCells_[next[bin]++] = celli; });
    }
}

int CellLocator::binOf(const Vec3& point) const
{
    int index[3];
    for (int d = 0; d < 3; ++d)
    {
        index[d] = static_cast<int>((point[d] - bounds_.min[d])*perBin_[d]);
        index[d] = std::min(std::max(index[d], 0), bins_[d] - 1);
    }
    return index[0] + bins_[0]*(index[1] + bins_[1]*index[2]);
}

CellLocator::Nearest CellLocator::nearest(const Vec3& point) const
{
    Nearest best;
    const int bin = binOf(point);
    for (int i = binStart_[bin]; i < binStart_[bin + 1]; ++i)
    {
        const int cell = binCells_[i];
        double beyond = -1;
        for (int p = planeStart_[cell]; p < planeStart_[cell + 1]; ++p)
        {
            const Plane& plane = planes_[p];
            const double distance =
                plane.n[0]*point[0] + plane.n[1]*point[1] + plane.n[2]*point[2] - plane.d;
            beyond = std::max(beyond, distance*perSize_[cell]);
        }
        if (best.cell < 0 || beyond < best.beyond)
        {
            best = {cell, beyond};
        }
        if (beyond <= 0)
        {
            break;
        }
    }
    return best;
}

Location CellLocator::operator()(const SearchPoint& point) const
{
    Nearest found;
    if (bounds_.contains(point.position))
    {
        found = nearest(point.position);
        if (found.cell >= 0 && found.beyond <= onTheFace)
        {
            return {Location::Quality::exact, found.cell};
        }
    }
    if (bounds_.contains(point.fallback))
    {
        const Nearest before = nearest(point.fallback);
        if (before.cell >= 0 && before.beyond <= onTheFace)
        {
            return {Location::Quality::fallback, before.cell};
        }
    }
    if (found.cell >= 0 && found.beyond <= nearby)
    {
        return {Location::Quality::fallback, found.cell};
    }
    return {};
}

} // namespace interstice
