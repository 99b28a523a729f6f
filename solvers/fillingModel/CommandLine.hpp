// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/Laws.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace interstice
{

/// A command line that cannot be understood, as opposed to one that cannot be obeyed.
class UsageError : public InputError
{
public:
    using InputError::InputError;
};

/// The words after the program's name: COMMAND FILE --option value ... --flag ...
class CommandLine
{
public:
    /// Options take a value, flags none. Throws UsageError for an option that is not among them
    /// (with the nearest name), given twice or without its value, and unless there is one file.
    CommandLine(const std::vector<std::string>& words, const std::vector<std::string>& options,
        const std::vector<std::string>& flags);

    const std::string& file() const { return file_; }

    bool has(const std::string& option) const { return values_.count(option) > 0; }

    std::string text(const std::string& option, const std::string& ifMissing) const;

    /// A number above zero. Throws UsageError if it is not, or if it is missing and has no `usual`.
    double positive(const std::string& option, const std::optional<double>& usual) const;

private:
    void take(const std::string& name, const std::string& value);

    std::string file_;
    std::map<std::string, std::string> values_;
};

} // namespace interstice
