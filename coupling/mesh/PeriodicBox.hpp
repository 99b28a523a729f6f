// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "polyMesh.H"
#include "vector.H"

namespace interstice
{

/// The translations under which a mesh with cyclic patches repeats itself.
///
/// Only translations along the axes are known; a rotational or oblique cyclic is refused.
class PeriodicBox
{
public:
    /// Collective. Reads the separations of the cyclic patches (also when decomposed).
    explicit PeriodicBox(const Foam::polyMesh& mesh);

    /// The image of a point [m] inside the box.
    Foam::vector wrap(Foam::vector point) const
    {
        for (int d = 0; d < 3; ++d)
        {
            if (period_[d] > 0)
            {
                point[d] -= period_[d]*std::floor((point[d] - min_[d])/period_[d]);
            }
        }
        return point;
    }

    /// The shortest image of a distance [m] along axis d.
    double nearest(double distance, int d) const
    {
        const bool far = period_[d] > 0 && std::abs(distance) > 0.5*period_[d];
        return far ? distance - period_[d]*std::round(distance/period_[d]) : distance;
    }

    /// The same of each of its components.
    Foam::vector nearest(const Foam::vector& distance) const
    {
        return {nearest(distance.x(), 0), nearest(distance.y(), 1), nearest(distance.z(), 2)};
    }

    /// Length of one period along each axis [m]; zero: not periodic.
    const Foam::vector& period() const { return period_; }

private:
    Foam::vector min_;
    Foam::vector period_;
};

} // namespace interstice
