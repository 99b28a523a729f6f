// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FillingModel.hpp"

#include <string>

namespace interstice
{

/// The filling model as a JSON file, numbers to the last bit.
///
///     format, formatVersion    "interstice filling model", 1; another version is refused
///     program                  version of the program that wrote it
///     table, measure, threshold
///     criticalSize             a plane
///     fillingRatio             a plane, or null
///     series                   d_p/h_D critical, its error or null, and its parameters in SI units
///
/// A plane has names, coefficients and covariance (constant first), points, weighted, rSquared,
/// chiSquare, scatter, largestError and range: smallest and largest of each group, L_D and h_D.

/// Writes the file, beside and renamed, so that no torn one stays. Throws InputError if it cannot.
void writeModel(const FillingModel& model, const std::string& file);

/// Reads it. Throws InputError for a file that is missing, torn, of another kind or version, or whose
/// numbers are no model.
FillingModel readModel(const std::string& file);

} // namespace interstice
