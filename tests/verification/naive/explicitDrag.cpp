// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: air and grains feel, over a whole step, the drag of the slip or of the air at its start.
#include "coupling/laws/ImplicitDrag.hpp"
#include "coupling/mesh/PowderOnMesh.hpp"
#include "solvers/demPimpleFoam/AirFlow.hpp"

// The air counts on the whole drag, not on what grains that give way leave of it.
#define meanSlip(x) 1.0
#include "coupling/mesh/PowderOnMesh.cpp"

// The parentheses keep the name from being replaced once more.
#define dragCoefficient() dragCoefficient()*Foam::scalar(0)
#define dragSource() dragSource()/rho - (powder.dragCoefficient)()*U_.oldTime()
#include "solvers/demPimpleFoam/AirFlow.cpp"

#define U() U().oldTime()
#include "solvers/demPimpleFoam/demPimpleFoam.cpp"
