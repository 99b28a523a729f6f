// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/AirForce.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/dem/LiggghtsInstance.hpp"
#include "coupling/dem/MeshWalls.hpp"

#include <lammps.h>

#include <atom.h>

namespace interstice
{

/// What DemEngine holds; seen by its own sources only.
struct DemEngine::Implementation
{
    Implementation(MPI_Comm communicator, const DemOptions& options)
        : liggghts(communicator, options), walls(liggghts.lammps(), liggghts.communicator())
    {
    }

    bool coupled() const
    {
        return air != nullptr;
    }

    /// After whatever may have changed the run. A set-up of LIGGGHTS ends by forgetting that walls
    /// move: until the next step they would stand still for the powder and the air.
    void setUp()
    {
        air->actLast();
        const std::map<std::string, WallPose> motion = walls.poses();
        walls.setVelocities(motion);
        liggghts.setUp();
        walls.setVelocities(motion);
        walls.record();
        upToDate = true;
    }

    /// The same where forces are what they were: the path then goes on as without it.
    void setUpAgain()
    {
        air->keepForces();
        setUp();
        air->restoreForces();
    }

    LAMMPS_NS::Atom& atom() const
    {
        return *liggghts.lammps().atom;
    }

    double reduced(double mine, MPI_Op operation) const
    {
        double all = 0;
        MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, operation, liggghts.communicator());
        return all;
    }

    dem::LiggghtsInstance liggghts;
    dem::MeshWalls walls;
    std::unique_ptr<dem::AirForce> air;
    LAMMPS_NS::FixPropertyAtom* memory = nullptr; ///< only if it is used
    std::string script; ///< the last one that ran
    bool upToDate = false; ///< no command has come since the last set-up
};

} // namespace interstice
