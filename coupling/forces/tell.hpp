// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/effects/EffectTable.hpp"

#include "Time.H"

namespace interstice
{

/// Whether numbers are looked at in this step, one of twenty: by its index, which a run that goes on takes over.
inline bool lookDue(const Foam::Time& time)
{
    constexpr int every = 20;
    return time.timeIndex() % every == 1;
}

/// The number of an effect as it is at a time [s], with a line in the log if the user is to know. Same on all ranks.
inline void tell(EffectTable& table, std::size_t place, double number, double time)
{
    const std::string news = table.meet(place, number, time);
    if (!news.empty())
    {
        Foam::Info << "    " << news.c_str() << Foam::endl;
    }
}

} // namespace interstice
