// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FillingModel.hpp"
#include "Inversion.hpp"
#include "LeaveOut.hpp"

#include <string>
#include <vector>

namespace interstice
{

/// What the commands print: tables of plain text, one function each. Sizes are in um.

/// How many rows and series there are, and what was left out.
std::string tableReport(const ResultsTable& table, const FillingFit& fit);

/// A line a series: its groups and its critical size, or on which side of its sizes that is.
std::string seriesReport(const FillingFit& fit);

/// Coefficients with standard error and 95 % interval, R^2, scatter, covariance and range.
std::string planeReport(PlaneOf kind, const Plane& plane);

/// A line a point: measured, fitted, residual. Of `kind` only.
std::string residualReport(PlaneOf kind, const Plane& plane, const std::vector<PlanePoint>& points);

/// A line a point left out: measured, predicted, how many combined standard errors lie between.
std::string leaveOutReport(PlaneOf kind, const LeaveOutCheck& check);

/// Our coefficients beside those of Eq 21, and critical sizes by both.
std::string publishedReport(const FillingModel& model);

/// The critical size of a die filling, or its filling ratio where `withSize` says that it has a size.
std::string predictionReport(const FillingModel& model, const DieFilling& filling, bool withSize);

/// The limit, its direction and interval.
std::string limitReport(const FillingModel& model, Sought sought, const Limit& limit);

/// The conditions of a prediction, one parameter a line; `unknown` is left out.
std::string conditionsReport(const DieFilling& filling, double DieFilling::*unknown);

} // namespace interstice
