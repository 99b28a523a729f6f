// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/InputError.hpp"

#include <gtest/gtest.h>

using namespace interstice;

TEST(InputError, SaysRuleFindingWishPlaceAndRemedy)
{
    const InputError error(
        {"The fluid step is not a whole number of DEM steps.", "deltaT 2e-05 s,\ntimestep 3e-06 s",
            "a whole ratio", "system/controlDict, deltaT", "Set deltaT to 1.8e-05 or 2.1e-05."});

    EXPECT_STREQ(error.what(), "The fluid step is not a whole number of DEM steps.\n"
                               "    found   deltaT 2e-05 s,\n"
                               "            timestep 3e-06 s\n"
                               "    wanted  a whole ratio\n"
                               "    where   system/controlDict, deltaT\n"
                               "Set deltaT to 1.8e-05 or 2.1e-05.");
    EXPECT_EQ(error.problem().where, "system/controlDict, deltaT");
}

TEST(InputError, LeavesOutWhatIsNotGiven)
{
    EXPECT_STREQ(
        InputError({"The case has no powder.", "", "", "", ""}).what(), "The case has no powder.");
}

TEST(NearestName, ForgivesAMissingAWrongAndASwappedLetterAndTheCase)
{
    const std::vector<std::string> names{"DiFelice", "KochHill", "Stokes"};
    EXPECT_EQ(nearestName("DiFelce", names), "DiFelice");
    EXPECT_EQ(nearestName("KochHell", names), "KochHill");
    EXPECT_EQ(nearestName("Stoeks", names), "Stokes");
    EXPECT_EQ(nearestName("KOCHHILL", names), "KochHill");
}

// One swap is one edit: in a name of three letters that is the most that may differ.
TEST(NearestName, CountsASwapOfNeighboursOnce)
{
    EXPECT_EQ(nearestName("acb", {"abc"}), "abc");
    EXPECT_EQ(nearestName("cba", {"abc"}), "");
}

TEST(NearestName, TakesTheNearerOfTwo)
{
    EXPECT_EQ(nearestName("couplingStop", {"couplingStart", "couplingStep"}), "couplingStep");
}

TEST(NearestName, StaysSilentWhenNothingIsNear)
{
    EXPECT_EQ(nearestName("Stabcs", {"Stokes"}), "");
    EXPECT_EQ(nearestName("Ergun", {"DiFelice", "Stokes"}), "");
    EXPECT_EQ(nearestName("", {"DiFelice"}), "");
    EXPECT_EQ(nearestName("DiFelice", {}), "");
}

TEST(UnknownName, ListsTheValidNamesAndProposesTheNearest)
{
    EXPECT_STREQ(
        unknownName("drag law", "Stoke", {"DiFelice", "Stokes"}, "constant/drag, law").what(),
        "There is no drag law of this name.\n"
        "    found   Stoke\n"
        "    wanted  DiFelice\n"
        "            Stokes\n"
        "    where   constant/drag, law\n"
        "Did you mean Stokes?");
}

TEST(UnknownName, ProposesNothingWhenNothingIsNear)
{
    const std::string message = unknownName("drag law", "", {"Stokes"}, "").what();
    EXPECT_EQ(message.find("Did you mean"), std::string::npos) << message;
    EXPECT_NE(message.find("(nothing)"), std::string::npos) << message;
}
