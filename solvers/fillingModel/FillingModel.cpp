// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingModel.hpp"

#include <algorithm>

namespace interstice
{

namespace
{

const char* pointName(PlaneOf kind)
{
    return kind == PlaneOf::criticalSize ? "series whose critical size is between two sizes"
                                         : "rows that are neither empty nor full";
}

} // namespace

void trustErrors(std::vector<PlanePoint>& points)
{
    for (PlanePoint& point : points)
    {
        point.fit.packings = 0;
    }
}

std::vector<std::string> groupNames(PlaneOf kind)
{
    if (kind == PlaneOf::criticalSize)
    {
        return {"N_v", "rho_p/rho_g"};
    }
    return {"d_p/h_D", "N_v", "rho_p/rho_g"};
}

std::vector<double> groupsOf(PlaneOf kind, const DieFilling& filling)
{
    if (kind == PlaneOf::criticalSize)
    {
        return {shoeReynolds(filling), densityRatio(filling)};
    }
    return {sizeRatio(filling), shoeReynolds(filling), densityRatio(filling)};
}

Plane fitPlane(PlaneOf kind, const std::vector<PlanePoint>& points, const std::string& where)
{
    std::vector<FitPoint> fitPoints;
    std::vector<DieFilling> fillings;
    for (const PlanePoint& point : points)
    {
        fitPoints.push_back(point.fit);
        fillings.push_back(point.filling);
    }

    Plane plane{leastSquares(fitPoints, groupNames(kind), pointName(kind), where), {}, 0};
    plane.range = rangeOf(fillings);
    for (const PlanePoint& point : points)
    {
        plane.largestError = std::max(plane.largestError, plane.fit.errorAt(point.fit.x));
    }
    return plane;
}

std::vector<PlanePoint> criticalPointsOf(const std::vector<CriticalSizeRatio>& critical)
{
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < critical.size(); ++i)
    {
        const CriticalSizeRatio& size = critical[i];
        if (size.crossing == Crossing::within)
        {
            points.push_back({{groupsOf(PlaneOf::criticalSize, size.filling), size.value,
                                  size.error, size.packings},
                size.filling, static_cast<int>(i)});
        }
    }
    return points;
}

std::vector<PlanePoint> ratioPointsOf(const std::vector<Series>& series)
{
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < series.size(); ++i)
    {
        for (const Variant& variant : series[i].variants)
        {
            if (variant.measure >= unsaturated.low && variant.measure <= unsaturated.high)
            {
                points.push_back({{groupsOf(PlaneOf::fillingRatio, variant.filling),
                                      variant.measure, variant.error, variant.packings},
                    variant.filling, static_cast<int>(i)});
            }
        }
    }
    return points;
}

FillingFit fitFillingModel(const ResultsTable& table, double threshold, Errors errors)
{
    FillingFit result{};
    result.series = seriesOf(table);
    for (const Series& series : result.series)
    {
        result.critical.push_back(criticalSizeRatio(series, threshold));
    }
    result.criticalPoints = criticalPointsOf(result.critical);
    result.ratioPoints = ratioPointsOf(result.series);
    if (errors == Errors::trusted)
    {
        trustErrors(result.criticalPoints);
        trustErrors(result.ratioPoints);
    }
    for (const Variant& variant : table.variants)
    {
        result.rowsBelow += variant.measure < unsaturated.low ? 1 : 0;
        result.rowsAbove += variant.measure > unsaturated.high ? 1 : 0;
    }

    FillingModel& model = result.model;
    model.table = table.file;
    model.measure = table.measure;
    model.threshold = threshold;
    model.criticalSize = fitPlane(PlaneOf::criticalSize, result.criticalPoints, table.file);
    std::copy_if(result.critical.begin(), result.critical.end(), std::back_inserter(model.series),
        [](const CriticalSizeRatio& size) { return size.crossing == Crossing::within; });
    try
    {
        model.fillingRatio = fitPlane(PlaneOf::fillingRatio, result.ratioPoints, table.file);
    }
    catch (const InputError& error)
    {
        result.whyNoFillingRatio = error.problem().rule + " (" + error.problem().found + ")";
    }
    return result;
}

} // namespace interstice
