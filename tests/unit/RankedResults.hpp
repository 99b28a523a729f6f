// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

#include <iostream>

namespace interstice
{

/// Prints the rank with every failed check, and nothing else on ranks other than 0.
class RankedResults final : public testing::EmptyTestEventListener
{
public:
    /// Precondition: MPI is initialised.
    static void install()
    {
        testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
        int rank = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        if (rank != 0)
        {
            delete listeners.Release(listeners.default_result_printer());
        }
        listeners.Append(new RankedResults);
    }

    /// Runs all tests. Collective; the same result on all ranks: zero only if all ranks passed.
    static int run()
    {
        const int mine = RUN_ALL_TESTS();
        int worst = 0;
        MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        return worst;
    }

private:
    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed())
        {
            return;
        }
        int rank = 0;
        int size = 1;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        MPI_Comm_size(MPI_COMM_WORLD, &size);
        std::cerr << "failed on rank " << rank << " of " << size << ": "
                  << (result.file_name() ? result.file_name() : "unknown file") << ':'
                  << result.line_number() << '\n'
                  << result.message() << std::endl;
    }
};

} // namespace interstice
