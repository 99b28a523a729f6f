// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/RigidMotion.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace interstice::dem
{

namespace
{

Vector3 arrayOf(const Eigen::Vector3d& v)
{
    return {v[0], v[1], v[2]};
}

} // namespace

// Nodes and velocities are made from a known motion, about an axis that lies askew to all edges.
TEST(RigidMotion, IsRecoveredFromOneTriangle)
{
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
    const Eigen::Vector3d translation(0.3, 0.1, -0.2);
    const Eigen::Vector3d velocity(1.5, -0.5, 2);
    const Eigen::Vector3d spin(4, 7, -3);

    Triangle before{};
    Triangle now{};
    Triangle velocities{};
    const Eigen::Vector3d nodes[3] = {{0.1, 0.2, 0.3}, {0.5, -0.1, 0.2}, {0.2, 0.6, -0.4}};
    for (int j = 0; j < 3; ++j)
    {
        const Eigen::Vector3d moved = rotation*nodes[j] + translation;
        before[j] = arrayOf(nodes[j]);
        now[j] = arrayOf(moved);
        velocities[j] = arrayOf(velocity + spin.cross(moved - translation));
    }

    const WallPose pose = rigidMotion(before, now, velocities);
    for (int k = 0; k < 3; ++k)
    {
        EXPECT_NEAR(pose.translation[k], translation[k], 1e-14);
        EXPECT_NEAR(pose.velocity[k], velocity[k], 1e-13);
        EXPECT_NEAR(pose.angularVelocity[k], spin[k], 1e-13);
        for (int l = 0; l < 3; ++l)
        {
            EXPECT_NEAR(pose.rotation[3*k + l], rotation(k, l), 1e-14);
        }
    }
}

// Half of 3 x 4.
TEST(RigidMotion, MeasuresATriangle)
{
    EXPECT_DOUBLE_EQ(areaOf({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}), 6);
}

} // namespace interstice::dem
