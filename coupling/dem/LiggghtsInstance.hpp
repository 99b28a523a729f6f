// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"
#include "coupling/dem/ScreenStream.hpp"

namespace LAMMPS_NS
{
class LAMMPS;
class Fix;
} // namespace LAMMPS_NS

namespace interstice::dem
{

/// A running LIGGGHTS: its communicator, its output, and its way of running.
class LiggghtsInstance
{
public:
    /// Collective.
    LiggghtsInstance(MPI_Comm communicator, const DemOptions& options);
    ~LiggghtsInstance();

    LiggghtsInstance(const LiggghtsInstance&) = delete;
    LiggghtsInstance& operator=(const LiggghtsInstance&) = delete;

    LAMMPS_NS::LAMMPS& lammps() const
    {
        return *lammps_;
    }

    MPI_Comm communicator() const
    {
        return communicator_;
    }

    ScreenStream& screen() const
    {
        return *screen_;
    }

    /// Throws InputError unless rank 0 can read the file. Collective.
    void requireFile(const std::string& path, const std::string& kind) const;

    void runScript(const std::string& path);
    void command(const std::string& text);

    /// Prepares one endless run, as LIGGGHTS' `run` does before its first step: neighbour
    /// lists, forces, output. LIGGGHTS' clock goes on from the run before. Collective.
    void setUp();

    /// LIGGGHTS' clock, which its variables know as `time` [s]. Local.
    double time() const;

    /// Sets the clock and the step [s] of a run that is resumed. Local, before setUp().
    void setClock(double time, double timeStep);

    /// Goes on with that run. Collective. Not `run N pre no`: that would end the run, with a
    /// line of the thermo table, two reductions and a page of log in every coupling interval.
    void goOn(long steps);

private:
    void open(const DemOptions& options);
    void announceRun();

    MPI_Comm communicator_ = MPI_COMM_NULL;
    std::unique_ptr<ScreenStream> screen_;
    LAMMPS_NS::LAMMPS* lammps_ = nullptr;
    long long firstStep_ = 0;
    bool running_ = false; ///< the endless run has begun
};

} // namespace interstice::dem
