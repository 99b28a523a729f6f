// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: drag alone moves the powder, -V grad(p) does not.
#include "solvers/demPimpleFoam/AirFlow.hpp"

#define stressGradient() stressGradient()*Foam::scalar(0)
#include "solvers/demPimpleFoam/demPimpleFoam.cpp"
