// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <stdexcept>
#include <string>

namespace interstice
{

/// A run that cannot go on for a reason found while running, such as a value that is no number.
class RunFailure : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;

    /// Collective. If `here` holds on any rank, throws on all of them: what happened, and where, as
    /// the first rank that knows tells it.
    static void throwOnAllRanks(
        bool here, const std::string& what, const std::string& where, MPI_Comm communicator);
};

} // namespace interstice
