// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace interstice
{

/// From low to high, both included.
struct Interval
{
    double low;
    double high;
};

/// One measured value y at the place x, with its standard error where that is known.
struct FitPoint
{
    std::vector<double> x;
    double y;
    std::optional<double> error;
    int packings = 0; ///< How many repetitions the error was estimated from; 0: it is exact.
};

/// Errors from fewer packings are no weights. Such an error is itself uncertain, and points whose
/// error came out too small by chance draw the plane: of intervals for 95 %, 80 % hold the truth at
/// 2 packings, 89 % at 3, 92 % at 5, 94 % at 10. Without weights, 95 % do at any number, and the
/// intervals are hardly wider.
constexpr int fewestPackingsForWeights = 10;

/// A plane y = b_0 + b_1 x_1 + ... + b_k x_k through points that scatter, and how well it is known.
///
///     b        minimises  S = sum w_i (y_i - yhat_i)^2
///     w_i      1/error_i^2 if weightsKnown, otherwise 1
///     chi2     S/(n - k - 1)
///     cov(b)   chi2 (X^T W X)^-1
///     R^2      1 - S/sum w_i (y_i - ybar)^2,  ybar the weighted mean
///     scatter  sqrt(chi2 n/sum w_i), the standard deviation of a point about the plane
///
/// The covariance is scaled by chi2, so that only the ratios of the errors count: what the plane
/// itself misses is in the intervals as well. They are at 95 %, by Student's t for n - k - 1.
///
/// N.R. Draper & H. Smith, Applied Regression Analysis, 3rd ed., Wiley (1998), chapters 5 and 9.
struct LinearFit
{
    std::vector<std::string> names; ///< Of x_1 ... x_k.
    Eigen::VectorXd coefficients; ///< b_0 ... b_k
    Eigen::MatrixXd covariance; ///< Of the coefficients.
    int points; ///< n
    bool weighted; ///< By the errors of the points.
    double rSquared; ///< Zero where all values are the same.
    double chiSquare; ///< chi2 above: about 1 if weighted and the errors explain the scatter.
    double scatter; ///< In units of y.

    int degreesOfFreedom() const { return points - static_cast<int>(coefficients.size()); }

    /// Student's t that 97.5 % stay below.
    double quantile() const;

    double standardError(int coefficient) const;

    /// The plane at x, and its standard error there.
    double at(const std::vector<double>& x) const;
    double errorAt(const std::vector<double>& x) const;

    /// Where the plane itself lies at x.
    Interval confidence(const std::vector<double>& x) const;

    /// Where one more measured point at x will lie: the scatter of a point comes on top.
    Interval prediction(const std::vector<double>& x) const;
};

/// Fits the plane, by QR with column pivoting of the centred and scaled x.
///
/// Throws InputError if there are no more points than coefficients, or if the points cannot tell the
/// coefficients apart: names the x that does not vary, or those that vary only together.
///
/// @param what  one point in words, for the message: "series whose critical size is known"
/// @param where the file the points are from
LinearFit leastSquares(const std::vector<FitPoint>& points, const std::vector<std::string>& names,
    const std::string& what, const std::string& where);

/// True if the fit to these points is weighted: every error is known, positive, and exact or from
/// enough packings.
bool weightsKnown(const std::vector<FitPoint>& points);

} // namespace interstice
