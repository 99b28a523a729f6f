// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/mesh/MeshTest.hpp"

#include <set>

namespace interstice
{
namespace
{

using Foam::label;
using Foam::scalar;
using Foam::vector;

class CellHaloTest : public MeshTest
{
protected:
    /// Centres and volumes of own cells and ghosts.
    static Foam::List<Packed<4>> centres()
    {
        Foam::List<Packed<4>> shape(mesh().nCells());
        forAll(shape, cell)
        {
            for (int d = 0; d < 3; ++d)
            {
                shape[cell][d] = mesh().C()[cell][d];
            }
            shape[cell][3] = mesh().V()[cell];
        }
        halo().toGhosts(shape);
        return shape;
    }

    static vector centreOf(const Packed<4>& shape) { return {shape[0], shape[1], shape[2]}; }

    /// Extent of a cell, parallel to the axes.
    static vector spanOf(label cell)
    {
        return Foam::boundBox(mesh().points(), mesh().cellPoints()[cell], false).span();
    }
};

// One layer in each direction that does not end at a wall; a single cell between cyclic patches
// is its own neighbour and is listed once.
TEST_F(CellHaloTest, HasAllCellsAroundACellAlsoAcrossRanksAndCyclics)
{
    if (Foam::gMax(mesh().V().field()) > 1.01*Foam::gMin(mesh().V().field()))
    {
        GTEST_SKIP() << "the count below is that of a uniform box";
    }
    const vector extent = mesh().bounds().span();
    forAll(mesh().V(), cell)
    {
        int expected = 1;
        for (int d = 0; d < 3; ++d)
        {
            const scalar width = spanOf(cell)[d];
            const scalar x = mesh().C()[cell][d] - mesh().bounds().min()[d];
            const bool single = extent[d] < 1.5*width;
            const bool atWall = ground().box.period()[d] == 0
                && (x < width || x > extent[d] - width);
            expected *= single ? 1 : atWall ? 2 : 3;
        }
        ASSERT_EQ(halo().neighbourhood()[cell].size(), expected) << "cell " << cell;
    }
}

TEST_F(CellHaloTest, ListsTheCellItselfFirstAndEveryCellOnce)
{
    forAll(mesh().V(), cell)
    {
        const Foam::labelList& around = halo().neighbourhood()[cell];
        ASSERT_EQ(around[0], cell);
        ASSERT_EQ(std::set<label>(around.begin(), around.end()).size(), std::size_t(around.size()));
        for (const label other : around)
        {
            ASSERT_LT(other, halo().size());
        }
    }
}

// A ghost's centre must be where a cell of the neighbourhood lies: within one layer of cells,
// which are up to twice as wide as the cell itself.
TEST_F(CellHaloTest, GivesGhostsTheValuesOfTheCellsTheyAreCopiesOf)
{
    const Foam::List<Packed<4>> all = centres();
    ASSERT_EQ(all.size(), halo().size());
    forAll(mesh().V(), cell)
    {
        const vector reach = 1.51*spanOf(cell);
        for (const label other : halo().neighbourhood()[cell])
        {
            const vector d = ground().box.nearest(centreOf(all[other]) - mesh().C()[cell]);
            for (int axis = 0; axis < 3; ++axis)
            {
                ASSERT_LE(Foam::mag(d[axis]), reach[axis]) << "cell " << cell;
            }
        }
    }
}

TEST_F(CellHaloTest, HasGhostsOnlyBetweenRanks)
{
    const label ghosts = Foam::returnReduce(halo().size() - halo().nCells(),
        Foam::sumOp<label>());
    EXPECT_EQ(ghosts > 0, Foam::Pstream::parRun());
    EXPECT_EQ(halo().nCells(), mesh().nCells());
}

// <toGhosts(a), b> = <a, addGhosts(b)> for random a on own cells and b on own cells and ghosts.
TEST_F(CellHaloTest, AddsGhostsByTheTransposeOfFillingThem)
{
    Dice dice(17 + Foam::Pstream::myProcNo());
    const auto fill = [&dice](Foam::List<Packed<2>>& list)
    {
        for (Packed<2>& value : list)
        {
            value[0] = dice.between(-1, 1);
            value[1] = dice.between(-1, 1);
        }
    };
    Foam::List<Packed<2>> a(halo().nCells());
    Foam::List<Packed<2>> b(halo().size());
    fill(a);
    fill(b);

    Foam::List<Packed<2>> aEverywhere(a);
    halo().toGhosts(aEverywhere);
    Foam::List<Packed<2>> bGathered(b);
    halo().addGhosts(bGathered);

    ASSERT_EQ(bGathered.size(), halo().nCells());
    for (int n = 0; n < 2; ++n)
    {
        scalar left = 0;
        scalar right = 0;
        scalar size = 0;
        forAll(b, i)
        {
            left += aEverywhere[i][n]*b[i][n];
            size += Foam::mag(aEverywhere[i][n]*b[i][n]);
        }
        forAll(a, i)
        {
            right += a[i][n]*bGathered[i][n];
        }
        Foam::reduce(left, Foam::sumOp<scalar>());
        Foam::reduce(right, Foam::sumOp<scalar>());
        Foam::reduce(size, Foam::sumOp<scalar>());
        EXPECT_NEAR(left, right, 1e-13*size);
    }
}

TEST_F(CellHaloTest, LinksEveryFaceToTheCellBehindIt)
{
    const Foam::List<Packed<4>> all = centres();
    std::size_t coupled = 0;
    for (const Foam::fvPatch& patch : mesh().boundary())
    {
        coupled += patch.coupled() ? patch.size() : 0;
    }
    ASSERT_EQ(halo().links().size(), mesh().nInternalFaces() + coupled);
    for (const CellHalo::Link& link : halo().links())
    {
        ASSERT_TRUE(halo().neighbourhood()[link.cell].found(link.other));
        // Neighbours across a face of this mesh differ along one axis only.
        const vector d = ground().box.nearest(centreOf(all[link.other]) - mesh().C()[link.cell]);
        const int axis = Foam::mag(d.x()) > 1e-9 ? 0 : Foam::mag(d.y()) > 1e-9 ? 1 : 2;
        ASSERT_NEAR(Foam::mag(d), Foam::mag(d[axis]), 1e-12);
        const bool single = ground().box.period()[0] > 0 && mesh().bounds().span().x() < 1e-3;
        ASSERT_TRUE(single || Foam::mag(d[axis]) > 1e-5) << "linked to itself";
        ASSERT_EQ(link.internal, &link - halo().links().data() < mesh().nInternalFaces());
    }
}

// |S|/d by hand: the cell's volume over its width is the face, the distance of the centres is d.
TEST_F(CellHaloTest, ConductsByTheFaceAreaOverTheDistanceOfTheCentres)
{
    const Foam::List<Packed<4>> all = centres();
    for (const CellHalo::Link& link : halo().links())
    {
        const vector d = ground().box.nearest(centreOf(all[link.other]) - mesh().C()[link.cell]);
        if (Foam::mag(d) < 1e-9)
        {
            continue; // a single cell between cyclic patches
        }
        const vector span = spanOf(link.cell);
        const int axis = Foam::mag(d.x()) > 1e-9 ? 0 : Foam::mag(d.y()) > 1e-9 ? 1 : 2;
        const scalar area = mesh().V()[link.cell]/span[axis];
        ASSERT_NEAR(link.conductance, area/Foam::mag(d), 1e-6*link.conductance);
    }
}

} // namespace
} // namespace interstice
