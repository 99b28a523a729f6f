// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace interstice
{

/// How air and powder act on each other.
enum class AirCoupling
{
    none, ///< no air is simulated: the powder falls in a vacuum
    oneWay, ///< a given air moves the powder and does not change
    twoWay
};

/// The word of a case: none or off, oneWay, twoWay or on; nothing for auto. Throws InputError for another one, which
/// names `where` (file and key).
std::optional<AirCoupling> airCoupling(const std::string& word, const std::string& where);

/// Its word.
const char* nameOf(AirCoupling coupling);

} // namespace interstice
