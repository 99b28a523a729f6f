// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/RunFailure.hpp"

namespace interstice
{

void RunFailure::throwOnAllRanks(
    bool here, const std::string& what, const std::string& where, MPI_Comm communicator)
{
    int rank = 0;
    int ranks = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    int teller = here ? rank : ranks;
    MPI_Allreduce(MPI_IN_PLACE, &teller, 1, MPI_INT, MPI_MIN, communicator);
    if (teller == ranks)
    {
        return;
    }
    int length = static_cast<int>(where.size());
    MPI_Bcast(&length, 1, MPI_INT, teller, communicator);
    std::string place = where;
    place.resize(length);
    MPI_Bcast(place.data(), length, MPI_CHAR, teller, communicator);
    throw RunFailure(what + "\n    " + place);
}

} // namespace interstice
