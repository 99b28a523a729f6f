// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/RigidMotion.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace interstice::dem
{

namespace
{

Eigen::Vector3d vectorOf(const Vector3& v)
{
    return {v[0], v[1], v[2]};
}

Vector3 arrayOf(const Eigen::Vector3d& v)
{
    return {v[0], v[1], v[2]};
}

/// Columns: unit vectors along the first edge, in the plane across it, and along the normal.
Eigen::Matrix3d frameOf(const Triangle& triangle)
{
    const Eigen::Vector3d edge = vectorOf(triangle[1]) - vectorOf(triangle[0]);
    const Eigen::Vector3d other = vectorOf(triangle[2]) - vectorOf(triangle[0]);
    const Eigen::Vector3d along = edge.normalized();
    const Eigen::Vector3d normal = edge.cross(other).normalized();
    Eigen::Matrix3d frame;
    frame << along, normal.cross(along), normal;
    return frame;
}

/// From v1 - v0 = w x (a, 0, 0) and v2 - v0 = w x (b, c, 0) in the triangle's own frame.
Eigen::Vector3d spinOf(const Triangle& triangle, const Triangle& velocities)
{
    const Eigen::Matrix3d frame = frameOf(triangle);
    const auto local = [&frame](const Vector3& from, const Vector3& to) -> Eigen::Vector3d
    { return frame.transpose()*(vectorOf(to) - vectorOf(from)); };

    const double a = local(triangle[0], triangle[1])[0];
    const Eigen::Vector3d third = local(triangle[0], triangle[2]);
    const Eigen::Vector3d slipAlong = local(velocities[0], velocities[1]);
    const Eigen::Vector3d slipAcross = local(velocities[0], velocities[2]);

    const double aboutAcross = -slipAlong[2]/a;
    const double aboutNormal = slipAlong[1]/a;
    const double aboutAlong = (slipAcross[2] + third[0]*aboutAcross)/third[1];
    return frame*Eigen::Vector3d(aboutAlong, aboutAcross, aboutNormal);
}

} // namespace

bool congruent(const Triangle& a, const Triangle& b)
{
    for (int i = 0; i < 3; ++i)
    {
        const int j = (i + 1) % 3;
        const double one = (vectorOf(a[j]) - vectorOf(a[i])).norm();
        const double other = (vectorOf(b[j]) - vectorOf(b[i])).norm();
        if (std::abs(one - other) > 1e-6*one)
        {
            return false;
        }
    }
    return true;
}

double areaOf(const Triangle& triangle)
{
    const Eigen::Vector3d edge = vectorOf(triangle[1]) - vectorOf(triangle[0]);
    const Eigen::Vector3d other = vectorOf(triangle[2]) - vectorOf(triangle[0]);
    return 0.5*edge.cross(other).norm();
}

WallPose rigidMotion(const Triangle& before, const Triangle& now, const Triangle& velocities)
{
    // A wall at rest must be exactly where it was.
    const Eigen::Matrix3d rotation = before == now
        ? Eigen::Matrix3d::Identity()
        : Eigen::Matrix3d(frameOf(now)*frameOf(before).transpose());
    const Eigen::Vector3d translation = vectorOf(now[0]) - rotation*vectorOf(before[0]);
    const Eigen::Vector3d spin = spinOf(now, velocities);

    WallPose pose;
    for (int row = 0; row < 3; ++row)
    {
        for (int column = 0; column < 3; ++column)
        {
            pose.rotation[3*row + column] = rotation(row, column);
        }
    }
    pose.translation = arrayOf(translation);
    pose.angularVelocity = arrayOf(spin);
    pose.velocity = arrayOf(
        vectorOf(velocities[0]) + spin.cross(translation - vectorOf(now[0])));
    return pose;
}

} // namespace interstice::dem
