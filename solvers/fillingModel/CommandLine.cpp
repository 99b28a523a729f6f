// SPDX-License-Identifier: GPL-3.0-or-later
#include "CommandLine.hpp"

#include "ResultsTable.hpp"

#include <algorithm>

namespace interstice
{

namespace
{

const char* const seeHelp = "fillingModel --help shows all commands and options.";

bool among(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> dashed(std::vector<std::string> names)
{
    for (std::string& name : names)
    {
        name.insert(0, "--");
    }
    return names;
}

} // namespace

CommandLine::CommandLine(const std::vector<std::string>& words,
    const std::vector<std::string>& options, const std::vector<std::string>& flags)
{
    std::vector<std::string> all = options;
    all.insert(all.end(), flags.begin(), flags.end());
    all = dashed(all);

    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const std::string& word = words[i];
        const std::string name = word.size() > 2 ? word.substr(2) : "";
        if (word.compare(0, 2, "--") != 0)
        {
            if (!file_.empty())
            {
                throw UsageError({"There are two files on the command line.",
                    file_ + " and " + word, "one file", "", seeHelp});
            }
            file_ = word;
        }
        else if (!among(all, word))
        {
            throw UsageError(unknownName("option", word, all, "command line").problem());
        }
        else if (among(flags, name))
        {
            take(name, "");
        }
        else if (i + 1 < words.size())
        {
            take(name, words[++i]);
        }
        else
        {
            throw UsageError({"An option has no value.", word, word + " VALUE", "", seeHelp});
        }
    }
    if (file_.empty())
    {
        throw UsageError({"The command line names no file.", "", "one file", "", seeHelp});
    }
}

void CommandLine::take(const std::string& name, const std::string& value)
{
    if (!values_.emplace(name, value).second)
    {
        throw UsageError(
            {"An option is given twice.", "--" + name, "each option once", "", seeHelp});
    }
}

std::string CommandLine::text(const std::string& option, const std::string& ifMissing) const
{
    const auto place = values_.find(option);
    return place == values_.end() ? ifMissing : place->second;
}

double CommandLine::positive(const std::string& option, const std::optional<double>& usual) const
{
    const auto place = values_.find(option);
    if (place == values_.end())
    {
        if (usual)
        {
            return *usual;
        }
        throw UsageError({"A quantity is missing.", "no --" + option, "--" + option + " NUMBER",
            "command line", seeHelp});
    }
    const std::optional<double> value = finiteNumber(place->second);
    if (!value || *value <= 0)
    {
        throw UsageError({"A quantity is not a number above zero.", place->second,
            "a number above zero, in SI units", "command line, --" + option, seeHelp});
    }
    return *value;
}

} // namespace interstice
