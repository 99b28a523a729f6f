// SPDX-License-Identifier: GPL-3.0-or-later
#include "PublishedModel.hpp"

namespace interstice
{

std::array<double, 3> publishedCoefficients()
{
    // Far apart, as a difference of large numbers has fewer digits lost in it.
    constexpr double far = 1e6;
    const auto at = [](double shoe, double density) {
        return sizeRatioFor90Percent({1, density, 1, 1, 9.81, shoe, 1, 1});
    };

    const double constant = at(0, 0);
    return {constant, (at(far, 0) - constant) / far, (at(0, far) - constant) / far};
}

std::vector<PublishedSeries> seriesInPublishedRange(const FillingModel& model)
{
    const LinearFit& fit = model.criticalSize.fit;
    std::vector<PublishedSeries> inRange;
    for (const CriticalSizeRatio& size : model.series)
    {
        if (outsideFillingModel(size.filling).empty())
        {
            inRange.push_back({size, fit.at(groupsOf(PlaneOf::criticalSize, size.filling)),
                sizeRatioFor90Percent(size.filling), size.error.value_or(fit.scatter)});
        }
    }
    return inRange;
}

} // namespace interstice
