// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/exchange/SlabScene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace interstice
{
namespace
{

TEST(ParticleExchange, HandlesEachParticleOnTheOneRankWhoseCellsHoldIt)
{
    const Slabs slabs = evenSlabs();
    const int count = 1000;
    const std::vector<SearchPoint> all = cloud(count, cellsPerRank*ranks());
    const std::vector<int> ids = dealtOut(count);
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(select(all, ids), slabs);

    std::vector<int> handlers(count, 0);
    const std::vector<int> handled = exchange.toHandlers(ids);
    ASSERT_EQ(int(handled.size()), exchange.handled());
    for (int i = 0; i < exchange.handled(); ++i)
    {
        const Vec3& p = all[handled[i]].position;
        ++handlers[handled[i]];
        EXPECT_TRUE(slabs.holds(p)) << "x = " << p[0];
        EXPECT_EQ(exchange.cells()[i], slabs.cellOf(p));
    }
    MPI_Allreduce(MPI_IN_PLACE, handlers.data(), count, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    const Slabs bar{0, cellsPerRank*ranks()};
    for (int i = 0; i < count; ++i)
    {
        EXPECT_EQ(handlers[i], bar.holds(all[i].position) ? 1 : 0) << "particle " << i;
    }
}

TEST(ParticleExchange, CountsLocatedAndOutsideToTheWhole)
{
    const Slabs slabs = evenSlabs();
    const int count = 1000;
    const std::vector<int> ids = dealtOut(count);
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(select(cloud(count, cellsPerRank*ranks()), ids), slabs);

    const long outside = sumOverRanks(static_cast<long>(exchange.outside().size()));
    EXPECT_EQ(sumOverRanks(exchange.handled()) + outside, count);
    EXPECT_GT(outside, 0);
}

TEST(ParticleExchange, BringsEveryAnswerBackToTheParticleThatAsked)
{
    struct Parcel
    {
        double value;
        int id;
    };
    const Slabs slabs = evenSlabs();
    const int count = 1000;
    const std::vector<int> ids = dealtOut(count);
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());
    exchange.plan(select(cloud(count, cellsPerRank*ranks()), ids), slabs);

    std::vector<Parcel> own;
    for (const int id : ids)
    {
        own.push_back({std::sqrt(double(id)), id});
    }
    std::vector<Parcel> back(own.size(), Parcel{-1, -1});
    exchange.toOwners(exchange.toHandlers(own), back);

    std::vector<char> outside(own.size(), 0);
    for (const int slot : exchange.outside())
    {
        outside[slot] = 1;
    }
    for (std::size_t slot = 0; slot < own.size(); ++slot)
    {
        EXPECT_EQ(back[slot].id, outside[slot] ? -1 : own[slot].id);
        EXPECT_EQ(back[slot].value, outside[slot] ? -1 : own[slot].value);
    }
}

TEST(ParticleExchange, ListsResidentsInTheOrderOfTheirSlotsAndThenGuests)
{
    const Slabs slabs = evenSlabs();
    const std::vector<int> ids = dealtOut(400);
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());
    exchange.plan(select(cloud(400, cellsPerRank*ranks()), ids), slabs);

    const std::vector<int> homes =
        exchange.toHandlers(std::vector<int>(ids.size(), thisRank()));

    const auto firstGuest = homes.begin() + exchange.residents().size();
    EXPECT_TRUE(std::all_of(homes.begin(), firstGuest, [](int r) { return r == thisRank(); }));
    EXPECT_TRUE(std::none_of(firstGuest, homes.end(), [](int r) { return r == thisRank(); }));
    EXPECT_TRUE(std::is_sorted(firstGuest, homes.end()));
    EXPECT_TRUE(std::is_sorted(exchange.residents().begin(), exchange.residents().end()));
}

// Every boundary between two ranks belongs to both; each rank owns a particle on each of them.
TEST(ParticleExchange, HandlesAParticleOnTheBoundaryOfTwoRanksOnce)
{
    const Slabs slabs = evenSlabs();
    std::vector<SearchPoint> own;
    for (int rank = 0; rank <= ranks(); ++rank)
    {
        own.push_back(at(rank*cellsPerRank));
    }
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(own, slabs);

    EXPECT_EQ(sumOverRanks(exchange.handled()), ranks()*(ranks() + 1));
    std::vector<int> answers(own.size(), 0);
    exchange.toOwners(std::vector<int>(exchange.handled(), 1), answers);
    EXPECT_EQ(std::accumulate(answers.begin(), answers.end(), 0), ranks() + 1);
    EXPECT_EQ(int(exchange.residents().size()), 2) << "both ends of the own slabs stay at home";
}

TEST(ParticleExchange, SendsNothingWhileBothDecompositionsAgree)
{
    const Slabs slabs = evenSlabs();
    std::vector<SearchPoint> own;
    for (int cell = slabs.first; cell < slabs.last; ++cell)
    {
        own.push_back(at(cell + 0.5));
    }
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    for (int step = 0; step < 3; ++step)
    {
        exchange.plan(own, slabs);
        exchange.toOwners(exchange.toHandlers(own), own);
    }

    EXPECT_EQ(exchange.traffic().bytes, 0u);
    EXPECT_EQ(exchange.traffic().messages, 0u);
    EXPECT_EQ(exchange.traffic().plans, 3u);
    EXPECT_EQ(exchange.handled(), cellsPerRank);
}

TEST(ParticleExchange, ForgetsTheTravelOfTheStepBefore)
{
    const Slabs slabs = evenSlabs();
    const double next = (thisRank() + 1) % ranks()*cellsPerRank + 0.5;
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());
    exchange.plan({at(next)}, slabs);

    exchange.plan({at(slabs.first + 0.5), at(slabs.first + 1.5)}, slabs);

    EXPECT_EQ(exchange.toHandlers(std::vector<int>{1, 2}), (std::vector<int>{1, 2}));
    EXPECT_EQ(exchange.cells(), (std::vector<int>{0, 1}));
}

// All particles of a rank lie in the next rank's slabs: a question (position and fallback, 48
// bytes), an answer (8 bytes) and a verdict (1 byte) each, whatever the number of ranks; then what
// is sent. The total number of particles grows with the ranks and does not show.
TEST(ParticleExchange, SendsAsMuchPerRankOnAnyNumberOfRanks)
{
    const int count = 300;
    const Slabs slabs = evenSlabs();
    const double start = (thisRank() + 1) % ranks()*cellsPerRank;
    std::vector<SearchPoint> own;
    for (int i = 0; i < count; ++i)
    {
        own.push_back(at(start + (i + 0.5)*cellsPerRank/count));
    }
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(own, slabs);
    const std::size_t planned = exchange.traffic().bytes;
    const std::vector<double> sent = exchange.toHandlers(std::vector<double>(count, 1.0));

    const bool alone = ranks() == 1;
    EXPECT_EQ(planned, alone ? 0u : count*(48u + 8u + 1u));
    EXPECT_EQ(exchange.traffic().bytes - planned, alone ? 0u : count*sizeof(double));
    EXPECT_EQ(exchange.traffic().messages, alone ? 0u : 4u);
    EXPECT_EQ(exchange.handled(), count);
    EXPECT_LE(sent.capacity(), 2u*count);
}

// Behind the wall at y = 1, with the last place inside the bar as fallback, on the next rank.
TEST(ParticleExchange, UsesTheFallbackWhereNoRankHoldsThePosition)
{
    const Slabs slabs = evenSlabs();
    const double x = (thisRank() + 1) % ranks()*cellsPerRank + 2.5;
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan({{{x, 1.01, 0.5}, {x, 0.99, 0.5}}}, slabs);

    EXPECT_EQ(exchange.cells(), std::vector<int>{2});
    EXPECT_TRUE(exchange.outside().empty());
}

// The fallback lies at home, the position in the next rank's cells: the position wins.
TEST(ParticleExchange, PrefersTheRankThatHoldsThePositionToHomeWithTheFallback)
{
    const Slabs slabs = evenSlabs();
    const double x = (thisRank() + 1) % ranks()*cellsPerRank + 3.5;
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan({{{x, 0.5, 0.5}, {slabs.first + 1.5, 0.5, 0.5}}}, slabs);

    EXPECT_EQ(exchange.cells(), std::vector<int>{3});
    EXPECT_EQ(exchange.residents().empty(), ranks() > 1);
}

// Both ranks at a boundary offer the fallback; the third, whose particle it is, sees nothing.
TEST(ParticleExchange, GivesAFallbackThatTwoRanksOfferToTheLowerOne)
{
    if (ranks() < 3)
    {
        GTEST_SKIP() << "three ranks are needed";
    }
    const Slabs slabs = evenSlabs();
    std::vector<SearchPoint> own;
    if (thisRank() == 2)
    {
        own.push_back({{cellsPerRank, 1.01, 0.5}, {cellsPerRank, 0.99, 0.5}});
    }
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(own, slabs);

    EXPECT_EQ(exchange.handled(), thisRank() == 0 ? 1 : 0);
}

TEST(ParticleExchange, WorksWithARankThatHasNoCells)
{
    const bool last = thisRank() == ranks() - 1;
    const int first = ranks() > 1 && last ? 0 : thisRank()*cellsPerRank;
    const Slabs slabs{first, ranks() > 1 && last ? 0 : first + cellsPerRank};
    const int count = 200;
    const std::vector<int> ids = dealtOut(count);
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(select(cloud(count, cellsPerRank*std::max(1, ranks() - 1)), ids), slabs);

    EXPECT_EQ(sumOverRanks(exchange.handled())
            + sumOverRanks(static_cast<long>(exchange.outside().size())),
        count);
    if (ranks() > 1 && last)
    {
        EXPECT_EQ(exchange.handled(), 0);
    }
    std::vector<int> back(ids.size(), -1);
    exchange.toOwners(exchange.toHandlers(ids), back);
    const std::size_t missing = std::count(back.begin(), back.end(), -1);
    EXPECT_EQ(missing, exchange.outside().size());
}

TEST(ParticleExchange, WorksWithAllParticlesOwnedByOneRank)
{
    const Slabs slabs = evenSlabs();
    std::vector<SearchPoint> own;
    if (thisRank() == ranks() - 1)
    {
        for (int cell = 0; cell < cellsPerRank*ranks(); ++cell)
        {
            own.push_back(at(cell + 0.5));
        }
    }
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan(own, slabs);

    std::vector<int> cells(cellsPerRank);
    std::iota(cells.begin(), cells.end(), 0);
    EXPECT_EQ(exchange.cells(), cells);
}

TEST(ParticleExchange, WorksWithNoParticlesAtAll)
{
    const Slabs slabs = evenSlabs();
    ParticleExchange exchange(MPI_COMM_WORLD, slabs.bounds());

    exchange.plan({}, slabs);

    EXPECT_EQ(exchange.handled(), 0);
    EXPECT_TRUE(exchange.toHandlers(std::vector<double>()).empty());
    EXPECT_TRUE(exchange.outside().empty());
}

} // namespace
} // namespace interstice
