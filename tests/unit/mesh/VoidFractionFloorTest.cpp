// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/VoidFractionFloor.hpp"
#include "tests/unit/mesh/OneRankReference.hpp"
#include "tests/unit/mesh/PowderScene.hpp"

namespace interstice
{
namespace
{

using Foam::scalar;
using Foam::scalarField;
using Foam::vector;

constexpr double minimum = 0.35;
constexpr double most = 1 - minimum;

class VoidFractionFloorTest : public MeshTest
{
protected:
    static scalar total(const scalarField& solids)
    {
        return Foam::gSum((solids*mesh().V().field())());
    }

    static VoidFractionFloor::Report apply(scalarField& solids)
    {
        return VoidFractionFloor(mesh(), halo(), minimum).apply(solids);
    }

    static scalarField adjoint(const VoidFractionFloor& floor, const scalarField& values)
    {
        Foam::List<Packed<1>> packed(values.size());
        forAll(values, cell)
        {
            packed[cell][0] = values[cell];
        }
        floor.adjoint(packed);
        scalarField seen(values.size());
        forAll(values, cell)
        {
            seen[cell] = packed[cell][0];
        }
        return seen;
    }

    /// A bed of 0.55 that fills the mesh, in which two clusters overlap twice: 0.9. They lie
    /// across the middle of the mesh in x and in y, where it is cut for more than one rank.
    static scalarField overlapped()
    {
        const vector middle = mesh().bounds().midpoint();
        scalarField solids(mesh().nCells(), 0.55);
        forAll(solids, cell)
        {
            if (Foam::mag(mesh().C()[cell] - middle) < 1.6e-3)
            {
                solids[cell] = 0.9;
            }
        }
        return solids;
    }
};

TEST_F(VoidFractionFloorTest, KeepsTheFloorAndTheVolumeOfAnOverlappedCluster)
{
    scalarField solids = overlapped();
    const scalar before = total(solids);
    const scalar excess = total(Foam::max(solids - most, scalar(0)));
    const int cells = Foam::returnReduce(
        int(std::count_if(solids.begin(), solids.end(), [](double s) { return s > most; })),
        Foam::sumOp<int>());
    ASSERT_GT(cells, 20);

    const VoidFractionFloor::Report report = apply(solids);

    EXPECT_LE(Foam::gMax(solids), most + 1e-15);
    EXPECT_NEAR(total(solids), before, 1e-12*before);
    EXPECT_EQ(report.clipped, 0);
    EXPECT_EQ(report.cells, cells);
    EXPECT_NEAR(report.moved, excess, 1e-12*excess);
}

TEST_F(VoidFractionFloorTest, GivesTheSameFieldOnAnyRanks)
{
    scalarField solids = overlapped();
    apply(solids);

    compareWithOneRank("floored", mesh(), solids, 1e-12);
}

// The nearest room takes it: far from the cluster nothing changes by more than round-off.
TEST_F(VoidFractionFloorTest, PutsTheExcessNearby)
{
    const scalarField before = overlapped();
    scalarField solids = before;
    apply(solids);

    const vector middle = mesh().bounds().midpoint();
    forAll(solids, cell)
    {
        if (before[cell] < most)
        {
            ASSERT_GE(solids[cell], before[cell] - 1e-15);
        }
        if (Foam::mag(mesh().C()[cell] - middle) > 4.5e-3)
        {
            ASSERT_NEAR(solids[cell], before[cell], 1e-9) << "cell " << cell;
        }
    }
}

// A cluster in a full bed, with room further away. A trace of room on one side of it must not draw all of
// the excess to that side: with each step of the powder the air would be pushed to and fro.
TEST_F(VoidFractionFloorTest, FollowsATraceOfRoomWithoutAJump)
{
    const vector middle = mesh().bounds().midpoint();
    scalarField even = overlapped();
    scalarField uneven = even;
    forAll(even, cell)
    {
        if (even[cell] < most && Foam::mag(mesh().C()[cell] - middle) < 2.6e-3)
        {
            even[cell] = most;
            uneven[cell] = most - (mesh().C()[cell].x() < middle.x() ? 1e-6 : 0);
        }
    }
    const scalar change = Foam::gMax(Foam::mag(even - uneven));
    ASSERT_GT(apply(even).moved, 0);
    apply(uneven);

    EXPECT_LT(Foam::gMax(Foam::mag(even - uneven)), 50*change);
}

TEST_F(VoidFractionFloorTest, ChangesNothingWhereNothingIsTooMuch)
{
    scalarField solids(mesh().nCells(), most);
    const VoidFractionFloor::Report report = apply(solids);

    EXPECT_EQ(solids, scalarField(mesh().nCells(), most));
    EXPECT_EQ(report.cells, 0);
    EXPECT_EQ(report.moved, 0);
    EXPECT_EQ(report.clipped, 0);
}

// Everywhere 0.9: there is no room, and what the air does not see is 0.25 of the mesh.
TEST_F(VoidFractionFloorTest, ReportsExactlyWhatFindsNoRoom)
{
    scalarField solids(mesh().nCells(), 0.9);
    const scalar volume = Foam::gSum(mesh().V().field());

    const VoidFractionFloor::Report report = apply(solids);

    EXPECT_NEAR(report.clipped, (0.9 - most)*volume, 1e-12*volume);
    EXPECT_NEAR(report.moved, 0, 1e-12*volume);
    EXPECT_NEAR(Foam::gMin(solids), most, 1e-14);
    EXPECT_LE(Foam::gMax(solids), most + 1e-15);
}

// One half of the mesh is inside a solid: what is too much in the other half stays there.
TEST_F(VoidFractionFloorTest, HandsNothingIntoASolid)
{
    const vector middle = mesh().bounds().midpoint();
    Foam::scalarList open(mesh().nCells(), 1.0);
    scalarField solids = overlapped();
    forAll(solids, cell)
    {
        if (mesh().C()[cell].z() > middle.z())
        {
            open[cell] = 0;
            solids[cell] = 0;
        }
    }
    halo().toGhosts(open);
    const scalar before = total(solids);

    VoidFractionFloor floor(mesh(), halo(), minimum);
    floor.close(open);
    const VoidFractionFloor::Report report = floor.apply(solids);

    ASSERT_GT(report.moved, 0);
    EXPECT_EQ(report.clipped, 0);
    EXPECT_NEAR(total(solids), before, 1e-12*before);
    forAll(solids, cell)
    {
        ASSERT_TRUE(open[cell] > 0 || solids[cell] == 0) << "cell " << cell;
    }
}

// Too much for the room there is: the mesh is full, the rest is reported.
TEST_F(VoidFractionFloorTest, LosesNothingBetweenWhatItMovesAndWhatItReports)
{
    const scalar middle = mesh().bounds().midpoint().z();
    scalarField solids(mesh().nCells(), 0.9);
    forAll(solids, cell)
    {
        solids[cell] = mesh().C()[cell].z() > middle ? 0.9 : 0.6;
    }
    const scalar before = total(solids);

    const VoidFractionFloor::Report report = apply(solids);

    EXPECT_LE(Foam::gMax(solids), most + 1e-15);
    EXPECT_GT(report.clipped, 0);
    EXPECT_NEAR(total(solids) + report.clipped, before, 1e-12*before);
}

// What acts on the cells acts on the powder that was moved to them: sum of volume times value.
TEST_F(VoidFractionFloorTest, AdjointKeepsTheForceOnWhatIsMoved)
{
    const scalarField values(1 + mesh().C().primitiveField().component(0)*1e3
        + Foam::sqr(mesh().C().primitiveField().component(2)*1e3));
    const scalarField deposited = overlapped();
    scalarField solids = deposited;
    VoidFractionFloor floor(mesh(), halo(), minimum);

    floor.apply(solids);

    const scalarField seen = adjoint(floor, values);
    EXPECT_GT(Foam::gMax(Foam::mag(seen - values)), 0.1);
    const scalar force = total(solids*values);
    EXPECT_NEAR(total(deposited*seen), force, 1e-12*force);
    EXPECT_GT(std::abs(total(deposited*values) - force), 1e-4*force) << "nothing to see here";
    compareWithOneRank("adjoint", mesh(), seen, 1e-12);
}

// Powder that is cut off is not seen by the air, and does not feel it.
TEST_F(VoidFractionFloorTest, AdjointGivesNothingToWhatIsCutOff)
{
    const scalarField values(mesh().nCells(), 2.0);
    scalarField solids(mesh().nCells(), 0.9);
    VoidFractionFloor floor(mesh(), halo(), minimum);

    floor.apply(solids);

    const scalarField seen = adjoint(floor, values);
    EXPECT_NEAR(Foam::gMin(seen), 2*most/0.9, 1e-12);
    EXPECT_NEAR(Foam::gMax(seen), 2*most/0.9, 1e-12);
}

// The map is that of the last deposit: none is left when nothing is too much.
TEST_F(VoidFractionFloorTest, AdjointForgetsTheDepositBefore)
{
    scalarField solids = overlapped();
    VoidFractionFloor floor(mesh(), halo(), minimum);
    floor.apply(solids);
    solids = 0.5;
    floor.apply(solids);

    const scalarField values(mesh().C().primitiveField().component(1));
    EXPECT_EQ(adjoint(floor, values), values);
}

} // namespace
} // namespace interstice
