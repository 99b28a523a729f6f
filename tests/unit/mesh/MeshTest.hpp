// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/unit/FoamTest.hpp"

#include "coupling/mesh/CellHalo.hpp"
#include "coupling/mesh/CellLocator.hpp"
#include "coupling/mesh/PeriodicBox.hpp"

#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace interstice
{

/// The mesh of the case and all that is made of it once.
struct Ground
{
    Foam::fvMesh mesh{Foam::IOobject(Foam::fvMesh::defaultRegion, "0", foamTime())};
    PeriodicBox box{mesh};
    CellHalo halo{mesh};
    CellLocator locator{mesh};
};

/// A test on the mesh of its case. The mesh must be gone before the clock of the case is, so it
/// lives from the first to the last test of a suite.
class MeshTest : public testing::Test
{
protected:
    static void SetUpTestSuite() { ground_ = std::make_unique<Ground>(); }
    static void TearDownTestSuite() { ground_.reset(); }

    static const Ground& ground() { return *ground_; }
    static const Foam::fvMesh& mesh() { return ground_->mesh; }
    static const CellHalo& halo() { return ground_->halo; }

private:
    inline static std::unique_ptr<Ground> ground_;
};

/// Random numbers that are the same on every rank and every machine.
class Dice
{
public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}

    double between(double low, double high)
    {
        return low + (high - low)*(random_()/4294967296.0);
    }

    Foam::point within(const Foam::boundBox& box)
    {
        const double x = between(box.min().x(), box.max().x());
        const double y = between(box.min().y(), box.max().y());
        return {x, y, between(box.min().z(), box.max().z())};
    }

private:
    std::mt19937 random_;
};

inline Vec3 toVec3(const Foam::vector& v)
{
    return {v.x(), v.y(), v.z()};
}

/// The particles of a list known to all ranks that this rank handles.
struct Handled
{
    std::vector<int> ids; ///< indices in the list
    std::vector<int> cells;
    Foam::pointField positions;
};

/// Collective. Particle i is owned by rank i mod P, so that most of them must travel.
inline Handled handle(const Ground& ground, const std::vector<Foam::point>& all)
{
    std::vector<SearchPoint> own;
    std::vector<int> ids;
    for (int i = Foam::Pstream::myProcNo(); i < int(all.size()); i += Foam::Pstream::nProcs())
    {
        const Vec3 position = toVec3(ground.box.wrap(all[i]));
        own.push_back({position, position});
        ids.push_back(i);
    }
    ParticleExchange exchange(MPI_COMM_WORLD, ground.locator.bounds());
    exchange.plan(own, [&](const SearchPoint& p) { return ground.locator(p); });

    Handled handled;
    handled.ids = exchange.toHandlers(ids);
    handled.cells = exchange.cells();
    handled.positions.setSize(Foam::label(handled.ids.size()));
    for (std::size_t i = 0; i < handled.ids.size(); ++i)
    {
        handled.positions[Foam::label(i)] = ground.box.wrap(all[handled.ids[i]]);
    }
    return handled;
}

/// Random places in the cells of the whole mesh, the same on every rank. Collective.
inline std::vector<Foam::point> cloudInside(const Ground& ground, int count, std::uint32_t seed)
{
    Dice dice(seed);
    std::vector<Foam::point> places(count);
    for (Foam::point& p : places)
    {
        p = dice.within(ground.mesh.bounds());
    }
    std::vector<int> inside(count, 0);
    for (const int id : handle(ground, places).ids)
    {
        inside[id] = 1;
    }
    MPI_Allreduce(MPI_IN_PLACE, inside.data(), count, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    std::vector<Foam::point> kept;
    for (int i = 0; i < count; ++i)
    {
        if (inside[i])
        {
            kept.push_back(places[i]);
        }
    }
    return kept;
}

} // namespace interstice
