// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dictionary.H"
#include "dimensionSet.H"
#include "vector.H"

#include <set>
#include <string>
#include <vector>

namespace interstice
{

/// A dictionary whose every key is declared where it is read: with unit, range and default. Keys
/// that nobody declared are spelling mistakes and end the run.
///
/// Errors are InputErrors that name file, dictionary and key; same on all ranks.
class Parameters
{
public:
    enum class Range
    {
        any,
        positive,
        notNegative,
        fraction ///< in (0, 1), ends excluded
    };

    /// `dict` must outlive this. A missing sub-dictionary is read as empty.
    explicit Parameters(const Foam::dictionary& dict);

    Foam::scalar number(const Foam::word& key, const char* unit, Range range) const;
    Foam::scalar number(
        const Foam::word& key, const char* unit, Range range, Foam::scalar byDefault) const;
    /// A number that may carry its dimensions, `[0 2 -1 0 0 0 0] 1e-5`, which must be these.
    Foam::scalar quantity(const Foam::word& key, const Foam::dimensionSet& dimensions,
        const char* unit, Range range) const;
    bool flag(const Foam::word& key, bool byDefault) const;
    Foam::word name(const Foam::word& key, const Foam::word& byDefault) const;
    Foam::string text(const Foam::word& key) const; ///< required
    Foam::string text(const Foam::word& key, const Foam::string& byDefault) const;
    Foam::vector direction(const Foam::word& key, const char* unit) const; ///< any vector
    Foam::vector direction(
        const Foam::word& key, const char* unit, const Foam::vector& byDefault) const;

    bool has(const Foam::word& key) const;

    /// Sub-dictionary, empty if missing; its own keys are not checked here.
    const Foam::dictionary& sub(const Foam::word& key) const;

    /// The same, but it must be there.
    const Foam::dictionary& group(const Foam::word& key) const;

    /// Throws InputError for a key that was never asked for, with the nearest that was.
    void allKnown() const;

    /// The same where values may stand that others refer to ($name): of these only one that looks
    /// like a misspelt key is refused.
    void allGroupsKnown() const;

    /// A dictionary's file, below the folder the run was started in, and its place in the file.
    static std::string nameOf(const Foam::dictionary& dict);

    /// That and the key, for messages.
    std::string where(const Foam::word& key) const;

private:
    template<class Reader>
    auto understood(const Foam::word& key, const std::string& wanted, Reader read) const;
    template<class T>
    T read(const Foam::word& key, const char* wanted) const;
    void check(bool groupsOnly) const;
    void require(const Foam::word& key, const char* wanted) const;
    Foam::scalar checked(
        const Foam::word& key, const char* unit, Range range, Foam::scalar value) const;

    const Foam::dictionary& dict_;
    mutable std::set<std::string> known_;
};

} // namespace interstice
