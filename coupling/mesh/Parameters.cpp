// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/Parameters.hpp"

#include "coupling/laws/InputError.hpp"

#include "ITstream.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "Switch.H"
#include "dimensionedScalar.H"
#include "error.H"

#include <algorithm>
#include <sstream>

namespace interstice
{

using namespace Foam;

namespace
{

const char* describe(Parameters::Range range)
{
    switch (range)
    {
        case Parameters::Range::positive:
            return "a number above zero";
        case Parameters::Range::notNegative:
            return "a number not below zero";
        case Parameters::Range::fraction:
            return "a number between zero and one";
        case Parameters::Range::any:
            break;
    }
    return "a number";
}

bool inside(Parameters::Range range, scalar value)
{
    switch (range)
    {
        case Parameters::Range::positive:
            return value > 0;
        case Parameters::Range::notNegative:
            return value >= 0;
        case Parameters::Range::fraction:
            return value > 0 && value < 1;
        case Parameters::Range::any:
            break;
    }
    return true;
}

std::string entryText(const dictionary& dict, const word& key)
{
    const auto opens = [](const token& t)
    { return t == token::BEGIN_LIST || t == token::BEGIN_SQR; };
    const auto closes = [](const token& t) { return t == token::END_LIST || t == token::END_SQR; };
    OStringStream text;
    const ITstream& tokens = dict.lookup(key);
    forAll(tokens, i)
    {
        const bool close = i == 0 || opens(tokens[i - 1]) || closes(tokens[i]);
        text << (close ? "" : " ") << tokens[i];
    }
    return text.str();
}

} // namespace

Parameters::Parameters(const dictionary& dict)
:
    dict_(dict)
{
    // Entries that OpenFOAM's own macros leave behind are nobody's mistake.
    known_ = {"FoamFile"};
}

std::string Parameters::nameOf(const dictionary& dict)
{
    const std::string full = dict.name();
    const std::string here = cwd() + "/";
    return full.compare(0, here.size(), here) == 0 ? full.substr(here.size()) : full;
}

std::string Parameters::where(const word& key) const
{
    return nameOf(dict_) + ", key " + key;
}

void Parameters::require(const word& key, const char* wanted) const
{
    if (!has(key))
    {
        std::vector<std::string> present;
        for (const word& other : dict_.toc())
        {
            present.push_back(other);
        }
        const std::string nearest = nearestName(key, present);
        throw InputError({"A required key is missing.", "no key " + key, wanted, where(key),
            nearest.empty() ? "Add it." : "Is " + nearest + " a misspelt " + key + "?"});
    }
}

// OpenFOAM's complaint about a value, as one of ours.
template<class Reader>
auto Parameters::understood(const word& key, const std::string& wanted, Reader read) const
{
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        const auto value = read();
        FatalIOError.throwExceptions(throwing);
        return value;
    }
    catch (const Foam::IOerror&)
    {
        FatalIOError.throwExceptions(throwing);
        throw InputError({"A value cannot be understood.", entryText(dict_, key), wanted,
            where(key), "Correct the value."});
    }
}

template<class T>
T Parameters::read(const word& key, const char* wanted) const
{
    return understood(key, wanted, [&] { return dict_.get<T>(key); });
}

scalar Parameters::checked(const word& key, const char* unit, Range range, scalar value) const
{
    if (!inside(range, value))
    {
        std::ostringstream found;
        found << value << ' ' << unit;
        throw InputError({"A value is out of its range.", found.str(), describe(range),
            where(key), "Correct the value (SI units)."});
    }
    return value;
}

scalar Parameters::number(const word& key, const char* unit, Range range) const
{
    require(key, describe(range));
    return checked(key, unit, range, read<scalar>(key, describe(range)));
}

scalar Parameters::number(const word& key, const char* unit, Range range, scalar byDefault) const
{
    return has(key) ? number(key, unit, range) : byDefault;
}

scalar Parameters::quantity(
    const word& key, const dimensionSet& dimensions, const char* unit, Range range) const
{
    require(key, describe(range));
    OStringStream wanted;
    wanted << dimensions << ", and " << describe(range);
    const scalar value = understood(key, wanted.str(),
        [&] { return dimensionedScalar(key, dimensions, dict_).value(); });
    return checked(key, unit, range, value);
}

bool Parameters::flag(const word& key, bool byDefault) const
{
    return has(key) ? bool(read<Switch>(key, "on or off")) : byDefault;
}

word Parameters::name(const word& key, const word& byDefault) const
{
    return has(key) ? read<word>(key, "a name") : byDefault;
}

string Parameters::text(const word& key) const
{
    require(key, "a text in quotes");
    return read<string>(key, "a text in quotes");
}

string Parameters::text(const word& key, const string& byDefault) const
{
    return has(key) ? read<string>(key, "a text in quotes") : byDefault;
}

vector Parameters::direction(const word& key, const char*) const
{
    require(key, "three numbers in parentheses");
    return read<vector>(key, "three numbers in parentheses");
}

vector Parameters::direction(const word& key, const char* unit, const vector& byDefault) const
{
    return has(key) ? direction(key, unit) : byDefault;
}

bool Parameters::has(const word& key) const
{
    known_.insert(key);
    return dict_.found(key, keyType::LITERAL);
}

const dictionary& Parameters::sub(const word& key) const
{
    if (!has(key))
    {
        return dictionary::null;
    }
    if (!dict_.isDict(key))
    {
        throw InputError({"A group of keys is wanted here.", entryText(dict_, key),
            key + " { ... }", where(key), "Put the values in braces."});
    }
    return dict_.subDict(key);
}

const dictionary& Parameters::group(const word& key) const
{
    require(key, "a group of keys in braces");
    return sub(key);
}

void Parameters::allKnown() const
{
    check(false);
}

void Parameters::allGroupsKnown() const
{
    check(true);
}

void Parameters::check(bool groupsOnly) const
{
    for (const word& key : dict_.toc())
    {
        std::vector<std::string> valid(known_.begin(), known_.end());
        valid.erase(std::remove(valid.begin(), valid.end(), "FoamFile"), valid.end());
        if (!known_.count(key)
            && (!groupsOnly || dict_.isDict(key) || !nearestName(key, valid).empty()))
        {
            throw unknownName("key", key, valid, nameOf(dict_));
        }
    }
}

} // namespace interstice
