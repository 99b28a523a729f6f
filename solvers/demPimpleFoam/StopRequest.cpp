// SPDX-License-Identifier: GPL-3.0-or-later
#include "StopRequest.hpp"

#include <mpi.h>

#include <csignal>

namespace interstice
{

namespace
{

volatile std::sig_atomic_t received = 0;

void remember(int signal)
{
    received = signal;
}

} // namespace

StopRequest::StopRequest()
{
    for (const int signal : {SIGTERM, SIGINT, SIGUSR1})
    {
        std::signal(signal, remember);
    }
}

bool StopRequest::came()
{
    const int mine = received;
    MPI_Allreduce(&mine, &signal_, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return signal_ != 0;
}

std::string StopRequest::name() const
{
    switch (signal_)
    {
    case 0:
        return "";
    case SIGTERM:
        return "SIGTERM";
    case SIGINT:
        return "SIGINT";
    default:
        return "SIGUSR1";
    }
}

} // namespace interstice
