// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Parameters.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace interstice
{

/// One row of a table of runs: a variant, averaged over its packings.
struct Variant
{
    DieFilling filling;
    double measure; ///< Filling ratio, as a fraction.
    std::optional<double> error; ///< Standard error of the measure, where known.
    int packings; ///< Zero where the table does not say.
    int line; ///< Of the file; the header is line 1.
};

/// A table of runs, as CSV (RFC 4180, without line breaks inside a field).
///
/// Columns in any order: the names of `parameters`, in SI units; the measure; and, if there are such,
/// `<measure>.error`, `packings` and `status`. All others are ignored. Rows whose status is not `ok`
/// are left out. Empty lines and lines that begin with # are skipped.
struct ResultsTable
{
    std::string file;
    std::string measure;
    std::vector<Variant> variants;
    int leftOut; ///< Rows whose status is not ok.
    bool hasErrors; ///< There is a column of standard errors.
};

/// Reads a table.
///
/// Throws InputError for a file that cannot be opened, a missing column (with the nearest name that
/// exists), a row of another length than the header, a value that is no finite number, a parameter
/// or error below zero, a measure that looks like per cent, and a table without a row.
ResultsTable readResults(const std::string& file, const std::string& measure);

/// The same from a stream; `file` is for messages.
ResultsTable readResults(std::istream& in, const std::string& file, const std::string& measure);

/// The number that the whole of a text spells, without regard to the locale; empty if it spells none
/// or one that is not finite. A sign and spaces around are allowed.
std::optional<double> finiteNumber(const std::string& text);

} // namespace interstice
