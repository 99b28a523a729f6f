// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interstice
{

/// Somebody wants the run to end: SIGTERM, SIGINT, or SIGUSR1 (which mpirun passes on without ending the
/// ranks itself; batch systems can send it before the time is up).
class StopRequest
{
public:
    /// From now on these signals no longer end the program.
    StopRequest();

    /// Whether any rank got one. Collective.
    bool came();

    /// Name of the signal; empty before it came. Same on all ranks.
    std::string name() const;

    /// What a shell expects of a program that a signal ended: 128 + its number.
    int exitCode() const { return 128 + signal_; }

private:
    int signal_ = 0;
};

} // namespace interstice
