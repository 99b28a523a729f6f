// SPDX-License-Identifier: GPL-3.0-or-later
#include "Session.hpp"

#include "coupling/Interstice.hpp"

#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "error.H"
#include "sigFpe.H"
#include "solverPerformance.H"

#include <mpi.h>

#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

namespace interstice
{

using namespace Foam;

namespace
{

// Do all ranks stand here within a few seconds?
bool allRanksHere()
{
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (int tick = 0; tick < 300; ++tick)
    {
        int done = 0;
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done)
        {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// An error that all ranks have is told once and ends them in good order; one that this rank alone
// has must end the others where they wait.
[[noreturn]] void stop(const std::string& message)
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const bool together = allRanksHere();
    if (rank == 0 || !together)
    {
        std::cout.flush();
        std::cerr << "\nERROR: " << message << "\n" << std::endl;
    }
    if (!together)
    {
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    MPI_Finalize();
    std::_Exit(1);
}

// OpenFOAM's own message, in the shape of ours.
std::string told(const Foam::error& error)
{
    return error.message() + "\n    where   OpenFOAM, in " + error.functionName();
}

std::string told(const Foam::IOerror& error)
{
    std::ostringstream text;
    text << error.message() << "\n    where   " << error.ioFileName();
    if (error.ioStartLineNumber() >= 0)
    {
        text << ", line " << error.ioStartLineNumber();
    }
    text << "\nCorrect the file.";
    return text.str();
}

// What a number on the command line or in system/controlDict can make of a run.
void requireDuration(const Time& time)
{
    const scalar start = time.startTime().value();
    const scalar end = time.endTime().value();
    if (!(end > start))
    {
        throw InputError({"A run must end after it starts.",
            "endTime " + name(end) + " s", "more than the start, " + name(start) + " s",
            "system/controlDict, key endTime", "Correct endTime, startTime or startFrom."});
    }
    if (!(time.deltaTValue() > 0))
    {
        throw InputError({"The time step must be positive.",
            "deltaT " + name(time.deltaTValue()) + " s", "more than zero",
            "system/controlDict, key deltaT", "Correct the value."});
    }
}

void requireMesh(const Time& time)
{
    const word place = time.findInstance("polyMesh", "points", IOobject::READ_IF_PRESENT);
    const fileName points = time.path()/place/"polyMesh"/"points";
    if (!isFile(points))
    {
        throw InputError({"A case needs a mesh.", "no file " + points, "a mesh of OpenFOAM",
            "constant/polyMesh", "Run blockMesh, and decomposePar for a run on several ranks."});
    }
}

// A start time that was named must be there, and whole.
void requireStart(const Time& time, const wordList& incomplete)
{
    for (const word& name : incomplete)
    {
        Info<< "The time folder " << name << " was not written to its end; it is now " << name
            << ".incomplete." << endl;
    }
    const bool there = isDir(time.timePath());
    if (!returnReduce(there, andOp<bool>()))
    {
        std::string wanted = "one of";
        for (const instant& t : time.times())
        {
            wanted += t.name() == time.constant() ? "" : ' ' + t.name();
        }
        throw InputError({"A run starts from the folder of a time.",
            "no folder " + time.timeName() + (incomplete.found(time.timeName()) ? " that is whole" : ""),
            wanted, "system/controlDict, key startTime",
            "Name another time, or set startFrom latestTime."});
    }
}

} // namespace

int Session::guard(Run run, int argc, char* argv[])
{
    // OpenFOAM's argList ends the process when it is destroyed: never while an error is on its way.
    auto* args = new argList(argc, argv);
    // A value that is no number is found by our own checks, which name the cell or the particle.
    sigFpe::unset();
    // One line a step, not one a linear solve; DebugSwitches in controlDict can bring them back.
    SolverPerformance<scalar>::debug = 0;
    SolverPerformance<vector>::debug = 0;
    if (!args->checkRootCase())
    {
        FatalError.exit();
    }
    int started = 0;
    MPI_Initialized(&started);
    const bool ownsMpi = !started;
    if (ownsMpi)
    {
        MPI_Init(nullptr, nullptr);
    }
    // OpenFOAM's errors, too, are told once, by one rank.
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    int exitCode = 0;
    try
    {
        exitCode = run(*args);
    }
    catch (const Foam::IOerror& error)
    {
        stop(told(error));
    }
    catch (const Foam::error& error)
    {
        stop(told(error));
    }
    catch (const InputError& error)
    {
        stop(error.what());
    }
    catch (const RunFailure& error)
    {
        stop(error.what());
    }
    catch (const std::exception& error)
    {
        stop(std::string("this should not have happened: ") + error.what());
    }
    if (exitCode)
    {
        std::cout.flush();
        MPI_Finalize();
        std::_Exit(exitCode); // argList would make it zero
    }
    if (ownsMpi)
    {
        MPI_Finalize();
    }
    delete args;
    return 0;
}

Session::Session(argList& args)
{
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks > 1 && !Pstream::parRun())
    {
        throw InputError({"A run on several ranks must be told to share the work.",
            std::to_string(ranks) + " ranks, no -parallel", "demPimpleFoam -parallel",
            "command line", "Run decomposePar, then mpirun -np N demPimpleFoam -parallel."});
    }
    const wordList incomplete = CoupledPowder::setAsideIncomplete(args.path());
    time_ = std::make_unique<Time>(Time::controlDictName, args);
    requireDuration(*time_);
    requireStart(*time_, incomplete);
    requireMesh(*time_);
    mesh_ = std::make_unique<fvMesh>(
        IOobject(fvMesh::defaultRegion, time_->timeName(), *time_, IOobject::MUST_READ));
}

} // namespace interstice
