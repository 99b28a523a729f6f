// SPDX-License-Identifier: GPL-3.0-or-later
// main() of tests that need OpenFOAM, on any number of ranks.
#include "tests/unit/FoamTest.hpp"

#include "tests/unit/RankedResults.hpp"

#include "Time.H"
#include "argList.H"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace
{

std::unique_ptr<Foam::Time> clockOfCase;

bool holds(int argc, char** argv, const std::string& option)
{
    return std::find(argv, argv + argc, option) != argv + argc;
}

} // namespace

Foam::Time& interstice::foamTime()
{
    if (!clockOfCase)
    {
        throw std::logic_error("This test was started without a case: see interstice_test(CASE).");
    }
    return *clockOfCase;
}

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    if (!holds(argc, argv, "-parallel"))
    {
        // OpenFOAM starts MPI in parallel runs only; the code under test always needs it.
        MPI_Init(&argc, &argv);
    }
    const bool hasCase = holds(argc, argv, "-case");

    Foam::argList::noBanner();
    Foam::argList arguments(argc, argv, false, false);
    if (hasCase)
    {
        clockOfCase = std::make_unique<Foam::Time>(Foam::Time::controlDictName, arguments);
    }
    // A failure must end in a test's verdict, not in the end of the program.
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    interstice::RankedResults::install();

    const int result = interstice::RankedResults::run();

    clockOfCase.reset();
    // argList's destructor would end the program with zero, whatever the result: so leave before.
    MPI_Finalize();
    std::exit(result);
}
