// SPDX-License-Identifier: GPL-3.0-or-later
#include "Report.hpp"

#include "Text.hpp"

#include <cmath>

namespace interstice
{

namespace
{

constexpr double um = 1e6;

std::string lineOfSeries(int number, const CriticalSizeRatio& size, std::size_t sizes)
{
    const double h = size.filling.dieDepth;
    std::string line = formatted("%6d%10.3f%13.2f%9.3f%7zu  ", number + 1,
        shoeReynolds(size.filling), densityRatio(size.filling), size.filling.dieLength / h, sizes);
    if (size.crossing == Crossing::within)
    {
        line += formatted("%11.6f", size.value);
        line += size.error ? formatted(" +- %-9.6f", *size.error) : "            ? ";
        line += formatted("%10.2f", um * size.value * h);
    }
    else
    {
        const char* const side = size.crossing == Crossing::above ? "above" : "below";
        line += formatted("%5s %.6f             %s%7.2f", side, size.value,
            size.crossing == Crossing::above ? ">" : "<", um * size.value * h);
    }
    if (size.falls > 0)
    {
        line += formatted("   falls below the threshold again %s",
            size.falls == 1 ? "once" : (std::to_string(size.falls) + " times").c_str());
    }
    return line + "\n";
}

std::string coefficientLine(const LinearFit& fit, int i)
{
    const std::string name = i == 0 ? "constant" : fit.names[i - 1];
    const double half = fit.quantile() * fit.standardError(i);
    return formatted("    %-12s%15.6g%13.2g%15.5g to %.5g%s\n", name.c_str(), fit.coefficients(i),
        fit.standardError(i), fit.coefficients(i) - half, fit.coefficients(i) + half,
        std::abs(fit.coefficients(i)) < half ? "   not told from zero" : "");
}

std::string covarianceReport(const LinearFit& fit)
{
    std::string text = "    covariance\n";
    for (Eigen::Index i = 0; i < fit.covariance.rows(); ++i)
    {
        text += "    ";
        for (Eigen::Index j = 0; j < fit.covariance.cols(); ++j)
        {
            text += formatted("%14.4g", fit.covariance(i, j));
        }
        text += "\n";
    }
    return text;
}

std::string rangeReport(const Plane& plane)
{
    std::string text = "    range of the points\n";
    for (std::size_t i = 0; i < rangedCount; ++i)
    {
        text += formatted("    %-12s%12.6g to %.6g%s%s\n", rangedQuantities[i].name,
            plane.range[i].low, plane.range[i].high, *rangedQuantities[i].unit ? " " : "",
            rangedQuantities[i].unit);
    }
    return text;
}

} // namespace

std::string tableReport(const ResultsTable& table, const FillingFit& fit)
{
    int errors = 0;
    int packings = 0;
    for (const Variant& variant : table.variants)
    {
        errors += variant.error ? 1 : 0;
        packings += variant.packings;
    }

    std::string text = "Table " + table.file + ", measure " + table.measure + "\n";
    text += formatted("    %zu variants", table.variants.size());
    text += packings > 0 ? formatted(" of %d packings", packings) : "";
    text += formatted(" in %zu series; left out, as their status is not ok: %d\n",
        fit.series.size(), table.leftOut);
    if (!table.hasErrors)
    {
        return text + "    no column " + table.measure + ".error: the fits are not weighted\n";
    }
    return text + formatted("    of a known standard error: %d\n", errors);
}

std::string seriesReport(const FillingFit& fit)
{
    std::string text = formatted(
        "Critical size, at which %g %% of the die is filled\n", 100 * fit.model.threshold);
    text += "series       N_v  rho_p/rho_g  L_D/h_D  sizes     (d_p/h_D)_crit           d_p [um]\n";
    int censored = 0;
    for (std::size_t i = 0; i < fit.critical.size(); ++i)
    {
        text += lineOfSeries(static_cast<int>(i), fit.critical[i], fit.series[i].variants.size());
        censored += fit.critical[i].crossing == Crossing::within ? 0 : 1;
    }
    return text
           + formatted("    not in the fit, as the threshold is outside their sizes: %d series\n",
               censored);
}

std::string planeReport(PlaneOf kind, const Plane& plane)
{
    const LinearFit& fit = plane.fit;
    std::string text =
        kind == PlaneOf::criticalSize
            ? "(d_p/h_D)_crit = a + b N_v + c rho_p/rho_g,  N_v = v rho_g L_D/mu_g\n"
            : formatted(
                "filling ratio = s0 + s1 d_p/h_D + s2 N_v + s3 rho_p/rho_g, from %g to %g\n",
                unsaturated.low, unsaturated.high);
    text += "                    coefficient   std. error   95 % interval\n";
    for (int i = 0; i < fit.coefficients.size(); ++i)
    {
        text += coefficientLine(fit, i);
    }
    text += formatted("    R^2 %.4f, scatter of a point %.3g, %d points, %d degrees of freedom "
                      "(t %.3f)\n",
        fit.rSquared, fit.scatter, fit.points, fit.degreesOfFreedom(), fit.quantile());
    text +=
        fit.weighted
            ? formatted("    weighted by the standard errors; chi^2 by degrees of freedom %.3g: "
                        "the scatter is %.2g times what they explain\n",
                fit.chiSquare, std::sqrt(fit.chiSquare))
            : formatted("    not weighted: not every standard error is known, positive and from %d "
                        "packings or more\n",
                fewestPackingsForWeights);
    return text + covarianceReport(fit) + rangeReport(plane);
}

std::string residualReport(PlaneOf kind, const Plane& plane, const std::vector<PlanePoint>& points)
{
    const bool ratio = kind == PlaneOf::fillingRatio;
    std::string text = "Residuals\nseries    d_p [um]     measured       fitted     residual\n";
    for (const PlanePoint& point : points)
    {
        const double fitted = plane.fit.at(point.fit.x);
        text += formatted(ratio ? "%6d%12.2f%13.4f%13.4f%13.4f\n" : "%6d%12.2f%13.6f%13.6f%13.6f\n",
            point.series + 1, um * point.filling.particleDiameter, point.fit.y, fitted,
            point.fit.y - fitted);
    }
    return text;
}

std::string leaveOutReport(PlaneOf kind, const LeaveOutCheck& check)
{
    const bool ratio = kind == PlaneOf::fillingRatio;
    std::string text = ratio ? "Left out: filling ratio\n" : "Left out: (d_p/h_D)_crit\n";
    text += "series       N_v  rho_p/rho_g    d_p [um]   measured  predicted  combined error"
            "  in errors\n";
    for (const LeftOutPoint& left : check.points)
    {
        const DieFilling& filling = left.point.filling;
        text += formatted("%6d%10.3f%13.2f%12.2f%11.6f%11.6f%16.6f%11.2f%s\n",
            left.point.series + 1, shoeReynolds(filling), densityRatio(filling),
            um * filling.particleDiameter, left.point.fit.y, left.predicted, left.combinedError,
            left.deviation(), left.inRange ? "" : "   out of range, not counted");
    }
    for (const int number : check.needed)
    {
        text += formatted(
            "%6d    cannot be left out: the rest does not vary every group\n", number + 1);
    }
    return text
           + formatted("    %d of %d are within 2 combined standard errors\n", check.within(2),
               check.judged());
}

} // namespace interstice
