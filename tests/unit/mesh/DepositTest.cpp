// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/InputError.hpp"
#include "tests/unit/mesh/Lattice.hpp"
#include "tests/unit/mesh/OneRankReference.hpp"
#include "tests/unit/mesh/PowderScene.hpp"

#include "mathematicalConstants.H"

#include <cstring>
#include <map>

namespace interstice
{
namespace
{

using Foam::label;
using Foam::point;
using Foam::scalar;
using Foam::scalarField;
using Foam::vector;

class DepositTest : public MeshTest
{
protected:
    static bool isUniform()
    {
        return Foam::gMax(mesh().V().field()) < 1.01*Foam::gMin(mesh().V().field());
    }

    static bool isPeriodic() { return ground().box.period().x() > 0; }

    /// Collective.
    static double cellSize() { return std::cbrt(Foam::gAverage(mesh().V().field())); }
};

TEST_F(DepositTest, KeepsTheVolumeOfACloudOfAnyGrainSize)
{
    const double dx = cellSize();
    const std::vector<point> cloud = cloudInside(ground(), 2000, 3);
    ASSERT_GT(cloud.size(), 200u);
    for (const double grainPerCell : {0.1, 1.0, 2.0, 4.0})
    {
        const auto volume = [&](int i)
        {
            const double d = grainPerCell*dx*(1 + 0.3*std::sin(i));
            return Foam::constant::mathematical::pi/6*d*d*d;
        };
        double expected = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i)
        {
            expected += volume(int(i));
        }
        for (const char* kernel : {"kernel", "centre"})
        {
            PowderScene scene(ground(), kernel);
            scene.place(cloud);
            const scalarField solids = scene.deposit(volume);
            EXPECT_NEAR(Foam::gSum((solids*mesh().V().field())()), expected, 1e-12*expected)
                << kernel << ", d/dx = " << grainPerCell;
        }
    }
}

// On faces, edges, corners, boundaries of ranks, and on walls.
TEST_F(DepositTest, KeepsTheVolumeOfParticlesOnFacesAndWalls)
{
    std::vector<point> mine;
    const auto add = [&](label face)
    {
        mine.push_back(mesh().faceCentres()[face]);
        mine.push_back(mesh().points()[mesh().faces()[face][0]]);
    };
    add(mesh().nInternalFaces()/2);
    for (const Foam::polyPatch& patch : mesh().boundaryMesh())
    {
        if (patch.size() > 0)
        {
            add(patch.start() + patch.size()/2);
        }
    }
    const std::vector<point> places = ofAllRanks(mine);
    PowderScene scene(ground(), "kernel");
    scene.place(places);

    const scalarField density = scene.deposit([](int) { return 1.0; });

    EXPECT_NEAR(Foam::gSum((density*mesh().V().field())()), double(places.size()),
        1e-12*places.size());
}

TEST_F(DepositTest, EqualsTheTrilinearFormulaOnAUniformBoxOnAnyRanks)
{
    if (!isUniform())
    {
        GTEST_SKIP();
    }
    const Lattice lattice(isPeriodic());
    const std::vector<point> cloud = cloudInside(ground(), 3000, 5);
    std::vector<double> expected(Lattice::count(), 0);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        lattice.addTrilinear(expected, cloud[i], 1 + 0.1*(i % 7));
    }
    PowderScene scene(ground(), "kernel");
    scene.place(cloud);

    const scalarField density = scene.deposit([](int i) { return 1 + 0.1*(i % 7); });

    forAll(density, cell)
    {
        ASSERT_NEAR(density[cell]*Lattice::volume, expected[Lattice::indexAt(mesh().C()[cell])],
            1e-12*3);
    }
}

// Also where a particle lies beside the cell that handles it, as it does in a wall.
TEST_F(DepositTest, MissesNoCellAroundThatAHatReaches)
{
    Foam::List<Packed<6>> hats(mesh().nCells());
    Foam::pointField places;
    std::vector<int> cells;
    Dice dice(7);
    const Foam::boundBox around(vector::uniform(-1.2), vector::uniform(1.2));
    forAll(hats, cell)
    {
        const Foam::boundBox extent(mesh().points(), mesh().cellPoints()[cell], false);
        const vector c = mesh().C()[cell];
        const vector w = extent.span();
        hats[cell] = {c.x(), c.y(), c.z(), w.x(), w.y(), w.z()};
        places.append(c + Foam::cmptMultiply(w, dice.within(around)));
        cells.push_back(int(cell));
    }
    halo().toGhosts(hats);

    const ParticleWeights found = HatKernel(mesh(), halo(), ground().box).weigh(
        places, cells, Foam::scalarList(halo().size(), 1.0));

    forAll(places, i)
    {
        std::map<int, double> expected;
        double sum = 0;
        for (const label other : halo().neighbourhood()[i])
        {
            double share = 1;
            for (int d = 0; d < 3; ++d)
            {
                const double x = ground().box.nearest(places[i][d] - hats[other][d], d);
                share *= Foam::max(0.0, 1 - std::abs(x)/hats[other][d + 3]);
            }
            expected[int(other)] = share;
            sum += share;
        }
        for (int w = found.offsets[i]; w < found.offsets[i + 1]; ++w)
        {
            ASSERT_NEAR(found.shares[w], expected.at(found.cells[w])/sum, 1e-8);
            expected.erase(found.cells[w]);
        }
        for (const auto& [cell, share] : expected)
        {
            ASSERT_LE(share, sum < 1e-6 ? sum : 1e-8*sum);
        }
    }
}

// 0.3, 0.6 and 0.1 of a cell beyond the centre of cell (10, 9, 8).
TEST_F(DepositTest, HasTheWeightsOfAHandCalculation)
{
    if (!isUniform())
    {
        GTEST_SKIP();
    }
    PowderScene scene(ground(), "kernel");
    scene.place({point(10.8*0.5e-3, 10.1*0.4e-3, 8.6*0.5e-3)});
    const scalarField share = scene.deposit([](int) { return Lattice::volume; });

    const auto at = [&](int i, int j, int k)
    {
        double found = 0;
        forAll(share, cell)
        {
            const bool isIt = Lattice::indexAt(mesh().C()[cell]) == Lattice::index(i, j, k);
            found += isIt ? share[cell] : 0;
        }
        return Foam::returnReduce(found, Foam::sumOp<scalar>());
    };
    EXPECT_NEAR(at(10, 9, 8), 0.7*0.4*0.9, 1e-12);
    EXPECT_NEAR(at(11, 9, 8), 0.3*0.4*0.9, 1e-12);
    EXPECT_NEAR(at(10, 10, 8), 0.7*0.6*0.9, 1e-12);
    EXPECT_NEAR(at(11, 10, 9), 0.3*0.6*0.1, 1e-12);
    EXPECT_NEAR(at(9, 9, 8), 0, 1e-15);
    EXPECT_NEAR(at(10, 9, 7), 0, 1e-15);
}

TEST_F(DepositTest, IsTheSameOnAnyRanks)
{
    PowderScene scene(ground(), "kernel", 2*cellSize());
    scene.place(cloudInside(ground(), 3000, 11));

    compareWithOneRank("deposit", mesh(), scene.deposit([](int i) { return 1.0 + i % 3; }), 1e-12);
}

// sum_c w_c x_c = x_p: a linear field is seen exactly, half a cell or more away from walls.
TEST_F(DepositTest, SeesALinearFieldExactlyInTheInterior)
{
    if (!isUniform() || isPeriodic())
    {
        GTEST_SKIP();
    }
    std::vector<point> cloud = cloudInside(ground(), 500, 9);
    for (point& p : cloud)
    {
        p = mesh().bounds().midpoint() + 0.9*(p - mesh().bounds().midpoint());
    }
    PowderScene scene(ground(), "kernel");
    scene.place(cloud);
    Foam::List<Packed<3>> places(mesh().nCells());
    forAll(places, cell)
    {
        for (int d = 0; d < 3; ++d)
        {
            places[cell][d] = mesh().C()[cell][d];
        }
    }

    const std::vector<Packed<3>> seen = scene.transfer().interpolate(std::move(places));

    for (std::size_t i = 0; i < seen.size(); ++i)
    {
        for (int d = 0; d < 3; ++d)
        {
            ASSERT_NEAR(seen[i][d], scene.handled().positions[label(i)][d], 1e-15);
        }
    }
}

TEST_F(DepositTest, HasSharesThatAddUpToOne)
{
    PowderScene scene(ground(), "kernel");
    scene.place(cloudInside(ground(), 1000, 13));
    const ParticleWeights& weights = scene.transfer().weights();
    ASSERT_EQ(weights.count(), int(scene.handled().ids.size()));
    for (int i = 0; i < weights.count(); ++i)
    {
        double sum = 0;
        for (int w = weights.offsets[i]; w < weights.offsets[i + 1]; ++w)
        {
            ASSERT_GE(weights.shares[w], 0);
            sum += weights.shares[w];
        }
        ASSERT_NEAR(sum, 1, 1e-14);
    }
}

// sum_c V f S(q)_c = sum_i q_i sample(f)_i, V open, with smoothing and with cells partly covered.
TEST_F(DepositTest, IsTheAdjointOfTheSampling)
{
    const auto quantity = [](int i) { return 1.0 + std::cos(i); };
    scalarField open(mesh().nCells());
    Foam::List<Packed<1>> field(mesh().nCells());
    forAll(open, cell)
    {
        const vector x = 1e3*mesh().C()[cell];
        open[cell] = std::min(1.0, std::max(0.0, 3 - 0.4*x.x()));
        field[cell][0] = std::sin(3*x.x()) + std::cos(5*x.y())*x.z();
    }
    PowderScene scene(ground(), "kernel", 2*cellSize());
    scene.close(open);
    scene.place(cloudInside(ground(), 1000, 19));
    ASSERT_GT(scene.smoothing().sweeps(), 0);

    const scalarField density = scene.deposit(quantity);
    const scalarField volume = openVolumes(mesh(), open);
    scalar onTheMesh = 0;
    scalar size = 0;
    forAll(density, cell)
    {
        onTheMesh += volume[cell]*field[cell][0]*density[cell];
        size += volume[cell]*Foam::mag(field[cell][0])*density[cell];
    }
    const std::vector<Packed<1>> seen = scene.transfer().sample(std::move(field));
    scalar atParticles = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
        atParticles += quantity(scene.handled().ids[i])*seen[i][0];
    }

    Foam::reduce(onTheMesh, Foam::sumOp<scalar>());
    Foam::reduce(size, Foam::sumOp<scalar>());
    Foam::reduce(atParticles, Foam::sumOp<scalar>());
    EXPECT_NEAR(onTheMesh, atParticles, 1e-12*size);
}

TEST_F(DepositTest, WorksWithoutParticles)
{
    PowderScene scene(ground(), "kernel", cellSize());
    scene.place({});

    EXPECT_EQ(largest(scene.deposit([](int) { return 1.0; })), 0);
}

TEST_F(DepositTest, NamesTheKernelsThatExistWhenANameIsWrong)
{
    try
    {
        DepositKernel::New("kernal", mesh(), halo(), ground().box, "constant/couplingProperties");
        FAIL() << "a wrong name was taken";
    }
    catch (const InputError& error)
    {
        EXPECT_NE(std::strstr(error.what(), "constant/couplingProperties"), nullptr);
        EXPECT_NE(std::strstr(error.what(), "kernel"), nullptr);
        EXPECT_NE(std::strstr(error.what(), "centre"), nullptr);
    }
}

} // namespace
} // namespace interstice
