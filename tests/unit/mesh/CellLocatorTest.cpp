// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/mesh/MeshTest.hpp"

namespace interstice
{
namespace
{

using Foam::label;
using Foam::point;
using Foam::vector;
using Quality = Location::Quality;

class CellLocatorTest : public MeshTest
{
protected:
    static Location find(const point& p) { return findOr(p, p); }

    static Location findOr(const point& p, const point& fallback)
    {
        return ground().locator({toVec3(p), toVec3(fallback)});
    }

    static double sizeOf(label cell) { return std::cbrt(mesh().V()[cell]); }

    /// Far from every mesh of these tests.
    static point nowhere() { return point(1, 1, 1); }
};

TEST_F(CellLocatorTest, AgreesWithOpenFoamForRandomPoints)
{
    // Somewhat larger than the mesh, so that it also covers what lies outside.
    Foam::boundBox around(mesh().bounds());
    around.inflate(0.05);
    Dice dice(1);
    int inside = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const point p = dice.within(around);
        const label expected = mesh().findCell(p, Foam::polyMesh::CELL_TETS);
        const Location found = find(p);
        ASSERT_EQ(found.quality == Quality::exact, expected >= 0) << p.x() << ' ' << p.y();
        if (expected >= 0)
        {
            ASSERT_EQ(found.cell, expected);
            ++inside;
        }
    }
    EXPECT_GT(inside, 4000/Foam::Pstream::nProcs()/8);
}

TEST_F(CellLocatorTest, FindsTheCentreOfEveryCellInThatCell)
{
    for (label cell = 0; cell < mesh().nCells(); ++cell)
    {
        const Location found = find(mesh().C()[cell]);
        ASSERT_EQ(found.quality, Quality::exact);
        ASSERT_EQ(found.cell, cell);
    }
}

TEST_F(CellLocatorTest, GivesAPointOnAFaceToOneOfTheCellsOfTheFace)
{
    for (label face = 0; face < mesh().nFaces(); ++face)
    {
        const Location found = find(mesh().faceCentres()[face]);
        ASSERT_EQ(found.quality, Quality::exact) << "face " << face;
        const bool isOwner = found.cell == mesh().faceOwner()[face];
        const bool isNeighbour =
            face < mesh().nInternalFaces() && found.cell == mesh().faceNeighbour()[face];
        ASSERT_TRUE(isOwner || isNeighbour) << "face " << face;
    }
}

TEST_F(CellLocatorTest, GivesACornerToOneOfItsCells)
{
    for (label corner = 0; corner < mesh().nPoints(); ++corner)
    {
        const Location found = find(mesh().points()[corner]);
        ASSERT_EQ(found.quality, Quality::exact) << "point " << corner;
        ASSERT_TRUE(mesh().pointCells()[corner].found(found.cell)) << "point " << corner;
    }
}

// 1 % and 20 % of a cell beyond the outermost faces: the limit is a twentieth.
TEST_F(CellLocatorTest, TakesAPointJustOutsideAsFallbackAndNotOneFurtherAway)
{
    for (const Foam::polyPatch& patch : mesh().boundaryMesh())
    {
        if (patch.name() != "walls")
        {
            continue;
        }
        for (label i = 0; i < patch.size(); ++i)
        {
            const label cell = patch.faceCells()[i];
            const vector outward = patch.faceNormals()[i];
            const Location near =
                findOr(patch.faceCentres()[i] + 0.01*sizeOf(cell)*outward, nowhere());
            ASSERT_EQ(near.quality, Quality::fallback) << "face " << i;
            ASSERT_EQ(near.cell, cell);
            const Location far =
                findOr(patch.faceCentres()[i] + 0.2*sizeOf(cell)*outward, nowhere());
            ASSERT_EQ(far.quality, Quality::notHere) << "face " << i;
        }
    }
}

TEST_F(CellLocatorTest, TakesTheCellOfTheFallbackWhereThePositionIsOutside)
{
    for (label cell = 0; cell < mesh().nCells(); cell += 7)
    {
        const Location found = findOr(nowhere(), mesh().C()[cell]);
        ASSERT_EQ(found.quality, Quality::fallback);
        ASSERT_EQ(found.cell, cell);
    }
}

TEST_F(CellLocatorTest, PrefersThePositionToTheFallback)
{
    const label last = mesh().nCells() - 1;
    const Location found = findOr(mesh().C()[last], mesh().C()[0]);

    EXPECT_EQ(found.quality, Quality::exact);
    EXPECT_EQ(found.cell, last);
}

TEST_F(CellLocatorTest, SeesNothingFarAway)
{
    EXPECT_EQ(find(nowhere()).quality, Quality::notHere);
}

TEST_F(CellLocatorTest, BoundsAllPointsOfTheCellsHere)
{
    for (const point& p : mesh().points())
    {
        ASSERT_TRUE(ground().locator.bounds().contains(toVec3(p)));
    }
}

} // namespace
} // namespace interstice
