// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/mesh/PowderScene.hpp"

namespace interstice
{
namespace
{

using Foam::point;
using Foam::scalar;
using Foam::scalarField;
using Foam::vector;

using DepositAtSolidsTest = MeshTest;

// Half of the box is inside a wall; what is close to it falls to the open half.
TEST_F(DepositAtSolidsTest, PutsNothingIntoCoveredCells)
{
    const scalar middle = mesh().bounds().midpoint().x();
    const scalarField open(Foam::pos0(middle - mesh().C().primitiveField().component(0)));
    const std::vector<point> cloud = cloudInside(ground(), 1000, 15);
    PowderScene scene(ground(), "kernel");
    scene.close(open);

    std::vector<point> outside;
    std::copy_if(cloud.begin(), cloud.end(), std::back_inserter(outside),
        [&](const point& p) { return p.x() < middle && p.x() > mesh().bounds().min().x() + 1e-3; });
    scene.place(outside);
    const scalarField density = scene.deposit([](int) { return 1.0; });
    EXPECT_NEAR(Foam::gSum((density*mesh().V().field())()), outside.size(), 1e-12*outside.size());
    EXPECT_EQ(largest((1 - open)*density), 0);
}

// A particle on the surface of a solid, wherever in its cell that is, finds a cell that receives it
// whole; those that are covered all over get nothing. As the surface moves through the cells, nothing
// jumps.
TEST_F(DepositAtSolidsTest, FindsRoomForWhatTouchesASolid)
{
    const scalarField x(mesh().C().primitiveField().component(0));
    const scalar width = std::cbrt(Foam::gAverage(mesh().V().field()));
    const vector centre = mesh().bounds().midpoint();
    const double step = 0.005;
    PowderScene scene(ground(), "kernel");
    scalarField before;
    for (double surface = 0; surface < 2; surface += step)
    {
        const point place(centre.x() + surface*width, centre.y(), centre.z());
        const scalarField open(min(max(0.5 + (place.x() - x)/width, scalar(0)), scalar(1)));
        scene.close(open);
        scene.place({place});
        const scalarField share(
            scene.deposit([](int) { return 1.0; })*openVolumes(mesh(), open));
        ASSERT_NEAR(Foam::gSum(share), 1, 1e-12) << "surface " << surface;
        ASSERT_EQ(largest(Foam::neg0(open)*share), 0) << "surface " << surface;
        if (before.size())
        {
            ASSERT_LT(largest(share - before), 10*step) << "surface " << surface;
        }
        before = share;
    }
}

// A row of particles, as many on every stretch, that ends at the surface of a solid, wherever in its
// cell that is: all of them cells' open volumes hold as much.
TEST_F(DepositAtSolidsTest, SpreadsPowderEvenlyUpToASolid)
{
    const scalarField x(mesh().C().primitiveField().component(0));
    const double width = 0.5e-3; // of a cell along x
    const vector first = mesh().bounds().min() + 0.5*width*vector::one;
    const int perCell = 400;
    const int column = 12; // that is cut
    PowderScene scene(ground(), "kernel");
    for (const double cut : {0.0, 0.1, 0.25, 0.4, 0.5, 0.75, 0.9})
    {
        const double surface = mesh().bounds().min().x() + (column + 1 - cut)*width;
        const scalarField open(min(max(0.5 + (surface - x)/width, scalar(0)), scalar(1)));
        std::vector<point> row;
        for (double place = surface - 0.5*width/perCell; place > first.x() + 2*width; place -= width/perCell)
        {
            row.push_back(point(place, first.y(), first.z()));
        }
        scene.close(open);
        scene.place(row);

        const scalarField held(scene.deposit([](int) { return 1.0; })*openVolumes(mesh(), open));
        for (int i = 4; i <= column; ++i)
        {
            const scalarField here(Foam::pos(0.1*width - mag(x - first.x() - i*width)));
            const double share = i < column ? 1 : 1 - cut;
            EXPECT_NEAR(Foam::gSum((here*held)())/(perCell*share), 1, 0.02) << "cut " << cut << ", column " << i;
        }
    }
}

} // namespace
} // namespace interstice
