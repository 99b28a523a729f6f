// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/exchange/Bounds.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace interstice
{
namespace
{

TEST(Bounds, HoldNothingUntilAPointIsAdded)
{
    Bounds box;
    EXPECT_FALSE(box.contains({0, 0, 0}));

    box.add({1, 2, 3});
    EXPECT_TRUE(box.contains({1, 2, 3}));
    EXPECT_FALSE(box.contains({1, 2, 3.1}));

    box.grow(0.2);
    EXPECT_TRUE(box.contains({1, 2, 3.1}));
}

TEST(Bounds, StayEmptyWhenGrownWithoutAPoint)
{
    Bounds box;
    box.grow(1);

    EXPECT_FALSE(box.contains({0, 0, 0}));
}

// A particle whose position is no number is in no cell, so that it is reported as outside.
TEST(Bounds, DoNotHoldAPointThatIsNotANumber)
{
    Bounds box;
    box.add({0, 0, 0});
    box.add({1, 1, 1});

    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(box.contains({0.5, nan, 0.5}));
}

} // namespace
} // namespace interstice
