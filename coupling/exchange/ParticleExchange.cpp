// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/exchange/ParticleExchange.hpp"

#include <algorithm>
#include <numeric>

namespace interstice
{

namespace
{

/// Better quality first; the candidates of one particle are visited in ascending rank.
bool better(const Location& challenger, const Location& holder)
{
    return static_cast<int>(challenger.quality) > static_cast<int>(holder.quality);
}

} // namespace

ParticleExchange::ParticleExchange(MPI_Comm communicator, const Bounds& cells)
{
    MPI_Comm_dup(communicator, &communicator_);
    int ranks = 1;
    MPI_Comm_rank(communicator_, &rank_);
    MPI_Comm_size(communicator_, &ranks);

    bounds_.resize(ranks);
    MPI_Allgather(&cells, sizeof(Bounds), MPI_BYTE, bounds_.data(), sizeof(Bounds), MPI_BYTE,
        communicator_);
    toOthers_ = fromOthers_ = batchOf(std::vector<int>(ranks, 0));
}

ParticleExchange::~ParticleExchange()
{
    MPI_Comm_free(&communicator_);
}

void ParticleExchange::plan(const std::vector<SearchPoint>& own, const Locate& locate)
{
    cells_.clear();
    residents_.clear();
    emigrants_.clear();
    outside_.clear();
    ++traffic_.plans;

    std::vector<Location> here(own.size());
    std::vector<int> strangers;
    for (std::size_t slot = 0; slot < own.size(); ++slot)
    {
        here[slot] = locate(own[slot]);
        if (here[slot].quality != Location::Quality::exact)
        {
            strangers.push_back(static_cast<int>(slot));
        }
    }

    int travel = !strangers.empty() && size() > 1;
    MPI_Allreduce(MPI_IN_PLACE, &travel, 1, MPI_INT, MPI_MAX, communicator_);
    anyTravel_ = travel;

    std::vector<int> guestCells;
    if (anyTravel_)
    {
        askOthers(own, here, strangers, locate);
        guestCells.swap(cells_);
    }

    std::vector<char> leaves(own.size(), 0);
    for (const int slot : emigrants_)
    {
        leaves[slot] = 1;
    }
    for (std::size_t slot = 0; slot < own.size(); ++slot)
    {
        if (leaves[slot])
        {
            continue;
        }
        if (here[slot].quality == Location::Quality::notHere)
        {
            outside_.push_back(static_cast<int>(slot));
        }
        else
        {
            residents_.push_back(static_cast<int>(slot));
            cells_.push_back(here[slot].cell);
        }
    }
    cells_.insert(cells_.end(), guestCells.begin(), guestCells.end());
}

// Three short rounds: positions to the ranks whose box holds them, what these see back, and the
// verdict. Leaves the guests' cells in cells_, and who goes where in emigrants_ and the batches.
void ParticleExchange::askOthers(const std::vector<SearchPoint>& own,
    const std::vector<Location>& here, const std::vector<int>& strangers, const Locate& locate)
{
    std::vector<std::vector<int>> candidates(size());
    for (const int slot : strangers)
    {
        for (int rank = 0; rank < size(); ++rank)
        {
            const bool mayHold = bounds_[rank].contains(own[slot].position)
                || bounds_[rank].contains(own[slot].fallback);
            if (rank != rank_ && mayHold)
            {
                candidates[rank].push_back(slot);
            }
        }
    }

    std::vector<int> counts(size());
    std::vector<int> askedSlots;
    std::vector<SearchPoint> questions;
    for (int rank = 0; rank < size(); ++rank)
    {
        counts[rank] = static_cast<int>(candidates[rank].size());
        for (const int slot : candidates[rank])
        {
            askedSlots.push_back(slot);
            questions.push_back(own[slot]);
        }
    }
    const Batch asked = batchOf(counts);
    const Batch heard = mirrored(counts);

    std::vector<SearchPoint> points(heard.count());
    transfer(questions.data(), asked, points.data(), heard, sizeof(SearchPoint));
    std::vector<Location> seen(points.size());
    std::transform(points.begin(), points.end(), seen.begin(), locate);
    std::vector<Location> answers(askedSlots.size());
    transfer(seen.data(), heard, answers.data(), asked, sizeof(Location));

    std::vector<Location> best(here);
    std::vector<int> winner(own.size(), -1); // index into askedSlots; -1: stays at home
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
        if (better(answers[i], best[askedSlots[i]]))
        {
            best[askedSlots[i]] = answers[i];
            winner[askedSlots[i]] = static_cast<int>(i);
        }
    }

    std::vector<char> won(askedSlots.size(), 0);
    std::vector<int> leaving(size(), 0);
    for (int rank = 0; rank < size(); ++rank)
    {
        for (int i = asked.offsets[rank]; i < asked.offsets[rank + 1]; ++i)
        {
            if (winner[askedSlots[i]] == i)
            {
                won[i] = 1;
                ++leaving[rank];
                emigrants_.push_back(askedSlots[i]);
            }
        }
    }
    std::vector<char> staying(points.size());
    transfer(won.data(), asked, staying.data(), heard, 1);

    std::vector<int> arriving(size(), 0);
    for (int rank = 0; rank < size(); ++rank)
    {
        for (int i = heard.offsets[rank]; i < heard.offsets[rank + 1]; ++i)
        {
            if (staying[i])
            {
                ++arriving[rank];
                cells_.push_back(seen[i].cell);
            }
        }
    }
    toOthers_ = batchOf(leaving);
    fromOthers_ = batchOf(arriving);
}

ParticleExchange::Batch ParticleExchange::batchOf(const std::vector<int>& counts) const
{
    Batch batch{std::vector<int>(counts.size() + 1, 0)};
    std::partial_sum(counts.begin(), counts.end(), batch.offsets.begin() + 1);
    return batch;
}

ParticleExchange::Batch ParticleExchange::mirrored(const std::vector<int>& counts) const
{
    std::vector<int> theirs(counts.size());
    MPI_Alltoall(counts.data(), 1, MPI_INT, theirs.data(), 1, MPI_INT, communicator_);
    return batchOf(theirs);
}

void ParticleExchange::transfer(const void* send, const Batch& sent, void* receive,
    const Batch& received, std::size_t itemBytes) const
{
    constexpr int tag = 1;
    const auto* from = static_cast<const char*>(send);
    auto* to = static_cast<char*>(receive);
    std::vector<MPI_Request> requests;

    const auto bytes = [itemBytes](const Batch& batch, int rank)
    { return static_cast<int>(itemBytes*(batch.offsets[rank + 1] - batch.offsets[rank])); };

    for (int rank = 0; rank < size(); ++rank)
    {
        if (const int length = bytes(received, rank))
        {
            MPI_Irecv(to + itemBytes*received.offsets[rank], length, MPI_BYTE, rank, tag,
                communicator_, &requests.emplace_back());
        }
    }
    for (int rank = 0; rank < size(); ++rank)
    {
        if (const int length = bytes(sent, rank))
        {
            MPI_Isend(from + itemBytes*sent.offsets[rank], length, MPI_BYTE, rank, tag,
                communicator_, &requests.emplace_back());
            traffic_.bytes += length;
            ++traffic_.messages;
        }
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

} // namespace interstice
