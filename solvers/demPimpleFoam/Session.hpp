// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "argList.H"
#include "fvMesh.H"

#include <memory>

namespace interstice
{

/// One run: MPI, the case, its clock and its mesh, from start to end.
class Session
{
public:
    using Run = int (*)(int argc, char* argv[]);

    /// Calls run and turns errors into messages and exit codes: an InputError is printed once, on
    /// the first rank that has it, and ends all ranks with code 1.
    static int guard(Run run, int argc, char* argv[]);

    /// Reads the command line, system/controlDict and the mesh.
    Session(int argc, char* argv[]);
    ~Session();

    Foam::Time& time() { return *time_; }
    Foam::fvMesh& mesh() { return *mesh_; }

private:
    std::unique_ptr<Foam::argList> args_;
    bool ownsMpi_ = false; // OpenFOAM starts MPI only for a parallel run
    std::unique_ptr<Foam::Time> time_;
    std::unique_ptr<Foam::fvMesh> mesh_;
};

} // namespace interstice
