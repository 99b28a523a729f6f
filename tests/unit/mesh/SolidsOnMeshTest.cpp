// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/SolidsOnMesh.hpp"
#include "tests/unit/mesh/BoxSurface.hpp"
#include "tests/unit/mesh/MeshTest.hpp"

namespace interstice
{
namespace
{

using Foam::scalar;
using Foam::vector;
using Foam::volScalarField;
using Foam::volVectorField;

class SolidsOnMeshTest : public MeshTest
{
protected:
    static RigidPose at(const vector& centre)
    {
        RigidPose pose;
        pose.translation = {centre.x(), centre.y(), centre.z()};
        return pose;
    }

    /// A body of 2 mm in the room above the funnel, turned by nothing and on its way.
    static void putBody(SolidsOnMesh& solids)
    {
        solids.add(std::make_unique<MovingSolid>(
            mesh(), "shoe", boxFile("twoMillimetres", vector(2e-3, 2e-3, 2e-3)), "here"));
        RigidPose pose = at(vector(2.13e-3, 2.05e-3, 5.21e-3));
        pose.velocity = {wall.x(), wall.y(), wall.z()};
        solids.move({pose});
    }

    template<class Type>
    static Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh> uniform(
        const Foam::dimensionSet& dimensions, const Type& value)
    {
        return {Foam::IOobject("uniform", "0", mesh()), mesh(),
            Foam::dimensioned<Type>("value", dimensions, value)};
    }

    /// Between 0.4 and 1.
    static volScalarField someVoidFraction()
    {
        volScalarField field = uniform(Foam::dimless, scalar(1));
        forAll(field, cell)
        {
            field[cell] = 0.7 + 0.3*std::sin(5e3*mesh().C()[cell].x());
        }
        return field;
    }

    inline static const vector wall{0.15, 0, -0.02};

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

// Of a cell, body and air take what they take: A U = c U_w + o a u, wherever a tenth of it is left to air.
TEST_F(SolidsOnMeshTest, SharesTheFluxOfACellBetweenBodyAndAir)
{
    SolidsOnMesh solids(mesh());
    putBody(solids);
    const volScalarField a = someVoidFraction();
    const volScalarField A(solids.ofWholeCells(a));
    const vector U(-0.3, 0.1, 0.2);
    const volVectorField u(solids.airInOpenPart(uniform(Foam::dimVelocity, U), a));
    int cut = 0;
    forAll(u, cell)
    {
        const scalar c = solids.covered()[cell];
        const scalar air = (1 - c)*a[cell];
        cut += c > 0 && c < 1;
        ASSERT_NEAR(A[cell], c + air, 2e-6);
        if (air > 0.1)
        {
            ASSERT_LT(Foam::mag(A[cell]*U - c*wall*(c > 0 ? 1 : 0) - air*u[cell]), 1e-12);
        }
    }
    EXPECT_GT(Foam::returnReduce(cut, Foam::sumOp<int>()), 20);
}

// Faces deep in the body have nothing open and its flux; those far from it are open.
TEST_F(SolidsOnMeshTest, ClosesTheFacesInABodyAndCarriesTheirFluxAlong)
{
    SolidsOnMesh solids(mesh());
    putBody(solids);
    const Foam::surfaceScalarField open(solids.openFaces());
    int inside = 0;
    forAll(open, face)
    {
        const vector away = cmptMag(mesh().Cf()[face] - vector(2.13e-3, 2.05e-3, 5.21e-3));
        ASSERT_GT(open[face], 0);
        ASSERT_LE(open[face], 1);
        if (cmptMax(away) < 0.6e-3)
        {
            ++inside;
            ASSERT_LE(open[face], 1e-3);
            ASSERT_NEAR(solids.flux()[face], wall & mesh().Sf()[face], 1e-12*Foam::mag(mesh().Sf()[face]));
        }
        if (cmptMax(away) > 1.8e-3)
        {
            ASSERT_EQ(open[face], 1);
        }
    }
    EXPECT_GT(Foam::returnReduce(inside, Foam::sumOp<int>()), 10);
}

// Where powder and body move alike, so do they draw the air; a cell that is quite covered is held by the body, one
// that is far away by the powder alone.
TEST_F(SolidsOnMeshTest, DrawsTheAirToWhereBodyAndPowderGo)
{
    SolidsOnMesh solids(mesh());
    putBody(solids);
    const scalar K = 1e5; // over density [1/s]
    volScalarField resistance = uniform(Foam::dimless/Foam::dimTime, K);
    volVectorField source = uniform(Foam::dimAcceleration, vector(K*wall));

    const volScalarField nu = uniform(Foam::dimViscosity, scalar(1.5e-5));
    solids.share(someVoidFraction(), nu, solids.friction(someVoidFraction(), nu), resistance, source);

    forAll(resistance, cell)
    {
        ASSERT_LT(Foam::mag(source[cell] - resistance[cell]*wall), 1e-12*Foam::mag(source[cell]));
        ASSERT_GE(resistance[cell], K);
        if (solids.covered()[cell] == 1)
        {
            ASSERT_GT(resistance[cell], 1e10);
        }
        if (Foam::mag(mesh().C()[cell] - vector(2e-3, 2e-3, 5e-3)) > 3e-3)
        {
            ASSERT_EQ(resistance[cell], K);
        }
    }
}

} // namespace
} // namespace interstice
