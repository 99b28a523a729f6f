// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The library's front for programs without a flow: needs neither OpenFOAM nor MPI.

#include "coupling/laws/DimensionlessGroups.hpp"
#include "coupling/laws/InputError.hpp"
