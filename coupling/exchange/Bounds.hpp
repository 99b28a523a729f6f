// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

namespace interstice
{

using Vec3 = std::array<double, 3>;

/// An axis-aligned box [m]; empty until a point is added.
struct Bounds
{
    Vec3 min{huge, huge, huge};
    Vec3 max{-huge, -huge, -huge};

    void add(const Vec3& point)
    {
        for (int d = 0; d < 3; ++d)
        {
            min[d] = std::min(min[d], point[d]);
            max[d] = std::max(max[d], point[d]);
        }
    }

    void grow(double distance)
    {
        for (int d = 0; d < 3; ++d)
        {
            min[d] -= distance;
            max[d] += distance;
        }
    }

    bool contains(const Vec3& point) const
    {
        for (int d = 0; d < 3; ++d)
        {
            // Written so that a coordinate that is not a number is outside.
            if (!(point[d] >= min[d] && point[d] <= max[d]))
            {
                return false;
            }
        }
        return true;
    }

private:
    static constexpr double huge = std::numeric_limits<double>::max();
};

} // namespace interstice
