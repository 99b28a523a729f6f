// SPDX-License-Identifier: GPL-3.0-or-later
#include "Session.hpp"

#include "coupling/laws/InputError.hpp"

#include <mpi.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace interstice
{

using namespace Foam;

namespace
{

// Every rank that has the error comes here. The first one prints; the others give it time to, and
// speak only if it did not have the error.
[[noreturn]] void stop(const std::string& message)
{
    int started = 0;
    int rank = 0;
    MPI_Initialized(&started);
    if (started)
    {
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    }
    if (rank != 0)
    {
        std::this_thread::sleep_for(std::chrono::seconds(2));
    }
    std::cout.flush();
    std::cerr << "\nERROR: " << message << "\n\n" << std::flush;
    if (started)
    {
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    std::exit(1);
}

} // namespace

int Session::guard(Run run, int argc, char* argv[])
{
    try
    {
        return run(argc, argv);
    }
    catch (const InputError& error)
    {
        stop(error.what());
    }
    catch (const std::exception& error)
    {
        stop(std::string("this should not have happened: ") + error.what());
    }
}

Session::Session(int argc, char* argv[])
:
    args_(std::make_unique<argList>(argc, argv))
{
    if (!args_->checkRootCase())
    {
        FatalError.exit();
    }
    int started = 0;
    MPI_Initialized(&started);
    if (!started)
    {
        MPI_Init(nullptr, nullptr);
        ownsMpi_ = true;
    }
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks > 1 && !Pstream::parRun())
    {
        throw InputError({"A run on several ranks must be told to share the work.",
            std::to_string(ranks) + " ranks, no -parallel", "demPimpleFoam -parallel",
            "command line", "Run decomposePar, then mpirun -np N demPimpleFoam -parallel."});
    }
    time_ = std::make_unique<Time>(Time::controlDictName, *args_);
    mesh_ = std::make_unique<fvMesh>(
        IOobject(fvMesh::defaultRegion, time_->timeName(), *time_, IOobject::MUST_READ));
}

Session::~Session()
{
    mesh_.reset();
    time_.reset();
    if (ownsMpi_)
    {
        MPI_Finalize();
    }
}

} // namespace interstice
