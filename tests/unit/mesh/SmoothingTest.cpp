// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/mesh/Lattice.hpp"
#include "tests/unit/mesh/OneRankReference.hpp"
#include "tests/unit/mesh/PowderScene.hpp"

namespace interstice
{
namespace
{

using Foam::scalar;
using Foam::scalarField;
using Foam::vector;

constexpr double width = 0.7e-3; // b [m]

class SmoothingTest : public MeshTest
{
protected:
    static bool isUniform()
    {
        return Foam::gMax(mesh().V().field()) < 1.01*Foam::gMin(mesh().V().field());
    }

    static bool isPeriodic() { return ground().box.period().x() > 0; }

    static Smoothing make(double b = width) { return Smoothing(mesh(), halo(), b); }

    static scalarField smooth(const Smoothing& smoothing, const scalarField& field)
    {
        Foam::List<Packed<1>> packed(field.size());
        forAll(packed, cell)
        {
            packed[cell][0] = field[cell];
        }
        smoothing.smooth(packed);
        scalarField result(packed.size());
        forAll(result, cell)
        {
            result[cell] = packed[cell][0];
        }
        return result;
    }

    static scalar total(const scalarField& field)
    {
        return Foam::gSum((field*mesh().V().field())());
    }

    /// Between 0 and 1, depends on the place alone.
    static scalarField rough()
    {
        scalarField field(mesh().nCells());
        forAll(field, cell)
        {
            const vector x = 1e3*mesh().C()[cell];
            const double wave = 3.7*std::sin(1.9*x.x() + 2.3*x.y() + 3.1*x.z());
            field[cell] = wave - std::floor(wave);
        }
        return field;
    }

    /// One in the cell that holds a point, zero elsewhere.
    static scalarField spike(const Foam::point& p)
    {
        scalarField field(mesh().nCells(), Foam::Zero);
        for (const int cell : handle(ground(), {p}).cells)
        {
            field[cell] = 1;
        }
        return field;
    }

    /// Cells of this rank in two places, far from most of the box.
    static std::vector<int> someCells()
    {
        std::vector<int> cells;
        forAll(mesh().C(), cell)
        {
            const vector& x = mesh().C()[cell];
            if (Foam::mag(x - vector(3e-3, 2e-3, 2e-3)) < 0.8e-3 || Foam::mag(x - vector(9e-3, 3e-3, 8e-3)) < 0.5e-3)
            {
                cells.push_back(cell);
            }
        }
        return cells;
    }

    static void close(Smoothing& smoothing, const scalarField& open)
    {
        Foam::scalarList everywhere(open);
        halo().toGhosts(everywhere);
        smoothing.close(everywhere);
    }
};

// A Gaussian exp(-r^2/b^2) has the variance b^2/2 along each axis. The nine sweeps reach nine
// cells from the middle: no wall is felt, in the periodic box no image.
TEST_F(SmoothingTest, SpreadsASpikeByHalfTheSquareOfItsWidthAlongEachAxis)
{
    if (!isUniform())
    {
        GTEST_SKIP();
    }
    const vector centre(12.5*0.5e-3, 10.5*0.4e-3, 10.5*0.5e-3);
    const Smoothing smoothing = make();
    ASSERT_LE(smoothing.sweeps(), 9);
    const scalarField after = smooth(smoothing, spike(centre));

    for (int d = 0; d < 3; ++d)
    {
        const scalarField x(mesh().C().primitiveField().component(d) - centre[d]);
        const scalar mean = total(x*after)/total(after);
        const scalar variance = total(x*x*after)/total(after);
        EXPECT_NEAR(mean, 0, 1e-10*width);
        EXPECT_NEAR(variance, width*width/2, 1e-10*width*width/2) << "axis " << d;
    }
}

TEST_F(SmoothingTest, EqualsTheHeatEquationOnAUniformBoxOnAnyRanks)
{
    if (!isUniform())
    {
        GTEST_SKIP();
    }
    const Smoothing smoothing = make();
    std::vector<double> expected(Lattice::count(), 0);
    expected[Lattice::index(0, 0, 0)] = 1;
    expected[Lattice::index(23, 10, 19)] = 2;
    Lattice(isPeriodic()).diffuse(expected, width*width/4, smoothing.sweeps());

    const auto at = [](int i, int j, int k)
    { return Foam::point((i + 0.5)*0.5e-3, (j + 0.5)*0.4e-3, (k + 0.5)*0.5e-3); };
    const scalarField after =
        smooth(smoothing, spike(at(0, 0, 0)) + 2*spike(at(23, 10, 19)));

    forAll(after, cell)
    {
        ASSERT_NEAR(after[cell], expected[Lattice::indexAt(mesh().C()[cell])], 1e-12);
    }
}

TEST_F(SmoothingTest, KeepsTheTotal)
{
    const scalarField before = rough();

    const scalarField after = smooth(make(), before);

    EXPECT_NEAR(total(after), total(before), 1e-12*total(before));
    EXPECT_LT(Foam::gMax(after), 0.95*Foam::gMax(before)) << "nothing was smoothed";
}

TEST_F(SmoothingTest, NeverLeavesTheRangeOfItsInput)
{
    const scalarField before = rough();
    for (const double b : {0.1e-3, 0.4e-3, 1.5e-3})
    {
        const scalarField after = smooth(make(b), before);
        EXPECT_LE(Foam::gMax(after), Foam::gMax(before));
        EXPECT_GE(Foam::gMin(after), Foam::gMin(before));
    }
}

TEST_F(SmoothingTest, LeavesAUniformFieldAsItIs)
{
    const scalarField after = smooth(make(), scalarField(mesh().nCells(), 0.6));

    EXPECT_NEAR(Foam::gMax(after), 0.6, 1e-14);
    EXPECT_NEAR(Foam::gMin(after), 0.6, 1e-14);
}

TEST_F(SmoothingTest, DoesNothingWithoutWidth)
{
    const scalarField before = rough();
    const Smoothing smoothing = make(0);

    EXPECT_EQ(smoothing.sweeps(), 0);
    EXPECT_EQ(smooth(smoothing, before), before);
}

TEST_F(SmoothingTest, IsItsOwnAdjoint)
{
    const scalarField a = rough();
    const scalarField b = 1 + mesh().C().primitiveField().component(0)*1e3;
    const Smoothing smoothing = make();

    const scalar left = total(a*smooth(smoothing, b));
    EXPECT_NEAR(left, total(b*smooth(smoothing, a)), 1e-12*left);
}

TEST_F(SmoothingTest, IsTheSameOnAnyRanks)
{
    compareWithOneRank("smoothed", mesh(), smooth(make(), rough()), 1e-12);
}

// A wall of covered cells in the middle: each side keeps its total, the wall what it had.
TEST_F(SmoothingTest, LetsNothingThroughCoveredCells)
{
    const scalarField x(mesh().C().primitiveField().component(0) - 6.25e-3);
    const scalarField wall(Foam::neg(Foam::mag(x) - 0.4e-3));
    const scalarField left(Foam::neg(x)*(1 - wall));
    const scalarField before = rough();
    Smoothing smoothing = make();
    close(smoothing, 1 - wall);

    const scalarField after = smooth(smoothing, before);

    // The periodic box is open at its ends, where left meets right.
    if (!isPeriodic())
    {
        EXPECT_NEAR(total(left*after), total(left*before), 1e-12*total(left*before));
    }
    EXPECT_NEAR(total(after), total(before), 1e-12*total(before));
    EXPECT_EQ(largest(wall*(after - before)), 0);
    EXPECT_GT(largest(after - before), 0.01);
}

// Densities per open volume: where a solid cuts cells, at any share, an even bed stays even, what the
// open volumes hold is kept, nothing leaves its range, and the operator is its own adjoint.
TEST_F(SmoothingTest, KeepsToTheOpenVolumesOfCutCells)
{
    scalarField open(mesh().nCells());
    forAll(open, cell)
    {
        open[cell] = std::min(1.0, std::max(0.0, 2.6 - 0.4e3*mesh().C()[cell].x()));
    }
    Smoothing smoothing = make();
    close(smoothing, open);
    const scalarField volume(Foam::max(open, 1e-6));
    const scalarField a = rough();
    const scalarField b(a*a);

    const scalarField even = smooth(smoothing, scalarField(mesh().nCells(), 0.6));
    EXPECT_LT(largest(even - 0.6), 1e-14);
    const scalarField smoothA = smooth(smoothing, a);
    const scalarField smoothB = smooth(smoothing, b);
    EXPECT_NEAR(total(volume*smoothA), total(volume*a), 1e-12*total(a));
    EXPECT_NEAR(total(volume*b*smoothA), total(volume*a*smoothB), 1e-12*total(a));
    EXPECT_GE(Foam::gMin(smoothA), Foam::gMin(a));
    EXPECT_LE(Foam::gMax(smoothA), Foam::gMax(a));
    EXPECT_GT(largest(smoothA - a), 0.1);
}

// Seen from there as smooth as if all had been smoothed; and what was there alone is smoothed everywhere.
TEST_F(SmoothingTest, LeavesOutWhatIsOutOfReachWithoutChangingTheRest)
{
    const std::vector<int> cells = someCells();
    const Smoothing whole = make(0.4e-3);
    Smoothing near = make(0.4e-3);
    near.reach(cells);
    if (!Foam::Pstream::parRun())
    {
        ASSERT_LT(near.share(), 0.5);
    }
    const scalarField everywhere = rough();
    scalarField there(everywhere.size(), 0);
    for (const int cell : cells)
    {
        there[cell] = everywhere[cell];
    }

    EXPECT_EQ(smooth(near, there), smooth(whole, there));

    const scalarField expected = smooth(whole, everywhere);
    const scalarField found = smooth(near, everywhere);
    for (const int cell : cells)
    {
        ASSERT_EQ(found[cell], expected[cell]);
    }
}

} // namespace
} // namespace interstice
