// SPDX-License-Identifier: GPL-3.0-or-later
#include "LeaveOut.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace interstice
{

namespace
{

LeftOutPoint judge(const Plane& plane, const PlanePoint& point, bool inRange)
{
    return {point, plane.fit.at(point.fit.x), combinedError(plane.fit, point.fit), inRange};
}

} // namespace

int LeaveOutCheck::judged() const
{
    return static_cast<int>(std::count_if(
        points.begin(), points.end(), [](const LeftOutPoint& point) { return point.inRange; }));
}

int LeaveOutCheck::within(double errors) const
{
    return static_cast<int>(std::count_if(points.begin(), points.end(),
        [&](const LeftOutPoint& point)
        { return point.inRange && std::abs(point.deviation()) <= errors; }));
}

double combinedError(const LinearFit& fit, const FitPoint& point)
{
    const bool ownError = fit.weighted && point.error;
    const double measured =
        ownError ? std::sqrt(std::max(1.0, fit.chiSquare)) * *point.error : fit.scatter;
    return std::hypot(fit.errorAt(point.x), measured);
}

LeaveOutCheck leaveOutEach(
    PlaneOf kind, const std::vector<PlanePoint>& points, const std::string& where)
{
    std::set<int> numbers;
    for (const PlanePoint& point : points)
    {
        numbers.insert(point.series);
    }

    LeaveOutCheck check;
    for (const int number : numbers)
    {
        std::vector<PlanePoint> rest;
        std::copy_if(points.begin(), points.end(), std::back_inserter(rest),
            [&](const PlanePoint& point) { return point.series != number; });
        try
        {
            const Plane plane = fitPlane(kind, rest, where);
            for (const PlanePoint& point : points)
            {
                if (point.series == number)
                {
                    check.points.push_back(judge(plane, point, true));
                }
            }
        }
        catch (const InputError&)
        {
            check.needed.push_back(number);
        }
    }
    if (check.points.empty())
    {
        throw InputError({"No series can be left out: the fit needs every one.",
            std::to_string(numbers.size()) + " series",
            "at least " + std::to_string(groupNames(kind).size() + 3) + ", spread over all groups",
            where, "Add series to the table, or check on another table: --leaveOut FILE.csv"});
    }
    return check;
}

LeaveOutCheck leaveOutTable(PlaneOf kind, const Plane& plane, const std::vector<PlanePoint>& points)
{
    const SizeIs size = kind == PlaneOf::fillingRatio ? SizeIs::given : SizeIs::answer;
    LeaveOutCheck check;
    for (const PlanePoint& point : points)
    {
        check.points.push_back(
            judge(plane, point, outsideRange(plane.range, point.filling, size).empty()));
    }
    return check;
}

} // namespace interstice
