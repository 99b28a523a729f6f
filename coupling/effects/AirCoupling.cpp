// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/effects/AirCoupling.hpp"

#include "coupling/laws/InputError.hpp"

namespace interstice
{

std::optional<AirCoupling> airCoupling(const std::string& word, const std::string& where)
{
    if (word == "auto")
    {
        return {};
    }
    if (word == "none" || word == "off")
    {
        return AirCoupling::none;
    }
    if (word == "oneWay")
    {
        return AirCoupling::oneWay;
    }
    if (word == "twoWay" || word == "on")
    {
        return AirCoupling::twoWay;
    }
    throw unknownName("choice for the air", word, {"auto", "twoWay", "on", "oneWay", "none", "off"}, where);
}

const char* nameOf(AirCoupling coupling)
{
    switch (coupling)
    {
    case AirCoupling::none:
        return "none";
    case AirCoupling::oneWay:
        return "oneWay";
    case AirCoupling::twoWay:
        break;
    }
    return "twoWay";
}

} // namespace interstice
