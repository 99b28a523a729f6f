// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/PeriodicBox.hpp"
#include "tests/unit/FoamTest.hpp"

#include "Time.H"
#include "fvMesh.H"

#include <gtest/gtest.h>

#include <string>

namespace interstice
{
namespace
{

using Foam::vector;

class PeriodicBoxTest : public testing::Test
{
protected:
    /// The case is in the build tree as <name>.np<ranks>.
    static std::string caseName()
    {
        const std::string name = foamTime().globalCaseName();
        return name.substr(0, name.find('.'));
    }

    static bool isOblique() { return caseName() == "oblique"; }

    static vector expectedPeriod()
    {
        const vector size(12e-3, 8e-3, 10e-3);
        if (caseName() == "periodic")
        {
            return size;
        }
        return caseName() == "periodicY" ? vector(0, size.y(), 0) : vector(Foam::Zero);
    }

    Foam::fvMesh mesh{Foam::IOobject(Foam::fvMesh::defaultRegion, "0", foamTime())};
};

// Cut in y on four ranks, the two ranks in the middle have no face of the cyclic patches.
TEST_F(PeriodicBoxTest, FindsThePeriodOnEveryRank)
{
    if (isOblique())
    {
        GTEST_SKIP();
    }
    const PeriodicBox box(mesh);

    EXPECT_NEAR(mag(box.period() - expectedPeriod()), 0, 1e-15);
}

TEST_F(PeriodicBoxTest, WrapsAPointIntoTheBoxAlongPeriodicDirectionsOnly)
{
    if (isOblique())
    {
        GTEST_SKIP();
    }
    const PeriodicBox box(mesh);
    const vector inside(1e-3, 7e-3, 6e-3);
    const vector size(12e-3, 8e-3, 10e-3);

    for (const vector& periods : {vector(0, 0, 0), vector(1, -1, 1), vector(-3, 2, -1)})
    {
        const vector shift = cmptMultiply(periods, size);
        vector expected = inside;
        for (int d = 0; d < 3; ++d)
        {
            expected[d] += expectedPeriod()[d] > 0 ? 0 : shift[d];
        }
        EXPECT_NEAR(mag(box.wrap(inside + shift) - expected), 0, 1e-15);
    }
}

TEST_F(PeriodicBoxTest, KeepsAPointOnItsLowerFaceWhereItIs)
{
    if (isOblique())
    {
        GTEST_SKIP();
    }
    const PeriodicBox box(mesh);

    EXPECT_EQ(box.wrap(vector(0, 0, 0)), vector(0, 0, 0));
}

// From 7.9 mm to 0.1 mm it is 0.2 mm across a period of 8 mm.
TEST_F(PeriodicBoxTest, GivesTheShortestImageOfADistance)
{
    if (isOblique())
    {
        GTEST_SKIP();
    }
    const PeriodicBox box(mesh);
    const vector distance = box.nearest(vector(0, 0.1e-3 - 7.9e-3, 0));

    EXPECT_NEAR(distance.y(), expectedPeriod().y() > 0 ? 0.2e-3 : -7.8e-3, 1e-15);
    EXPECT_EQ(box.nearest(vector(1e-3, -2e-3, 3e-3)), vector(1e-3, -2e-3, 3e-3));
}

TEST_F(PeriodicBoxTest, RefusesAPeriodThatIsNotAlongAnAxisOnAllRanks)
{
    if (!isOblique())
    {
        GTEST_SKIP();
    }
    try
    {
        const PeriodicBox box(mesh);
        FAIL() << "an oblique shift was taken";
    }
    catch (const InputError& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("constant/polyMesh/boundary"), std::string::npos) << text;
        EXPECT_NE(text.find("cyclic"), std::string::npos) << text;
    }
}

} // namespace
} // namespace interstice
