// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/effects/EffectTable.hpp"

#include "coupling/laws/InputError.hpp"

#include <algorithm>
#include <cstdio>

namespace interstice
{

namespace
{

std::string line(const std::string& effect, const std::string& state, const std::string& by,
    const std::string& number, const std::string& limit, const std::string& time)
{
    char text[200];
    std::snprintf(text, sizeof text, "    %-16s %-6s %-7s %9s %7s", effect.c_str(), state.c_str(), by.c_str(),
        number.c_str(), limit.c_str());
    return text + time;
}

// Of time, in a column as wide as its heading.
std::string shareOf(double wall, double seconds)
{
    char text[32];
    std::snprintf(text, sizeof text, " %7.2f %%", 100*seconds/wall);
    return text;
}

std::string shown(double value)
{
    char text[24];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

} // namespace

Effect::Wish EffectTable::wish(const std::string& word, const std::string& where)
{
    if (word == "auto")
    {
        return Effect::Wish::automatic;
    }
    if (word == "on")
    {
        return Effect::Wish::on;
    }
    if (word == "off")
    {
        return Effect::Wish::off;
    }
    throw unknownName("choice for an effect", word, {"auto", "on", "off"}, where);
}

std::size_t EffectTable::add(const Effect& effect)
{
    effects_.push_back(effect);
    effects_.back().on = effect.on || effect.wish == Effect::Wish::on;
    return effects_.size() - 1;
}

std::string EffectTable::meet(std::size_t place, double value, double time)
{
    Effect& effect = effects_[place];
    const bool before = effect.askedFor();
    effect.largest = std::max(effect.largest.value_or(value), value);
    if (before || !effect.askedFor())
    {
        return {};
    }
    effect.since = time;
    const std::string why = effect.number + " is " + shown(value) + ", above " + shown(effect.limit);
    switch (effect.wish)
    {
    case Effect::Wish::automatic:
        effect.on = true;
        return effect.key + " is simulated from " + shown(time) + " s on: " + why + ".";
    case Effect::Wish::off:
        return effect.key + (effect.on ? " is not simulated everywhere" : " is off") + ", and would matter: " + why + ".";
    case Effect::Wish::on:
        break;
    }
    return {};
}

std::string EffectTable::decidedBy(const Effect& effect)
{
    if (!effect.by.empty())
    {
        return effect.by;
    }
    return effect.wish == Effect::Wish::automatic ? "number" : "user";
}

std::size_t EffectTable::place(const std::string& key) const
{
    const auto found = std::find_if(
        effects_.begin(), effects_.end(), [&key](const Effect& effect) { return effect.key == key; });
    return static_cast<std::size_t>(found - effects_.begin());
}

std::string EffectTable::text(double wall) const
{
    std::string table = line("effect", "", "by", "number", "limit", wall > 0 ? "      time" : "") + '\n';
    for (const Effect& effect : effects_)
    {
        const std::string state = effect.on ? "on" : "off";
        table += line(effect.key, effect.how.empty() ? state : effect.how, decidedBy(effect),
                     effect.largest ? shown(*effect.largest) : "-", shown(effect.limit), wall > 0 ? shareOf(wall, effect.seconds) : "")
            + "   " + effect.number + '\n';
    }
    return table;
}

} // namespace interstice
