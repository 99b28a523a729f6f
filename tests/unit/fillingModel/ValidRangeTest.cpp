// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingTables.hpp"

using namespace interstice;
using namespace interstice::test;

namespace
{

ValidRange range()
{
    return rangeOf(
        {studyDie(20e-6, 3360, 0.1), studyDie(60e-6, 11360, 0.2), studyDie(40e-6, 7360, 0.15)});
}

} // namespace

TEST(ValidRange, HoldsItsOwnCorners)
{
    EXPECT_TRUE(outsideRange(range(), studyDie(20e-6, 11360, 0.1), SizeIs::given).empty());
    EXPECT_TRUE(outsideRange(range(), studyDie(60e-6, 3360, 0.2), SizeIs::given).empty());
}

// N_v is 547.67 v: 54.767 to 109.534, and 136.917 at 0.25 m/s is half the width above.
TEST(ValidRange, SaysHowFarOutsideInUnitsAndInPartsOfTheWidth)
{
    const std::vector<std::string> fast =
        outsideRange(range(), studyDie(40e-6, 7360, 0.25), SizeIs::given);
    ASSERT_EQ(fast.size(), 1u);
    EXPECT_EQ(fast[0], "N_v 136.917, fitted for 54.767 to 109.534: 27.4 above, 50 % of the width");
}

TEST(ValidRange, SaysItBelowAsWell)
{
    const std::vector<std::string> light =
        outsideRange(range(), studyDie(40e-6, 3360 - 800, 0.15), SizeIs::given);
    ASSERT_EQ(light.size(), 1u);
    EXPECT_EQ(light[0],
        "rho_p/rho_g 2089.8, fitted for 2742.86 to 9273.47: 653 below, 10 % of the width");
}

// The groups of a longer die at a slower speed are inside; the die is not the one of the runs.
TEST(ValidRange, HoldsTheDieToItsLengthsBesideTheGroups)
{
    DieFilling longer = studyDie(40e-6, 7360, 0.1);
    longer.dieLength = 12e-3;
    const std::vector<std::string> lines = outsideRange(range(), longer, SizeIs::given);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0], "L_D 0.012 m, fitted for 0.008 m only: 0.004 m above");
}

TEST(ValidRange, DoesNotJudgeTheSizeWhereThatIsTheAnswer)
{
    EXPECT_EQ(outsideRange(range(), studyDie(90e-6, 7360, 0.15), SizeIs::given).size(), 1u);
    EXPECT_TRUE(outsideRange(range(), studyDie(90e-6, 7360, 0.15), SizeIs::answer).empty());
}

TEST(ValidRange, RefusesWithAllLinesAndTheWayOut)
{
    expectSays(extrapolationRefused({"N_v 3", "h_D 4"}, "model.json").what(),
        {"extrapolate", "N_v 3", "h_D 4", "model.json", "--extrapolate"});
}
