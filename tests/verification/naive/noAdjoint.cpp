// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: powder is smoothed on its way to the mesh; the air that it meets is not.
#include "coupling/mesh/PowderOnMesh.hpp"

#define smoothed(air) weights()
#include "coupling/mesh/PowderOnMesh.cpp"
