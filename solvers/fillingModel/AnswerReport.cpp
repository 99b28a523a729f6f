// SPDX-License-Identifier: GPL-3.0-or-later
#include "Parameters.hpp"
#include "PublishedModel.hpp"
#include "Report.hpp"
#include "Text.hpp"

#include <algorithm>
#include <cmath>

namespace interstice
{

namespace
{

constexpr double um = 1e6;

// A point may be inside the range of each group and yet far from all points, in an empty corner.
std::string distanceNote(const Plane& plane, const std::vector<double>& groups)
{
    const double error = plane.fit.errorAt(groups);
    if (error <= plane.largestError * (1 + 1e-6))
    {
        return "";
    }
    return formatted("    note: further off than any point of the fit: standard error of the plane "
                     "%.2g here, at most %.2g there\n",
        error, plane.largestError);
}

std::string criticalSizeReport(const FillingModel& model, const DieFilling& filling)
{
    const LinearFit& fit = model.criticalSize.fit;
    const std::vector<double> groups = groupsOf(PlaneOf::criticalSize, filling);
    const double h = um * filling.dieDepth;
    const Interval mean = fit.confidence(groups);
    const Interval single = fit.prediction(groups);

    const int percent = static_cast<int>(std::lround(100 * model.threshold));
    std::string text = formatted("    d_%d           %10.2f um    (d_p/h_D)_crit %.6f\n", percent,
        h * fit.at(groups), fit.at(groups));
    text += formatted(
        "    95 %% interval %10.2f to %.2f um, of the plane\n", h * mean.low, h * mean.high);
    text += formatted("                  %10.2f to %.2f um, of one more series of runs\n",
        h * single.low, h * single.high);
    return text + distanceNote(model.criticalSize, groups);
}

std::string fullnessReport(const FillingModel& model, const DieFilling& filling)
{
    const Interval size =
        model.criticalSize.fit.confidence(groupsOf(PlaneOf::criticalSize, filling));
    const double critical = (size.low + size.high) / 2;
    const double given = sizeRatio(filling);
    const bool certain = given < size.low || given >= size.high;
    return formatted("    counts as full %s: d_p is %s the critical size%s\n",
        given >= critical ? "yes" : "no", given >= critical ? "at or above" : "below",
        certain ? "" : ", but within its 95 % interval: not certain");
}

std::string ratioReport(const FillingModel& model, const DieFilling& filling)
{
    if (!model.fillingRatio)
    {
        return "    filling ratio  unknown: the model has no plane for it\n";
    }
    const LinearFit& fit = model.fillingRatio->fit;
    const std::vector<double> groups = groupsOf(PlaneOf::fillingRatio, filling);
    const double plane = fit.at(groups);
    const Interval single = fit.prediction(groups);
    const auto bounded = [](double ratio) { return std::clamp(ratio, 0.0, 1.0); };

    std::string text = formatted("    filling ratio  %10.3f\n", bounded(plane));
    text += formatted("    95 %% interval %10.3f to %.3f, of one more run\n", bounded(single.low),
        bounded(single.high));
    if (plane > unsaturated.high || plane < unsaturated.low)
    {
        text += formatted("    note: the plane gives %.3f, and is fitted from %g to %g only\n",
            plane, unsaturated.low, unsaturated.high);
    }
    return text + distanceNote(*model.fillingRatio, groups);
}

std::string coefficientsBeside(const LinearFit& fit)
{
    const std::array<double, 3> published = publishedCoefficients();
    std::string text = "                         ours  +- 95 %             Eq 21   difference  "
                       "in std. errors\n";
    for (int i = 0; i < 3; ++i)
    {
        const double error = fit.standardError(i);
        const double difference = fit.coefficients(i) - published[i];
        text += formatted("    %-12s%13.6g  %-12.3g%13.6g%13.3g%16.2f\n",
            i == 0 ? "constant" : fit.names[i - 1].c_str(), fit.coefficients(i),
            fit.quantile() * error, published[i], difference, error > 0 ? difference / error : 0);
    }
    return text;
}

std::string seriesBeside(const FillingModel& model)
{
    const std::vector<PublishedSeries> series = seriesInPublishedRange(model);
    std::string text = formatted("    %zu of %zu series are in the range of Eq 21, die and air "
                                 "included\n",
        series.size(), model.series.size());
    if (series.empty())
    {
        return text;
    }

    text += "       N_v  rho_p/rho_g   d_90 [um]: measured  our plane   Eq 21  measured - Eq 21   "
            "error  in errors\n";
    for (const PublishedSeries& one : series)
    {
        const DieFilling& filling = one.measured.filling;
        const double h = um * filling.dieDepth;
        const double difference = one.measured.value - one.published;
        text += formatted("%10.3f%13.2f%22.2f%11.2f%8.2f%10.2f%7.1f %%%8.2f%11.2f\n",
            shoeReynolds(filling), densityRatio(filling), h * one.measured.value, h * one.fitted,
            h * one.published, h * difference, 100 * difference / one.published, h * one.error,
            one.error > 0 ? difference / one.error : 0);
    }
    return text;
}

std::string bound(const std::optional<double>& value, double scale)
{
    return value ? formatted("%.5g", scale * *value) : "no limit";
}

} // namespace

std::string publishedReport(const FillingModel& model)
{
    std::string text = "Beside the published model, Eq 21 of Materials 18(14) (2025) 3261\n";
    if (std::abs(model.threshold - publishedThreshold) > 1e-9)
    {
        text += formatted("    beware: the model is for a threshold of %g, Eq 21 for %g\n",
            model.threshold, publishedThreshold);
    }
    return text + coefficientsBeside(model.criticalSize.fit) + seriesBeside(model);
}

std::string predictionReport(const FillingModel& model, const DieFilling& filling, bool withSize)
{
    std::string text = formatted("    N_v            %10.3f\n    rho_p/rho_g    %10.2f\n",
        shoeReynolds(filling), densityRatio(filling));
    if (withSize)
    {
        text += formatted("    d_p/h_D        %10.6f\n", sizeRatio(filling));
        text += ratioReport(model, filling) + fullnessReport(model, filling);
    }
    return text + criticalSizeReport(model, filling);
}

std::string limitReport(const FillingModel& model, Sought sought, const Limit& limit)
{
    const char* const what[]{"shoe speed", "particle diameter", "die depth"};
    const char* const most = sought == Sought::dieDepth ? "deepest" : "largest";
    const bool length = sought != Sought::shoeSpeed;
    const double scale = length ? um : 1;
    const char* const unit = length ? "um" : "m/s";

    std::string text = formatted("The %s %s that fills %g %% of the die\n",
        limit.largest ? most : "smallest", what[static_cast<int>(sought)], 100 * model.threshold);
    text += formatted("    %-17s%10.5g %s\n", nameOf(sought), scale * limit.value, unit);
    text += limit.low || limit.high
                ? "    95 % interval    " + bound(limit.low, scale) + " to "
                      + bound(limit.high, scale) + " " + unit + ", of the plane\n"
                : "    95 % interval    no limits: the fit does not tell the effect of the shoe "
                  "speed from zero\n";
    text += formatted("    The die is full at this %s and %s it.\n", what[static_cast<int>(sought)],
        limit.largest ? "below" : "above");
    return text + distanceNote(model.criticalSize, groupsOf(PlaneOf::criticalSize, limit.filling));
}

std::string conditionsReport(const DieFilling& filling, double DieFilling::*unknown)
{
    std::string text;
    for (const Parameter& parameter : parameters)
    {
        if (parameter.value != unknown)
        {
            text += formatted(
                "    %-17s%10.5g %s\n", parameter.name, filling.*parameter.value, parameter.unit);
        }
    }
    return text;
}

} // namespace interstice
