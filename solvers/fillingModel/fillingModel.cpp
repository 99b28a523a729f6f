// SPDX-License-Identifier: GPL-3.0-or-later
//
// fillingModel: fits, checks, uses and inverts the filling model of linear die filling
//
//     (d_p/h_D)_crit = a + b v rho_g L_D/mu_g + c rho_p/rho_g
//
// from a table of runs, one row a variant. See the README beside, or --help.

#include "Commands.hpp"

#include <iostream>

int main(int argc, char* argv[])
{
    return interstice::fillingModelProgram({argv + 1, argv + argc}, std::cout, std::cerr);
}
