// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The library's front: all that a solver includes.
///
///     CoupledPowder   the powder, from LIGGGHTS to fields on the mesh and back
///     bedFaces        momentum of the air across the faces of a bed
///     Parameters      a dictionary whose keys are checked as they are read
///     StageClock      where the time goes
///     InputError      what a user can cause and remedy; RunFailure: what shows only while running

#include "coupling/CoupledPowder.hpp"
#include "coupling/RunFailure.hpp"
#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/BedFaces.hpp"
#include "coupling/mesh/Parameters.hpp"
#include "coupling/report/StageClock.hpp"
