// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/CoarseGraining.hpp"
#include "coupling/laws/ImplicitDrag.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <utility>

using namespace interstice;
using namespace interstice::test;

// A grain falls from rest: drag law, coarse graining and implicit update together. The velocities
// come from a Runge-Kutta integration apart from this code; a step of 1e-6 s follows it to 1e-4.
namespace
{

struct Fall
{
    Powder powder;
    double gasVelocity; ///< Downwards.
    double gravity;
    double k;
};

double velocityAfter(double time, const std::string& law, const Fall& fall)
{
    const double timeStep = 1e-6;
    const std::unique_ptr<DragLaw> drag = makeDragLaw(law);
    const CoarseGraining parcels(fall.k);

    Powder parcel = fall.powder;
    parcel.diameter *= fall.k;
    const double volume =
        3.14159265358979323846 / 6 * parcel.diameter * parcel.diameter * parcel.diameter;
    const double mass = parcel.density * volume;
    const double weight = (parcel.density - parcel.gasDensity) * volume * fall.gravity;

    double velocity = 0;
    const int steps = static_cast<int>(time / timeStep + 0.5);
    for (int i = 0; i < steps; ++i)
    {
        const double slip = fall.gasVelocity - velocity;
        const LocalFlow flow = flowAround(parcel, 1, std::abs(slip));
        const ImplicitDrag push(parcels.parcelDragCoefficient(*drag, flow), mass, timeStep);
        velocity += (weight + push.force(slip, weight)) * timeStep / mass;
    }
    return velocity;
}

} // namespace

// The settling test of CFDEMcoupling: 100 um, 3000 kg/m3, in 10 kg/m3 and 1e-5 m2/s.
TEST(FallingGrain, FollowsTheCurvesOfTheSettlingTest)
{
    const Fall fall{{100e-6, 3000, 10, 1e-4}, 0, 9.81, 1};
    constexpr double times[]{0.01, 0.02, 0.05, 0.1, 0.2};
    const std::pair<const char*, std::array<double, 5>> curves[]{
        {"Stokes", {0.073523, 0.113874, 0.154842, 0.162551, 0.162954}},
        {"SchillerNaumann", {0.071654, 0.106809, 0.134424, 0.137281, 0.137337}},
        {"GidaspowHuilin", {0.071774, 0.107119, 0.135031, 0.137948, 0.138007}}};

    for (const auto& [law, velocities] : curves)
    {
        for (int i = 0; i < 5; ++i)
        {
            EXPECT_NEAR(velocityAfter(times[i], law, fall) / velocities[i], 1, 1e-4)
                << law << " at " << times[i];
        }
    }
}

// DEM06 of MFiX: 100 um, 2000 kg/m3, in an up-flow of 0.4 m/s.
TEST(FallingGrain, FollowsTheCurvesOfTheUpflowCase)
{
    const Fall fall{{100e-6, 2000, 1.2, 1.8e-5}, -0.4, 9.80665, 1};
    constexpr double table[][3]{{0.01, 0.012553, 0.012919}, {0.10, 0.052631, 0.054290},
        {0.20, 0.057010, 0.058841}, {0.35, 0.057393, 0.059241}};

    for (const auto& [time, sphere, blend] : table)
    {
        EXPECT_NEAR(velocityAfter(time, "SchillerNaumann", fall), sphere, 3e-6) << time;
        EXPECT_NEAR(velocityAfter(time, "GidaspowHuilin", fall), blend, 3e-6) << time;
    }
}

// 40 um, 7360 kg/m3, in still air, as a grain and as a parcel of a thousand.
TEST(FallingGrain, FallsAsAParcelLikeTheGrainsInIt)
{
    constexpr double table[][2]{{5e-3, 0.04577}, {10e-3, 0.08541}, {20e-3, 0.14893},
        {50e-3, 0.25422}, {100e-3, 0.30541}, {200e-3, 0.31697}};

    for (const double k : {1.0, 10.0})
    {
        const Fall fall{powderInAir(40e-6, 7360), 0, 9.81, k};
        for (const auto& [time, velocity] : table)
        {
            EXPECT_NEAR(velocityAfter(time, "GidaspowHuilin", fall) / velocity, 1, 2e-4)
                << "k = " << k << " at " << time;
        }
    }
}
