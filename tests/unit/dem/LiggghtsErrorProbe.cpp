// SPDX-License-Identifier: GPL-3.0-or-later
// Lets LIGGGHTS end this program, in the way named by the first argument.
#include "DemScene.hpp"

#include <cfenv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace
{

int rank = 0;

void exitLate()
{
    if (rank == 0)
    {
        std::this_thread::sleep_for(std::chrono::seconds(2));
    }
}

} // namespace

int main(int argc, char** argv)
{
    using namespace interstice;

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string way = argc > 1 ? argv[1] : "";
    {
        DemEngine dem(MPI_COMM_WORLD, test::optionsFor());
        if (way == "unknown fix")
        {
            dem.runScript(test::script("wrong.in"));
        }
        dem.runScript(test::script("empty.in"));
        if (way == "one rank")
        {
            // In the last corner, so that the last rank alone finds the fault.
            dem.command("create_atoms 1 single 0.075 0.075 0.075 units box");
            dem.command("set group all diameter 0");
        }
        dem.couple();
        if (way == "quit")
        {
            // The last rank is gone before the first one exits, and mpirun ends the first one.
            std::atexit(exitLate);
            dem.command("quit");
        }
        if (way == "missing script")
        {
            dem.runScript("nowhere.in");
        }
        if (way == "traps")
        {
            feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
            dem.command("variable huge equal exp(1000)");
            dem.command("print ${huge}");
            dem.advance(10);
            const bool stillOn = fegetexcept() == (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
            std::fprintf(stderr, stillOn ? "traps still on\n" : "traps lost\n");
        }
    }
    MPI_Finalize();
    return 0;
}
