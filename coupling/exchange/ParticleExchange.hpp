// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/exchange/Bounds.hpp"

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace interstice
{

/// Where a rank's mesh sees a particle.
struct Location
{
    enum class Quality : int
    {
        notHere, ///< neither the position nor the fallback lies in this rank's cells
        fallback, ///< only the fallback position does
        exact ///< the position itself does
    };

    Quality quality = Quality::notHere;
    int cell = 0; ///< meaningless when notHere
};

/// A particle as the search for its owner sees it.
struct SearchPoint
{
    Vec3 position; ///< where its weights are evaluated [m]
    Vec3 fallback; ///< used where `position` lies outside every mesh (behind a wall) [m]
};

/// Who sends which particle where.
///
/// Particle and cell are owned by ranks of two independent decompositions. The particles whose
/// cell belongs to this rank are *handled* here: first the residents (also owned by this rank, in
/// the order of their slots, never sent), then the guests (in the order of their home ranks).
/// Only ranks that share particles exchange messages with content; no rank ever holds more than
/// the particles that it owns or handles. Memory O(particles here + ranks).
///
/// Every member function marked collective must be called by all ranks of the communicator.
class ParticleExchange
{
public:
    using Locate = std::function<Location(const SearchPoint&)>;

    /// Traffic since construction.
    struct Traffic
    {
        std::size_t bytes = 0; ///< sent by this rank to others
        std::size_t messages = 0; ///< with content, sent by this rank to others
        std::size_t plans = 0;
    };

    /// Collective. `cells` bounds the cells of this rank (empty box: no cells).
    ParticleExchange(MPI_Comm communicator, const Bounds& cells);

    ~ParticleExchange();
    ParticleExchange(const ParticleExchange&) = delete;
    ParticleExchange& operator=(const ParticleExchange&) = delete;

    /// Collective. Finds the rank that handles each of this rank's particles; `locate` is called
    /// for own particles and for those that others ask about. Of several ranks that see a
    /// particle the best quality wins, then the home rank, then the lowest.
    void plan(const std::vector<SearchPoint>& own, const Locate& locate);

    /// Particles handled here: residents, then guests.
    int handled() const { return static_cast<int>(cells_.size()); }

    /// Cell of each handled particle.
    const std::vector<int>& cells() const { return cells_; }

    /// Slots of the residents, ascending.
    const std::vector<int>& residents() const { return residents_; }

    /// Slots of own particles that no rank's mesh sees, ascending.
    const std::vector<int>& outside() const { return outside_; }

    /// Collective. own[slot] of every particle, to the rank that handles it: result[handled].
    template<class T>
    std::vector<T> toHandlers(const std::vector<T>& own) const;

    /// Collective. The way back: handled[i] into own[slot]. Slots of outside particles are kept.
    template<class T>
    void toOwners(const std::vector<T>& handled, std::vector<T>& own) const;

    const Traffic& traffic() const { return traffic_; }

private:
    /// Items in the order of ranks: those of rank r are [offsets[r], offsets[r + 1]).
    struct Batch
    {
        std::vector<int> offsets;
        int count() const { return offsets.back(); }
    };

    int size() const { return static_cast<int>(bounds_.size()); }
    Batch batchOf(const std::vector<int>& counts) const;
    Batch mirrored(const std::vector<int>& counts) const;
    void transfer(const void* send, const Batch& sent, void* receive, const Batch& received,
        std::size_t itemBytes) const;
    void askOthers(const std::vector<SearchPoint>& own, const std::vector<Location>& here,
        const std::vector<int>& strangers, const Locate& locate);

    MPI_Comm communicator_;
    int rank_ = 0;
    std::vector<Bounds> bounds_; // of every rank's cells
    std::vector<int> cells_;
    std::vector<int> residents_;
    std::vector<int> emigrants_; // slots sent away, in the order of toOthers_
    std::vector<int> outside_;
    Batch toOthers_;
    Batch fromOthers_;
    bool anyTravel_ = false; // on any rank
    mutable Traffic traffic_;
};

template<class T>
std::vector<T> ParticleExchange::toHandlers(const std::vector<T>& own) const
{
    std::vector<T> handled(cells_.size());
    for (std::size_t i = 0; i < residents_.size(); ++i)
    {
        handled[i] = own[residents_[i]];
    }
    if (anyTravel_)
    {
        std::vector<T> parcels(emigrants_.size());
        for (std::size_t i = 0; i < emigrants_.size(); ++i)
        {
            parcels[i] = own[emigrants_[i]];
        }
        transfer(parcels.data(), toOthers_, handled.data() + residents_.size(), fromOthers_,
            sizeof(T));
    }
    return handled;
}

template<class T>
void ParticleExchange::toOwners(const std::vector<T>& handled, std::vector<T>& own) const
{
    for (std::size_t i = 0; i < residents_.size(); ++i)
    {
        own[residents_[i]] = handled[i];
    }
    if (anyTravel_)
    {
        std::vector<T> answers(emigrants_.size());
        transfer(handled.data() + residents_.size(), fromOthers_, answers.data(), toOthers_,
            sizeof(T));
        for (std::size_t i = 0; i < emigrants_.size(); ++i)
        {
            own[emigrants_[i]] = answers[i];
        }
    }
}

} // namespace interstice
