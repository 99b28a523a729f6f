// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <malloc.h>

#include <memory>

namespace
{

constexpr int n = 12;

__attribute__((noinline)) double readByUs(const volatile double* place)
{
    return *place;
}

} // namespace

TEST(ArrayTail, OursMayNotReadBehindAnArray)
{
    const std::unique_ptr<double[]> array(new double[n]());
    EXPECT_DEATH(readByUs(array.get() + n), "use-after-poison");
}

TEST(ArrayTail, BehindAnArrayIsMemoryOfItsOwn)
{
    const std::unique_ptr<double[]> array(new double[n]());
    EXPECT_GE(malloc_usable_size(array.get()), (n + 1)*sizeof(double));
}
