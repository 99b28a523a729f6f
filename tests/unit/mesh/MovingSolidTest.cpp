// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/MovingSolid.hpp"
#include "tests/unit/mesh/BoxSurface.hpp"
#include "tests/unit/mesh/MeshTest.hpp"

#include "fvCFD.H"

#include <cmath>
#include <cstring>

namespace interstice
{
namespace
{

using Foam::point;
using Foam::scalar;
using Foam::vector;

class MovingSolidTest : public MeshTest
{
protected:
    MovingSolidTest()
    :
        covered_(Foam::IOobject("covered", "0", mesh()), mesh(), Foam::dimless),
        velocity_(Foam::IOobject("velocity", "0", mesh()), mesh(), Foam::dimVelocity)
    {}

    static MovingSolid make(const std::string& path)
    {
        return MovingSolid(mesh(), "shoe", path, "constant/couplingProperties, solids, shoe");
    }

    /// Turned about the axis (1 1 1) or another by an angle, its centre at a point.
    static RigidPose posed(const point& centre, vector axis = vector(0, 0, 1), double angle = 0)
    {
        axis /= Foam::mag(axis);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const vector& n = axis;
        RigidPose pose;
        pose.rotation = {c + (1 - c)*n.x()*n.x(), (1 - c)*n.x()*n.y() - s*n.z(),
            (1 - c)*n.x()*n.z() + s*n.y(), (1 - c)*n.y()*n.x() + s*n.z(),
            c + (1 - c)*n.y()*n.y(), (1 - c)*n.y()*n.z() - s*n.x(),
            (1 - c)*n.z()*n.x() - s*n.y(), (1 - c)*n.z()*n.y() + s*n.x(),
            c + (1 - c)*n.z()*n.z()};
        pose.translation = {centre.x(), centre.y(), centre.z()};
        return pose;
    }

    static point middle() { return mesh().bounds().midpoint(); }

    void cover(const MovingSolid& solid, const RigidPose& pose)
    {
        covered_.primitiveFieldRef() = 0;
        velocity_.primitiveFieldRef() = Foam::Zero;
        solid.cover(pose, covered_.primitiveFieldRef(), velocity_);
    }

    scalar coveredVolume() const
    {
        return Foam::gSum((covered_.primitiveField()*mesh().V().field())());
    }

    /// The message that a surface is refused with; empty if it is taken.
    static std::string refusal(const std::string& path)
    {
        try
        {
            make(path);
            return "";
        }
        catch (const InputError& error)
        {
            return error.what();
        }
    }

    Foam::volScalarField covered_;
    Foam::volVectorField velocity_;
};

constexpr double side = 5e-3;
const vector cube(side, side, side);

TEST_F(MovingSolidTest, CoversTheVolumeOfTheBodyAtAnyPose)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    const double expected = side*side*side;

    for (const vector& shift : {vector(0, 0, 0), vector(0.21e-3, 0.13e-3, 0.07e-3),
             vector(-1.1e-3, 0.3e-3, 0.8e-3)})
    {
        cover(solid, posed(middle() + shift));
        EXPECT_NEAR(coveredVolume(), expected, 0.01*expected);
    }
    for (const double angle : {0.2, 0.7, 1.3})
    {
        cover(solid, posed(middle(), vector(0.2, 0.1, 1), angle));
        EXPECT_NEAR(coveredVolume(), expected, 0.01*expected) << "angle " << angle;
    }
}

TEST_F(MovingSolidTest, CoversCellsDeepInsideWhollyAndFarAwayNotAtAll)
{
    cover(make(boxFile("cube", cube)), posed(middle()));

    forAll(covered_, cell)
    {
        const vector d = cmptMag(mesh().C()[cell] - middle());
        const double outside = cmptMax(d) - side/2;
        ASSERT_GE(covered_[cell], 0);
        ASSERT_LE(covered_[cell], 1);
        if (outside < -0.4e-3)
        {
            ASSERT_EQ(covered_[cell], 1);
        }
        if (outside > 0.4e-3)
        {
            ASSERT_EQ(covered_[cell], 0);
        }
    }
}

// A tenth of a micrometre and 2e-5 rad at a time: nothing switches. The ramp is 0.46 mm wide, a
// distance of the table is never steeper than sqrt(3).
TEST_F(MovingSolidTest, ChangesContinuouslyWithThePose)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    const double step = 1e-7;
    const double steepest = 2*(step + 2e-5*side)/0.46e-3;
    Foam::scalarField before;
    for (int n = 0; n < 60; ++n)
    {
        // From far to near in leaps, each leap followed by one small step.
        const double x = n/2*20e-6 + n % 2*step;
        cover(solid, posed(middle() + vector(x, 0.3*x, 0), vector(1, 1, 1),
                         n/2*0.02 + n % 2*2e-5));
        const Foam::scalarField now = covered_.primitiveField();
        if (n % 2 == 1)
        {
            ASSERT_LE(Foam::gMax(Foam::mag(now - before)()), steepest) << "step " << n;
            ASSERT_GT(Foam::gMax(Foam::mag(now - before)()), 0) << "step " << n;
        }
        before = now;
    }
}

TEST_F(MovingSolidTest, TurnsWithItsPose)
{
    // 7 mm long in x, and after a quarter turn about z in y.
    const MovingSolid rod = make(boxFile("rod", vector(7e-3, 2e-3, 2e-3)));
    const auto isCovered = [&](const point& p)
    {
        scalar found = 0;
        for (const int cell : handle(ground(), {p}).cells)
        {
            found = covered_[cell];
        }
        return Foam::returnReduce(found, Foam::maxOp<scalar>());
    };
    const vector alongX(2.6e-3, 0.05e-3, 0.05e-3);
    const vector alongY(0.05e-3, 2.6e-3, 0.05e-3);

    cover(rod, posed(middle()));
    EXPECT_EQ(isCovered(middle() + alongX), 1);
    EXPECT_EQ(isCovered(middle() + alongY), 0);

    cover(rod, posed(middle(), vector(0, 0, 1), Foam::constant::mathematical::piByTwo));
    EXPECT_EQ(isCovered(middle() + alongX), 0);
    EXPECT_EQ(isCovered(middle() + alongY), 1);
}

// Through the middle of a face and near a corner, in a body that is turned: what is outside stays,
// what has sunk in by a part of a cell is seen on the face, and so much less.
TEST_F(MovingSolidTest, ShowsWhatSinksIntoItOnItsSurfaceAndFading)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    const RigidPose pose = posed(middle(), vector(1, 1, 1), 0.7);
    const double cell = std::cbrt(Foam::gMin(mesh().V()));
    const auto here = [&](const vector& inBody)
    {
        const RigidPose::Vector p = pose.fromReference({inBody.x(), inBody.y(), inBody.z()});
        return vector(p[0], p[1], p[2]);
    };
    for (const vector& across : {vector(0, 0.1e-3, 0.2e-3), vector(0, 0.3*side, -0.3*side)})
    {
        for (const double depth : {-1.0, -0.1, 0.1, 0.3, 0.8, 1.2})
        {
            const vector place(0.5*side - depth*cell, 0, 0);
            const MovingSolid::Seen seen = solid.outside(pose, here(place + across));
            EXPECT_NEAR(seen.presence, std::min(1.0, std::max(0.0, 1 - 2*depth)), 1e-3) << depth;
            const vector expected(depth > 0 ? 0.5*side : place.x(), 0, 0);
            EXPECT_LT(Foam::mag(seen.position - here(expected + across)), 1e-3*cell) << depth;
        }
    }
}

// v + w x r by hand, in every covered cell; the others keep what they had.
TEST_F(MovingSolidTest, MovesTheAirWithTheVelocityOfThePose)
{
    RigidPose pose = posed(middle());
    pose.velocity = {0.1, -0.2, 0.3};
    pose.angularVelocity = {0, 0, 5};
    cover(make(boxFile("cube", cube)), pose);

    forAll(covered_, cell)
    {
        const vector r = mesh().C()[cell] - middle();
        const vector expected = covered_[cell] > 0
            ? vector(0.1 - 5*r.y(), -0.2 + 5*r.x(), 0.3)
            : vector(Foam::Zero);
        ASSERT_NEAR(Foam::mag(velocity_[cell] - expected), 0, 1e-12);
    }
}

TEST_F(MovingSolidTest, LeavesCellsThatAnotherBodyCoversMoreToThatOne)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    covered_.primitiveFieldRef() = 0.5;
    velocity_.primitiveFieldRef() = vector(1, 0, 0);
    RigidPose pose = posed(middle());
    pose.velocity = {0, 0, 2};

    solid.cover(pose, covered_.primitiveFieldRef(), velocity_);

    EXPECT_EQ(Foam::gMin(covered_.primitiveField()), 0.5);
    forAll(covered_, cell)
    {
        ASSERT_EQ(velocity_[cell], covered_[cell] > 0.5 ? vector(0, 0, 2) : vector(1, 0, 0));
    }
}

// The cube's side at +x comes to the middle of a face, whatever its shape. A face across the way counts the time
// for which it is covered; one along the way, what of it is.
TEST_F(MovingSolidTest, CoversOfAFaceWhatItDoesAndAsLongAsItDoes)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    const vector step(0.03e-3, 0, 0);
    int across = 0;
    int along = 0;
    for (Foam::label face = 0; face < mesh().nInternalFaces(); ++face)
    {
        const vector normal = cmptMag(mesh().Sf()[face])/mesh().magSf()[face];
        const vector span = Foam::boundBox(mesh().points(), mesh().faces()[face], false).span();
        const auto covered = [&](double ahead)
        {
            const vector start = mesh().Cf()[face] - vector(0.5*side + ahead, 0, 0);
            return solid.coverOfFace(posed(start), posed(start + step), face);
        };
        if (normal.x() > 0.999999)
        {
            ++across;
            for (const double share : {0.05, 0.3, 0.7, 0.95})
            {
                ASSERT_NEAR(covered((1 - share)*step.x()), share, 1e-2) << share;
            }
            ASSERT_EQ(covered(-0.1e-3), 1);
            ASSERT_NEAR(covered(0.3e-3), std::min(0.5 - 0.285e-3/std::sqrt(mesh().magSf()[face]), 0.0), 1e-2);
        }
        if (normal.z() > 0.999999)
        {
            ++along;
            for (const double share : {0.1, 0.4, 0.6, 0.9})
            {
                ASSERT_NEAR(covered((0.5 - share)*span.x() + 0.5*step.x()), share, 1e-2) << share;
            }
            ASSERT_EQ(covered(-0.6*span.x()), 1);
        }
        if (normal.x() > 0.999999 || normal.z() > 0.999999)
        {
            ASSERT_EQ(covered(2e-3), -0.5);
        }
    }
    EXPECT_GT(Foam::returnReduce(across, Foam::sumOp<int>()), 20);
    EXPECT_GT(Foam::returnReduce(along, Foam::sumOp<int>()), 20);
}

// What covers more of a cell in a step has come through its faces, whatever the cell's shape: in front of a flat
// side, of all cells with six faces along the axes.
TEST_F(MovingSolidTest, CoversOfACellWhatComesThroughItsFaces)
{
    const MovingSolid solid = make(boxFile("cube", cube));
    const vector step(0.03e-3, 0, 0);
    int cut = 0;
    for (int n = 0; n < 20; ++n)
    {
        const RigidPose before = posed(middle() + n*step);
        const RigidPose now = posed(middle() + (n + 1)*step);
        cover(solid, before);
        const Foam::scalarField had(covered_.primitiveField());
        cover(solid, now);
        forAll(covered_, cell)
        {
            const vector away = mesh().C()[cell] - middle();
            const Foam::cell& faces = mesh().cells()[cell];
            scalar came = 0;
            bool along = faces.size() == 6 && Foam::mag(away.y()) < 0.3*side && Foam::mag(away.z()) < 0.3*side;
            for (const Foam::label face : faces)
            {
                const vector outwards = mesh().faceOwner()[face] == cell ? mesh().faceAreas()[face]
                                                                         : -mesh().faceAreas()[face];
                along = along && cmptMax(cmptMag(outwards)) > 0.999999*Foam::mag(outwards);
                came -= Foam::max(solid.coverOfFace(before, now, face), scalar(0))*(outwards & step);
            }
            if (along && had[cell] < 1)
            {
                cut += covered_[cell] > had[cell];
                ASSERT_NEAR((covered_[cell] - had[cell])*mesh().V()[cell], came, 1e-3*mesh().V()[cell]);
            }
        }
    }
    EXPECT_GT(Foam::returnReduce(cut, Foam::sumOp<int>()), 20);
}

TEST_F(MovingSolidTest, RefusesAMissingFile)
{
    const std::string text = refusal("nowhere/shoe.stl");

    EXPECT_NE(text.find("nowhere/shoe.stl"), std::string::npos) << text;
    EXPECT_NE(text.find("constant/couplingProperties, solids, shoe"), std::string::npos) << text;
}

TEST_F(MovingSolidTest, RefusesAnOpenSurface)
{
    const std::string path = boxFile("open", cube, 10);
    const std::string text = refusal(path);

    EXPECT_NE(text.find(path), std::string::npos) << text;
    EXPECT_NE(text.find("closed"), std::string::npos) << text;
}

// 0.6 mm in y, where two cells of the mesh are 0.93 mm by their volume.
TEST_F(MovingSolidTest, RefusesABodyThinnerThanTwoCells)
{
    const std::string path = boxFile("thin", vector(5e-3, 0.6e-3, 5e-3));
    const std::string text = refusal(path);

    EXPECT_NE(text.find(path), std::string::npos) << text;
    EXPECT_NE(text.find("m thick"), std::string::npos) << text;
    EXPECT_NE(text.find("two cells"), std::string::npos) << text;
}

TEST_F(MovingSolidTest, TakesABodyOfTwoCells)
{
    EXPECT_EQ(refusal(boxFile("twoCells", vector(5e-3, 0.95e-3, 5e-3))), "");
}

} // namespace
} // namespace interstice
