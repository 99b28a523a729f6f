// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace interstice
{

/// An error that a user can cause and can remedy: a wrong key, value, name or step.
///
/// Carries what the user needs to act, and prints it as
///
///     The fluid step is not a whole number of DEM steps.
///         found   deltaT 2e-05 s, timestep 3e-06 s (6.67 DEM steps)
///         wanted  a whole number of at least 1
///         where   system/controlDict, deltaT
///     Set deltaT to 1.8e-05 or 2.1e-05.
///
/// Lines whose field is empty are left out; further lines of a field are indented below its first.
/// In a parallel run throw it on all ranks or on none: one rank alone would leave the others
/// waiting in their next collective call.
class InputError : public std::runtime_error
{
public:
    /// The parts of the message, each one sentence or phrase.
    struct Problem
    {
        std::string rule; ///< What is not as it must be, as a sentence.
        std::string found; ///< The value met, with its unit.
        std::string wanted; ///< The values that are allowed.
        std::string where; ///< File and key.
        std::string remedy; ///< What to do, as a sentence.
    };

    explicit InputError(Problem problem);

    const Problem& problem() const noexcept { return problem_; }

private:
    Problem problem_;
};

/// The valid name that a mistyped word was most likely meant to be.
///
/// Nearness is the number of letters to insert, delete, replace or swap with a neighbour, where
/// lower and upper case count as the same. Empty if even the nearest name differs in more than a
/// third of its letters, where a guess would mislead.
std::string nearestName(const std::string& word, const std::vector<std::string>& valid);

/// The error for a name that is in no table: lists the valid names and proposes the nearest.
///
/// @param kind  what is named, for example "drag law"
/// @param word  the name found
/// @param valid the names that exist
/// @param where file and key; may be empty
InputError unknownName(const std::string& kind, const std::string& word,
    const std::vector<std::string>& valid, const std::string& where);

} // namespace interstice
