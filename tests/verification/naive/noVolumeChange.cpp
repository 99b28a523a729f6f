// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: the pressure equation without d(alpha)/dt; air need not make way for powder.
#include "solvers/demPimpleFoam/AirFlow.hpp"

#define ddtAlpha_ (Foam::scalar(0)*ddtAlpha_)
#include "solvers/demPimpleFoam/pressureEquation.cpp"
