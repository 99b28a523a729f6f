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
    using Run = int (*)(Foam::argList& args);

    /// Calls run, returns its exit code, and turns errors into messages and exit codes: an InputError
    /// is printed once, on the first rank that has it, and ends all ranks with code 1. Starts MPI,
    /// which OpenFOAM does for parallel runs only and LIGGGHTS always needs.
    static int guard(Run run, int argc, char* argv[]);

    /// Reads system/controlDict and the mesh.
    explicit Session(Foam::argList& args);

    Foam::Time& time() { return *time_; }
    Foam::fvMesh& mesh() { return *mesh_; }

private:
    std::unique_ptr<Foam::Time> time_;
    std::unique_ptr<Foam::fvMesh> mesh_;
};

} // namespace interstice
