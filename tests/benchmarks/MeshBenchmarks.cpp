// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each step between powder and mesh costs a particle, on one rank:
//
//     intersticeBenchmarks -case <a box with a mesh> [--benchmark_...]
//
// A row's items_per_second counts particles. Two particles a cell, as in a bed of parcels.

#include "coupling/laws/DragLaw.hpp"
#include "coupling/mesh/CellLocator.hpp"
#include "coupling/mesh/ParticleMeshTransfer.hpp"

#include "Time.H"
#include "argList.H"
#include "fvMesh.H"

#include <benchmark/benchmark.h>

#include <mpi.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace interstice;

namespace
{

constexpr int particlesPerCell = 2;
constexpr double widthInCells = 2; // of the smoothing

/// A mesh, and particles in random places of it.
class Bed
{
public:
    explicit Bed(const Foam::Time& time)
    :
        mesh_(Foam::IOobject(Foam::fvMesh::defaultRegion, "0", time)),
        box_(mesh_),
        halo_(mesh_),
        locator_(mesh_),
        smoothing_(mesh_, halo_, widthInCells*std::cbrt(mesh_.V()[0])),
        transfer_(mesh_, halo_, DepositKernel::New("kernel", mesh_, halo_, box_, ""), smoothing_)
    {
        scatter();
        weigh();
    }

    int count() const { return positions_.size(); }
    Foam::label cells() const { return mesh_.nCells(); }

    void locate()
    {
        int sum = 0;
        for (const SearchPoint& point : points_)
        {
            sum += locator_(point).cell;
        }
        benchmark::DoNotOptimize(sum);
    }

    void weigh() { transfer_.place(positions_, cells_); }

    void deposit()
    {
        auto density = transfer_.deposit<4>([](int) { return Packed<4>(1.0); });
        benchmark::DoNotOptimize(density.data());
    }

    void sample()
    {
        auto values = transfer_.sample<4>(Foam::List<Packed<4>>(cells(), Packed<4>(1.0)));
        benchmark::DoNotOptimize(values.data());
    }

    void smooth()
    {
        Foam::List<Packed<4>> field(cells(), Packed<4>(1.0));
        smoothing_.smooth(field);
        benchmark::DoNotOptimize(field.data());
    }

private:
    void scatter()
    {
        std::mt19937 random(5489);
        std::uniform_real_distribution<double> share(0, 1);
        const Foam::boundBox& bounds = mesh_.bounds();
        positions_.setSize(particlesPerCell*mesh_.nCells());
        for (Foam::point& x : positions_)
        {
            for (int d = 0; d < 3; ++d)
            {
                x[d] = bounds.min()[d] + share(random)*bounds.span()[d];
            }
            const Vec3 place{x.x(), x.y(), x.z()};
            points_.push_back({place, place});
            cells_.push_back(locator_(points_.back()).cell);
        }
    }

    Foam::fvMesh mesh_;
    PeriodicBox box_;
    CellHalo halo_;
    CellLocator locator_;
    Smoothing smoothing_;
    ParticleMeshTransfer transfer_;
    Foam::pointField positions_;
    std::vector<SearchPoint> points_;
    std::vector<int> cells_;
};

// Void fractions from loose to dense, Reynolds numbers about one.
void drag(benchmark::State& state, const DragLaw& law)
{
    constexpr int count = 1000;
    for (auto _ : state)
    {
        double sum = 0;
        for (int i = 0; i < count; ++i)
        {
            sum += law.coefficientPerVolume({1e-3*i, 0.36 + 6e-4*i, 40e-6, 1.2, 1.8e-5});
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations()*count);
}

void registerAll(Bed& bed, const DragLaw& law)
{
    const auto add = [&](const char* name, void (Bed::*step)())
    {
        benchmark::RegisterBenchmark(name,
            [&bed, step](benchmark::State& state)
            {
                for (auto _ : state)
                {
                    (bed.*step)();
                }
                state.SetItemsProcessed(state.iterations()*bed.count());
            });
    };
    add("locate", &Bed::locate);
    add("weigh", &Bed::weigh);
    add("deposit 4 numbers, smoothed", &Bed::deposit);
    add("sample 4 numbers, smoothed", &Bed::sample);
    add("smoothing of these alone", &Bed::smooth);
    benchmark::RegisterBenchmark(
        "drag law", [&law](benchmark::State& state) { drag(state, law); });
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv); // takes its options out of the command line
    MPI_Init(&argc, &argv);
    auto* arguments = new Foam::argList(argc, argv); // its destructor would end the process
    {
        Foam::Time time(Foam::Time::controlDictName, *arguments);
        Bed bed(time);
        const std::unique_ptr<DragLaw> law = makeDragLaw(dragLaws().front().name);
        registerAll(bed, *law);
        benchmark::RunSpecifiedBenchmarks();
    }
    MPI_Finalize();
    delete arguments;
    return 0;
}
