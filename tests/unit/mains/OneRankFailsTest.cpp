// SPDX-License-Identifier: GPL-3.0-or-later
// Registered with FAILS_WITH: a check that fails on one rank only must fail the whole test.
#include <gtest/gtest.h>
#include <mpi.h>

TEST(TestMain, EndsWithAnErrorIfOnlyTheLastRankFails)
{
    int rank = 0;
    int size = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);

    EXPECT_NE(rank, size - 1) << "this failure is wanted";
}
