// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace interstice
{

/// Where a rigid body is now, relative to its reference place, and how it moves.
///
///     x_now = rotation x_reference + translation
///     v(x)  = velocity + angularVelocity x (x - translation)
struct RigidPose
{
    using Vector = std::array<double, 3>;

    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1}; ///< row by row [-]
    Vector translation{}; ///< [m]
    Vector velocity{}; ///< [m/s]
    Vector angularVelocity{}; ///< [1/s]

    /// Velocity [m/s] of the body's material at a point [m].
    Vector velocityAt(const Vector& point) const
    {
        const Vector r{
            point[0] - translation[0], point[1] - translation[1], point[2] - translation[2]};
        const Vector& w = angularVelocity;
        return {velocity[0] + w[1] * r[2] - w[2] * r[1], velocity[1] + w[2] * r[0] - w[0] * r[2],
            velocity[2] + w[0] * r[1] - w[1] * r[0]};
    }

    /// Where a point [m] of now lay in the reference place.
    Vector toReference(const Vector& point) const
    {
        const Vector r{
            point[0] - translation[0], point[1] - translation[1], point[2] - translation[2]};
        const std::array<double, 9>& q = rotation;
        return {q[0] * r[0] + q[3] * r[1] + q[6] * r[2], q[1] * r[0] + q[4] * r[1] + q[7] * r[2],
            q[2] * r[0] + q[5] * r[1] + q[8] * r[2]};
    }

    /// Where a point [m] of the reference place is now.
    Vector fromReference(const Vector& point) const
    {
        const std::array<double, 9>& q = rotation;
        return {q[0] * point[0] + q[1] * point[1] + q[2] * point[2] + translation[0],
            q[3] * point[0] + q[4] * point[1] + q[5] * point[2] + translation[1],
            q[6] * point[0] + q[7] * point[1] + q[8] * point[2] + translation[2]};
    }
};

} // namespace interstice
