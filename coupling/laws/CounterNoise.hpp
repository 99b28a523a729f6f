// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace interstice
{

/// Random bits that belong to a thing and a time: the same in every run, on any rank, and after a restart. A generator for
/// the distributions of <random>.
///
/// G.L. Steele, D. Lea & C.H. Flood, OOPSLA 2014, 453-472 (SplitMix64), begun at a hash of both numbers.
class CounterNoise
{
public:
    using result_type = std::uint64_t;

    CounterNoise(std::uint64_t thing, std::uint64_t time) : state_(mixed(mixed(thing) + time)) {}

    result_type operator()() { return mixed(state_ += increment); }

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

private:
    static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15;

    static std::uint64_t mixed(std::uint64_t z)
    {
        z = (z ^ (z >> 30))*0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27))*0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

} // namespace interstice
