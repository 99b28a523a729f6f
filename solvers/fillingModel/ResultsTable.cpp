// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResultsTable.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>

namespace interstice
{

namespace
{

// A filling ratio may exceed 1 a little, by what bulk density it is of; 1.5 is per cent by mistake.
constexpr double greatestMeasure = 1.5;

using Fields = std::vector<std::string>;

std::string trimmed(const std::string& text)
{
    const char* const blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Commas between quotes belong to the field, and two quotes there are one.
Fields fieldsOf(const std::string& line)
{
    Fields fields{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i)
    {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
        {
            fields.back() += line[++i];
        }
        else if (line[i] == '"')
        {
            quoted = !quoted;
        }
        else if (line[i] == ',' && !quoted)
        {
            fields.emplace_back();
        }
        else
        {
            fields.back() += line[i];
        }
    }
    std::transform(fields.begin(), fields.end(), fields.begin(), trimmed);
    return fields;
}

// The next line that says something; counts all lines.
bool nextLine(std::istream& in, std::string& line, int& number)
{
    while (std::getline(in, line))
    {
        ++number;
        line = trimmed(line);
        if (!line.empty() && line[0] != '#')
        {
            return true;
        }
    }
    return false;
}

std::string joined(const Fields& names)
{
    std::string text;
    for (const std::string& name : names)
    {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

std::optional<std::size_t> find(const Fields& header, const std::string& name)
{
    const auto place = std::find(header.begin(), header.end(), name);
    return place == header.end() ? std::nullopt
                                 : std::optional<std::size_t>(place - header.begin());
}

class RowReader
{
public:
    RowReader(const std::string& file, const std::string& measure, Fields header)
        : file_(file),
          header_(std::move(header)),
          measure_(column(measure)),
          error_(find(header_, measure + ".error")),
          packings_(find(header_, "packings")),
          status_(find(header_, "status"))
    {
        for (const Parameter& parameter : parameters)
        {
            columns_.push_back(column(parameter.name));
        }
    }

    bool hasErrors() const { return error_.has_value(); }

    bool isOk(const Fields& fields) const { return !status_ || fields[*status_] == "ok"; }

    void checkLength(const Fields& fields, int line) const
    {
        if (fields.size() != header_.size())
        {
            throw InputError({"A row of the table is not as long as its header.",
                std::to_string(fields.size()) + " fields",
                std::to_string(header_.size()) + " fields", place(line),
                "Is the file whole? Put quotes around a text with commas."});
        }
    }

    Variant read(const Fields& fields, int line) const
    {
        Variant variant{};
        variant.line = line;
        variant.filling.gravity = 9.81;
        for (std::size_t i = 0; i < columns_.size(); ++i)
        {
            variant.filling.*parameters[i].value = positive(fields, columns_[i], line);
        }
        variant.measure = number(fields, measure_, line);
        if (variant.measure < 0 || variant.measure > greatestMeasure)
        {
            throw bad(fields, measure_, line, "A filling ratio is not a fraction.", "0 to 1",
                "Divide by 100 if the column is in per cent.");
        }
        if (error_ && !fields[*error_].empty())
        {
            variant.error = number(fields, *error_, line);
            if (*variant.error < 0)
            {
                throw bad(fields, *error_, line, "A standard error is negative.", "0 or more",
                    "Leave the field empty if the error is not known.");
            }
        }
        if (packings_ && !fields[*packings_].empty())
        {
            variant.packings = static_cast<int>(std::lround(positive(fields, *packings_, line)));
        }
        return variant;
    }

private:
    std::size_t column(const std::string& name) const
    {
        const std::optional<std::size_t> place = find(header_, name);
        if (!place)
        {
            const std::string nearest = nearestName(name, namesOfOthers());
            throw InputError({"The table has no column " + name + ".", joined(header_), name, file_,
                nearest.empty() ? "Add the column, in SI units."
                                : "Is " + nearest + " meant? Name it " + name + "."});
        }
        return *place;
    }

    // A column with a meaning of its own is no misspelt other one, however near.
    Fields namesOfOthers() const
    {
        Fields others;
        std::copy_if(header_.begin(), header_.end(), std::back_inserter(others),
            [](const std::string& name)
            {
                return std::none_of(std::begin(parameters), std::end(parameters),
                    [&](const Parameter& parameter) { return name == parameter.name; });
            });
        return others;
    }

    std::string place(int line) const { return file_ + ", line " + std::to_string(line); }

    InputError bad(const Fields& fields, std::size_t column, int line, const char* rule,
        const char* wanted, const char* remedy) const
    {
        return InputError({rule, fields[column].empty() ? "(nothing)" : fields[column], wanted,
            place(line) + ", column " + header_[column], remedy});
    }

    double number(const Fields& fields, std::size_t column, int line) const
    {
        const std::optional<double> value = finiteNumber(fields[column]);
        if (!value)
        {
            throw bad(fields, column, line, "A value of the table is not a number.",
                "a finite number, as 1.5e-3",
                "Write the number, or give the row a status other than ok.");
        }
        return *value;
    }

    double positive(const Fields& fields, std::size_t column, int line) const
    {
        const double value = number(fields, column, line);
        if (value <= 0)
        {
            throw bad(fields, column, line, "A value of the table is not positive.", "above zero",
                "Write it in SI units.");
        }
        return value;
    }

    std::string file_;
    Fields header_;
    std::vector<std::size_t> columns_;
    std::size_t measure_;
    std::optional<std::size_t> error_;
    std::optional<std::size_t> packings_;
    std::optional<std::size_t> status_;
};

} // namespace

std::optional<double> finiteNumber(const std::string& text)
{
    const std::string word = trimmed(text);
    const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, failure] = std::from_chars(begin, end, value);
    if (failure != std::errc() || stop != end || !std::isfinite(value))
    {
        return std::nullopt;
    }
    return value;
}

ResultsTable readResults(std::istream& in, const std::string& file, const std::string& measure)
{
    std::string line;
    int number = 0;
    if (!nextLine(in, line, number))
    {
        throw InputError({"The table is empty.", "no header", "a line with names of columns", file,
            "Is it the right file?"});
    }
    if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) // the mark that spreadsheets put before UTF-8
    {
        line.erase(0, 3);
    }

    const RowReader reader(file, measure, fieldsOf(line));
    ResultsTable table{file, measure, {}, 0, reader.hasErrors()};
    while (nextLine(in, line, number))
    {
        const Fields fields = fieldsOf(line);
        reader.checkLength(fields, number);
        if (reader.isOk(fields))
        {
            table.variants.push_back(reader.read(fields, number));
        }
        else
        {
            ++table.leftOut;
        }
    }
    if (table.variants.empty())
    {
        throw InputError({"The table has no row to fit.",
            "0 rows, and " + std::to_string(table.leftOut) + " whose status is not ok",
            "rows of finished runs", file, "Run the study first, or see why its runs failed."});
    }
    return table;
}

ResultsTable readResults(const std::string& file, const std::string& measure)
{
    std::ifstream in(file);
    if (!in)
    {
        throw InputError({"The table cannot be opened.", "no readable file", "a CSV file", file,
            "Check the path."});
    }
    return readResults(in, file, measure);
}

} // namespace interstice
