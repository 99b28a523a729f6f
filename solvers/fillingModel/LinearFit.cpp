// SPDX-License-Identifier: GPL-3.0-or-later
#include "LinearFit.hpp"

#include "coupling/Laws.hpp"
#include "StudentT.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace interstice
{

namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

// x relative to their weighted mean, each column of length 1, and rows by the root of their weight.
// Centred, the constant is orthogonal to the rest, and round-off does not depend on the units.
struct ScaledColumns
{
    VectorXd mean;
    VectorXd length;
    MatrixXd x;
};

VectorXd withOne(const std::vector<double>& x)
{
    VectorXd row(x.size() + 1);
    row << 1, Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    return row;
}

void checkEnoughPoints(
    std::size_t points, std::size_t coefficients, const std::string& what, const std::string& where)
{
    if (points <= coefficients)
    {
        throw InputError({"There are too few " + what + " for a fit.",
            std::to_string(points) + " for " + std::to_string(coefficients) + " coefficients",
            "at least " + std::to_string(coefficients + 1), where,
            "Add runs to the table, between the ones it has."});
    }
}

InputError notVarying(const std::string& name, double value, const std::string& where)
{
    return InputError({"The points cannot tell the coefficients apart: " + name + " does not vary.",
        name + " is " + std::to_string(value) + " in every point", "at least two values of " + name,
        where, "Add runs with another " + name + "."});
}

// The kernel of the scaled columns tells which of them move only together.
InputError varyingTogether(
    const MatrixXd& x, const std::vector<std::string>& names, const std::string& where)
{
    const VectorXd kernel =
        Eigen::JacobiSVD<MatrixXd>(x, Eigen::ComputeFullV).matrixV().rightCols(1);
    std::string together;
    for (Eigen::Index i = 0; i < kernel.size(); ++i)
    {
        if (std::abs(kernel(i)) > 1e-3)
        {
            together += (together.empty() ? "" : " and ") + names[i];
        }
    }
    return InputError(
        {"The points cannot tell the coefficients apart: " + together + " vary only together.",
            "all points on one line or plane", "points that vary one of them and not the other",
            where, "Add runs that change one of them alone."});
}

ScaledColumns scaled(const MatrixXd& x, const VectorXd& weights,
    const std::vector<std::string>& names, const std::string& where)
{
    constexpr double roundOff = 1e-9;

    ScaledColumns columns;
    columns.mean = x.transpose() * weights / weights.sum();
    columns.x = weights.cwiseSqrt().asDiagonal() * (x.rowwise() - columns.mean.transpose());
    columns.length = columns.x.colwise().norm().transpose();
    for (Eigen::Index i = 0; i < x.cols(); ++i)
    {
        const double width = x.col(i).maxCoeff() - x.col(i).minCoeff();
        if (width <= roundOff * x.col(i).cwiseAbs().maxCoeff())
        {
            throw notVarying(names[i], x(0, i), where);
        }
    }
    columns.x = columns.x * columns.length.cwiseInverse().asDiagonal();
    return columns;
}

// Inverse of the normal matrix of (1, x) from that of the centred slopes.
MatrixXd withConstant(const MatrixXd& slopes, const VectorXd& mean, double sumOfWeights)
{
    const Eigen::Index k = mean.size();
    MatrixXd whole(k + 1, k + 1);
    whole(0, 0) = 1 / sumOfWeights + mean.dot(slopes * mean);
    whole.block(1, 0, k, 1) = -slopes * mean;
    whole.block(0, 1, 1, k) = whole.block(1, 0, k, 1).transpose();
    whole.block(1, 1, k, k) = slopes;
    return whole;
}

} // namespace

double LinearFit::quantile() const
{
    return studentTQuantile(0.975, degreesOfFreedom());
}

double LinearFit::standardError(int coefficient) const
{
    return std::sqrt(covariance(coefficient, coefficient));
}

double LinearFit::at(const std::vector<double>& x) const
{
    return withOne(x).dot(coefficients);
}

double LinearFit::errorAt(const std::vector<double>& x) const
{
    const VectorXd row = withOne(x);
    return std::sqrt(std::max(row.dot(covariance * row), 0.0));
}

Interval LinearFit::confidence(const std::vector<double>& x) const
{
    const double half = quantile() * errorAt(x);
    return {at(x) - half, at(x) + half};
}

Interval LinearFit::prediction(const std::vector<double>& x) const
{
    const double half = quantile() * std::hypot(errorAt(x), scatter);
    return {at(x) - half, at(x) + half};
}

bool weightsKnown(const std::vector<FitPoint>& points)
{
    return std::all_of(points.begin(), points.end(),
        [](const FitPoint& point)
        {
            return point.error.value_or(0) > 0
                   && (point.packings == 0 || point.packings >= fewestPackingsForWeights);
        });
}

LinearFit leastSquares(const std::vector<FitPoint>& points, const std::vector<std::string>& names,
    const std::string& what, const std::string& where)
{
    const auto n = static_cast<Eigen::Index>(points.size());
    const auto k = static_cast<Eigen::Index>(names.size());
    checkEnoughPoints(points.size(), names.size() + 1, what, where);

    const bool weighted = weightsKnown(points);
    MatrixXd x(n, k);
    VectorXd y(n);
    VectorXd weights(n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        x.row(i) = Eigen::Map<const VectorXd>(points[i].x.data(), k).transpose();
        y(i) = points[i].y;
        weights(i) = weighted ? 1 / (*points[i].error * *points[i].error) : 1;
    }

    const ScaledColumns columns = scaled(x, weights, names, where);
    Eigen::ColPivHouseholderQR<MatrixXd> qr(columns.x);
    qr.setThreshold(1e-7);
    if (qr.rank() < k)
    {
        throw varyingTogether(columns.x, names, where);
    }

    const double yMean = y.dot(weights) / weights.sum();
    const VectorXd yScaled = weights.cwiseSqrt().cwiseProduct(y - VectorXd::Constant(n, yMean));
    const VectorXd slopes = qr.solve(yScaled).cwiseQuotient(columns.length);

    const MatrixXd inverseR =
        qr.matrixR().topRows(k).triangularView<Eigen::Upper>().solve(MatrixXd::Identity(k, k));
    const MatrixXd root =
        columns.length.cwiseInverse().asDiagonal() * (qr.colsPermutation() * inverseR);

    LinearFit fit;
    fit.names = names;
    fit.points = static_cast<int>(n);
    fit.weighted = weighted;
    fit.coefficients.resize(k + 1);
    fit.coefficients << yMean - slopes.dot(columns.mean), slopes;

    const double squares =
        (yScaled - columns.x * slopes.cwiseProduct(columns.length)).squaredNorm();
    const double total = yScaled.squaredNorm();
    fit.rSquared = total > 0 ? 1 - squares / total : 0;
    fit.chiSquare = squares / fit.degreesOfFreedom();
    fit.scatter = std::sqrt(fit.chiSquare * static_cast<double>(n) / weights.sum());
    fit.covariance =
        fit.chiSquare * withConstant(root * root.transpose(), columns.mean, weights.sum());
    return fit;
}

} // namespace interstice
