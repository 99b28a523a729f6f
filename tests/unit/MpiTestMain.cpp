// SPDX-License-Identifier: GPL-3.0-or-later
// main() of tests that need MPI and nothing else.
#include "tests/unit/RankedResults.hpp"

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    MPI_Init(&argc, &argv);
    interstice::RankedResults::install();

    const int result = interstice::RankedResults::run();

    MPI_Finalize();
    return result;
}
