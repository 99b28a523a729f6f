// SPDX-License-Identifier: GPL-3.0-or-later
// Lets LIGGGHTS end this program, in the way named by the first argument.
#include "DemScene.hpp"

#include <cfenv>
#include <cstdio>

int main(int argc, char** argv)
{
    using namespace interstice;

    MPI_Init(&argc, &argv);
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
