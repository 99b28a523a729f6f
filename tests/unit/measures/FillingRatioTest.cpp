// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/measures/MeasureTest.hpp"

#include "coupling/mesh/measures/FillingRatio.hpp"

#include <fstream>

namespace interstice
{
namespace
{

using Foam::vector;

/// A die of 8 x 8 x 5 mm whose mouth is z = 0, and its shoe.
const std::string die = "die { low (0 0 -0.005); high (0.008 0.008 0); } ";
const std::string shoe = "shoe { wall \"shoe\"; front -0.001; rear -0.013; } ";

class FillingRatioTest : public MeasureTest
{
protected:
    std::unique_ptr<FillingRatio> ratio(const std::string& keys)
    {
        return make<FillingRatio>(keys);
    }

    double massInDie(Spheres& spheres)
    {
        spheres.show(powder);
        const auto measured = ratio(die + "fullMass 1;");
        measured->execute();
        return measured->values()[1];
    }
};

// V_cap = pi h^2 (3 r - h)/3: none, 5/32, one half, 27/32 and all of the sphere.
TEST(ShareBelow, IsTheVolumeOfASphericalCap)
{
    EXPECT_EQ(shareBelow(-3, 2), 0);
    EXPECT_NEAR(shareBelow(-1, 2), 5.0/32, 1e-15);
    EXPECT_NEAR(shareBelow(0, 2), 0.5, 1e-15);
    EXPECT_NEAR(shareBelow(1, 2), 27.0/32, 1e-15);
    EXPECT_EQ(shareBelow(3, 2), 1);
}

// 16 x 16 x 10 spheres in cells of 0.5 mm, and one layer more on the table beside the die.
TEST_F(FillingRatioTest, IsTheMassOfALatticeOverTheFullMass)
{
    Spheres spheres;
    for (int n = 0; n < 16*16*10; ++n)
    {
        spheres.add(5e-4*vector(n % 16 + 0.5, n/16 % 16 + 0.5, n/256 - 9.5), 2e-4);
    }
    for (int n = 0; n < 16*4; ++n)
    {
        spheres.add(5e-4*vector(n % 16 + 0.5, n/16 + 16.5, -0.2), 2e-4);
    }
    spheres.show(powder);
    const double full = 2*2560*Spheres::massOf(2e-4);

    const auto measured = ratio(die + "fullMass " + std::to_string(1e6*full) + "e-6;");
    measured->execute();

    EXPECT_NEAR(measured->values()[0], 0.5, 1e-6);
    EXPECT_NEAR(measured->values()[1], 0.5*full, 1e-12*full);
    EXPECT_EQ(measured->values()[2], 2560);
    EXPECT_EQ(powder.notes["filling"], "50.0 %");
}

// The centre stands half a radius above and below the mouth: caps of 5/32 and 27/32.
TEST_F(FillingRatioTest, CutsWhatSticksOutOfTheMouthExactly)
{
    Spheres high;
    high.add(vector(0.004, 0.004, 1e-4), 2e-4);
    EXPECT_NEAR(massInDie(high)/Spheres::massOf(2e-4), 5.0/32, 1e-12);

    Spheres low;
    low.add(vector(0.004, 0.004, -1e-4), 2e-4);
    EXPECT_NEAR(massInDie(low)/Spheres::massOf(2e-4), 27.0/32, 1e-12);
}

// At the walls the centre decides.
TEST_F(FillingRatioTest, LeavesOutWhatLiesBesideTheMouth)
{
    Spheres spheres;
    spheres.add(vector(-1e-5, 0.004, -1e-4), 2e-4);
    spheres.add(vector(0.008, 0.004, 0), 2e-4);
    spheres.add(vector(0.004, 0.004, -0.0051), 2e-4);
    EXPECT_EQ(massInDie(spheres), 0);

    Spheres within;
    within.add(vector(1e-5, 0.004, -0.002), 2e-4);
    EXPECT_NEAR(massInDie(within), Spheres::massOf(2e-4), 1e-15);
}

/// A die with three corners, (0 0), (8 0) and (0 8) mm, of 5 mm depth, as an OBJ file.
void writePrism(const std::string& path)
{
    std::ofstream(path) << "v 0 0 -0.005\nv 0.008 0 -0.005\nv 0 0.008 -0.005\n"
                           "v 0 0 0\nv 0.008 0 0\nv 0 0.008 0\n"
                           "f 1 3 2\nf 4 5 6\nf 1 2 5\nf 1 5 4\n"
                           "f 2 3 6\nf 2 6 5\nf 3 1 4\nf 3 4 6\n";
}

// A lattice that reaches out of the die on all sides; the mouth cuts its layer at -0.15 mm.
TEST_F(FillingRatioTest, CountsWhatIsInsideASurface)
{
    if (Foam::Pstream::master())
    {
        writePrism(foamTime().globalPath() + "/die.obj");
    }
    MPI_Barrier(MPI_COMM_WORLD);
    Spheres spheres;
    double inside = 0;
    for (int n = 0; n < 20*20*13; ++n)
    {
        const vector p = 5e-4*vector(n % 20 - 1.9, n/20 % 20 - 1.7, n/400 - 11.3);
        spheres.add(p, 2e-4);
        if (p.x() > 0 && p.y() > 0 && p.x() + p.y() < 0.008 && p.z() > -0.005)
        {
            inside += shareBelow(-p.z(), 2e-4)*Spheres::massOf(2e-4);
        }
    }
    spheres.show(powder);

    const auto measured = ratio("die { surface \"die.obj\"; } fullMass 1;");
    measured->execute();
    EXPECT_GT(inside, 1000*Spheres::massOf(2e-4));
    EXPECT_NEAR(measured->values()[1]/inside, 1, 1e-12);
}

// Front wall from -1 mm to the far edge at 8 mm: 9 mm. Rear wall from -13 mm to the near edge: 13.
TEST_F(FillingRatioTest, NamesItsValueWhenTheShoesWallsPass)
{
    Spheres spheres;
    const double one = Spheres::massOf(2e-4);
    const auto measured =
        ratio(die + shoe + "fullMass " + std::to_string(1e9*10*one) + "e-9;");
    double front = -1;
    double rear = -1;
    for (int step = 0; step <= 30; ++step)
    {
        powder.wallTravel["shoe"] = vector(0.5e-3*step + 1e-9, 0, 0);
        spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
        spheres.show(powder);
        measured->execute();
        EXPECT_EQ(measured->reached("frontCrossed", front), step >= 18) << step;
        EXPECT_EQ(measured->reached("rearArrives", rear), step >= 26) << step;
    }
    measured->end();
    double end = -1;
    EXPECT_TRUE(measured->reached("end", end));
    EXPECT_NEAR(front, 1.9, 1e-6);
    EXPECT_NEAR(rear, 2.7, 1e-6);
    EXPECT_NEAR(end, 3.1, 1e-6);
}

TEST_F(FillingRatioTest, WritesATableWhoseHeadNamesTheUnits)
{
    Spheres spheres;
    spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
    spheres.show(powder);
    const std::string folder = foamTime().globalPath() + "/postProcessing";
    if (Foam::Pstream::master() && Foam::isDir(folder))
    {
        Foam::rmDir(folder);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    {
        FillingRatio written("fill", foamTime(),
            dictionary(die + "fullMass " + std::to_string(4e9*Spheres::massOf(2e-4)) + "e-9;"));
        written.execute();
        written.write();
        written.end();
    }
    if (!Foam::Pstream::master())
    {
        return;
    }
    std::ifstream table(folder + "/fill/0/fill.dat");
    std::string head;
    std::getline(table, head);
    EXPECT_EQ(head,
        "# time [s]\tfillingRatio [-]\tmassInDie [kg]\tparticlesInDie [-]\tshoeTravel [m]");
    double time = -1;
    double value = -1;
    table >> time >> value;
    EXPECT_EQ(time, 0);
    EXPECT_NEAR(value, 0.25, 1e-6);

    std::ifstream moments(folder + "/fill/0/moments.dat");
    std::getline(moments, head);
    EXPECT_EQ(head, "# time [s]\tmoment\tfillingRatio [-]");
    std::string moment;
    moments >> time >> moment >> value;
    EXPECT_EQ(moment, "end");
    EXPECT_NEAR(value, 0.25, 1e-6);
}

TEST_F(FillingRatioTest, SaysWhatIsWrongInItsDictionary)
{
    EXPECT_EQ(problemOf([&] { ratio(die); }).found, "no key fullMass");
    EXPECT_NE(problemOf([&] { ratio(die + "fulMass 1; fullMass 1;"); }).remedy.find("fullMass"),
        std::string::npos);
    EXPECT_NE(problemOf([&] { ratio("die { low (0 0 1); high (1 1 1); } fullMass 1;"); })
                  .where.find("high"),
        std::string::npos);
    EXPECT_NE(problemOf([&] { ratio("die { surface \"no.stl\"; } fullMass 1;"); })
                  .found.find("no.stl"),
        std::string::npos);

    EXPECT_NE(problemOf([&] { ratio(die + "fullMass 1; shoe { front -1; rear 0; }"); })
                  .where.find("front"),
        std::string::npos);

    const auto measured = ratio(die + "fullMass 1; shoe { wall \"sho\"; front 0; rear -1; }");
    powder.wallTravel["shoe"] = vector::zero;
    EXPECT_NE(problemOf([&] { measured->execute(); }).remedy.find("shoe"), std::string::npos);
}

TEST_F(FillingRatioTest, ReadsTheFullMassFromAFile)
{
    if (Foam::Pstream::master())
    {
        std::ofstream(foamTime().globalPath() + "/fullDie") << "fullMass 2e-3;\n";
    }
    MPI_Barrier(MPI_COMM_WORLD);
    Spheres spheres;
    spheres.add(vector(0.004, 0.004, -0.002), 2e-4);
    spheres.show(powder);
    const auto measured = ratio(die + "fullMassFile \"fullDie\";");
    measured->execute();
    EXPECT_NEAR(measured->values()[0], Spheres::massOf(2e-4)/2e-3, 1e-12);
}

} // namespace
} // namespace interstice
