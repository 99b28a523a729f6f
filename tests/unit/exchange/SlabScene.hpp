// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// No physics and no mesh library: the cells are slabs of a bar along x, dealt out to the ranks.

#include "coupling/exchange/ParticleExchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace interstice
{

using Quality = Location::Quality;

inline int thisRank()
{
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

inline int ranks()
{
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
}

inline long sumOverRanks(long mine)
{
    MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
    return mine;
}

/// A bar of unit cross-section whose cells [i, i + 1] lie along x; this rank has [first, last).
struct Slabs
{
    int first;
    int last;

    bool holds(const Vec3& p) const
    {
        return first < last && p[0] >= first && p[0] <= last && p[1] >= 0 && p[1] <= 1
            && p[2] >= 0 && p[2] <= 1;
    }

    int cellOf(const Vec3& p) const
    {
        return std::min(static_cast<int>(p[0]), last - 1) - first;
    }

    Location operator()(const SearchPoint& point) const
    {
        if (holds(point.position))
        {
            return {Quality::exact, cellOf(point.position)};
        }
        if (holds(point.fallback))
        {
            return {Quality::fallback, cellOf(point.fallback)};
        }
        return {};
    }

    Bounds bounds() const
    {
        Bounds box;
        if (first < last)
        {
            box.add({double(first), 0, 0});
            box.add({double(last), 1, 1});
        }
        return box;
    }
};

constexpr int cellsPerRank = 5;

inline Slabs evenSlabs()
{
    return {thisRank()*cellsPerRank, (thisRank() + 1)*cellsPerRank};
}

inline SearchPoint at(double x, double y = 0.5, double z = 0.5)
{
    return {{x, y, z}, {x, y, z}};
}

/// The same cloud on every rank. The box reaches a tenth of its length beyond the bar.
inline std::vector<SearchPoint> cloud(int count, double length)
{
    std::mt19937 random(7);
    const auto between = [&](double low, double high)
    { return low + (high - low)*(random()/4294967296.0); };
    std::vector<SearchPoint> points;
    for (int i = 0; i < count; ++i)
    {
        points.push_back(at(between(-0.1*length, 1.1*length), between(0, 1), between(0, 1)));
    }
    return points;
}

/// Particle i is owned by rank i mod P, wherever it is.
inline std::vector<int> dealtOut(int count)
{
    std::vector<int> ids;
    for (int i = thisRank(); i < count; i += ranks())
    {
        ids.push_back(i);
    }
    return ids;
}

inline std::vector<SearchPoint> select(const std::vector<SearchPoint>& all, const std::vector<int>& ids)
{
    std::vector<SearchPoint> own;
    for (const int id : ids)
    {
        own.push_back(all[id]);
    }
    return own;
}

} // namespace interstice
