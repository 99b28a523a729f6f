// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/SolidsOnMesh.hpp"
#include "tests/unit/mesh/BoxSurface.hpp"
#include "tests/unit/mesh/MeshTest.hpp"

namespace interstice
{
namespace
{

using Foam::vector;

class SolidsOnMeshTest : public MeshTest
{
protected:
    static RigidPose at(const vector& centre)
    {
        RigidPose pose;
        pose.translation = {centre.x(), centre.y(), centre.z()};
        return pose;
    }

    /// What the log says of a move.
    static std::string said(SolidsOnMesh& solids, const vector& centre)
    {
        testing::internal::CaptureStdout();
        solids.move({at(centre)});
        return testing::internal::GetCapturedStdout();
    }
};

// Of 1 mm. In the funnel cells are 0.4 to 0.5 mm wide, at the sides of the room above up to 0.65 mm.
TEST_F(SolidsOnMeshTest, WarnsOnceWhereABodyIsThinnerThanTwoCells)
{
    SolidsOnMesh solids(mesh());
    solids.add(std::make_unique<MovingSolid>(
        mesh(), "shoe", boxFile("oneMillimetre", vector(1e-3, 1e-3, 1e-3)), "here"));

    EXPECT_EQ(said(solids, vector(6e-3, 2e-3, -2e-3)), "");
    const std::string warning = said(solids, vector(1e-3, 2e-3, 5e-3));
    if (Foam::Pstream::master())
    {
        EXPECT_NE(warning.find("WARNING: The solid shoe, 0.001 m at its thinnest"), std::string::npos)
            << warning;
    }
    EXPECT_EQ(said(solids, vector(1e-3, 2e-3, 5e-3)), "");
}

TEST_F(SolidsOnMeshTest, SaysNothingOfABodyThickEnough)
{
    SolidsOnMesh solids(mesh());
    solids.add(std::make_unique<MovingSolid>(
        mesh(), "shoe", boxFile("twoMillimetres", vector(2e-3, 2e-3, 2e-3)), "here"));

    EXPECT_EQ(said(solids, vector(1e-3, 2e-3, 5e-3)), "");
}

} // namespace
} // namespace interstice
