// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/InputError.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace interstice
{

namespace
{

void appendField(std::string& text, const std::string& label, const std::string& value)
{
    if (value.empty())
    {
        return;
    }

    const std::string indent(4, ' ');
    const std::string column(8, ' ');
    text += "\n" + indent + label + std::string(column.size() - label.size(), ' ');

    for (const char c : value)
    {
        text += c;
        if (c == '\n')
        {
            text += indent + column;
        }
    }
}

std::string message(const InputError::Problem& problem)
{
    std::string text = problem.rule;
    appendField(text, "found", problem.found);
    appendField(text, "wanted", problem.wanted);
    appendField(text, "where", problem.where);
    if (!problem.remedy.empty())
    {
        text += "\n" + problem.remedy;
    }
    return text;
}

std::string lowerCase(std::string word)
{
    std::transform(word.begin(), word.end(), word.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word;
}

// Damerau's distance, swaps of neighbours only: the table is filled row by row, and three rows
// are all that the recurrence looks back on.
std::size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
        row[j] = j;
    }

    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        std::swap(beforeLast, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replace, last[j] + 1, row[j - 1] + 1});

            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            {
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

} // namespace

InputError::InputError(Problem problem)
    : std::runtime_error(message(problem)), problem_(std::move(problem))
{
}

std::string nearestName(const std::string& word, const std::vector<std::string>& valid)
{
    std::string nearest;
    std::size_t fewest = 0;
    for (const std::string& name : valid)
    {
        const std::size_t edits = editDistance(lowerCase(word), lowerCase(name));
        if (3 * edits <= name.size() && (nearest.empty() || edits < fewest))
        {
            nearest = name;
            fewest = edits;
        }
    }
    return nearest;
}

InputError unknownName(const std::string& kind, const std::string& word,
    const std::vector<std::string>& valid, const std::string& where)
{
    std::string names;
    for (const std::string& name : valid)
    {
        names += (names.empty() ? "" : "\n") + name;
    }

    const std::string nearest = nearestName(word, valid);
    return InputError({"There is no " + kind + " of this name.", word.empty() ? "(nothing)" : word,
        names.empty() ? "(none exists)" : names, where,
        nearest.empty() ? "Use one of the names above, spelt exactly so."
                        : "Did you mean " + nearest + "?"});
}

} // namespace interstice
