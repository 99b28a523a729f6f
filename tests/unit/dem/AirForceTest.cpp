// SPDX-License-Identifier: GPL-3.0-or-later
#include "DemScene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace interstice::test
{

namespace
{

constexpr double dt = 1e-5;                  // of cloud.in
constexpr double mass = 8.37758040957278e-5; // 4 mm, 2500 kg/m3

std::unique_ptr<DemEngine> cloud(const std::map<std::string, std::string>& variables = {})
{
    auto dem = std::make_unique<DemEngine>(MPI_COMM_WORLD, optionsFor(variables));
    dem->runScript(script("cloud.in"));
    dem->couple();
    return dem;
}

/// An air that differs from particle to particle, so that none may get another's.
GasState airOf(int id)
{
    GasState gas;
    gas.velocity = {1.0 + 0.1*id, -0.5*id, 0.3};
    gas.dragCoefficient = mass/dt*0.002*(id % 11);
    gas.force = {1e-4*id, 0, -2e-5*id};
    return gas;
}

void blow(DemEngine& dem)
{
    const ParticleView here = dem.particles();
    for (int i = 0; i < here.count; ++i)
    {
        dem.setGas(i, airOf(here.id[i]));
    }
}

void blowOnAll(DemEngine& dem, const GasState& gas)
{
    const ParticleView here = dem.particles();
    for (int i = 0; i < here.count; ++i)
    {
        dem.setGas(i, gas);
    }
}

/// What drag gave each particle, by id, on the ranks that hold them.
void expectMomentumExplained(
    const DemEngine& dem, const std::map<int, Grain>& before, double time, double gravity)
{
    const ParticleView here = dem.particles();
    for (int i = 0; i < here.count; ++i)
    {
        const GasState gas = airOf(here.id[i]);
        const Vector3 impulse = dem.impulse(i);
        for (int k = 0; k < 3; ++k)
        {
            const double weight = k == 2 ? -gravity*here.mass[i] : 0;
            const double gained =
                here.mass[i]*(here.velocity[i][k] - before.at(here.id[i]).velocity[k]);
            const double given = impulse[k] + (gas.force[k] + weight)*time;
            const double scale = here.mass[i]*(1 + std::abs(gas.velocity[k]));
            EXPECT_NEAR(gained, given, 1e-13*scale) << "particle " << here.id[i];
        }
    }
}

} // namespace

// m dv/dt = b (u - v): v = u [1 - exp(-b t/m)], whatever the number of steps and intervals and
// however stiff. At b dt/m = 1e3 the particle goes with the air.
TEST(AirForce, FollowsTheExponentialOfAFrozenAir)
{
    for (const double stiffness : {1e-9, 1e-3, 0.1, 1.0, 30.0, 1e3})
    {
        for (const long steps : {1L, 2L, 9L})
        {
            const auto dem = cloud();
            const GasState gas{{2, -1, 0.5}, stiffness*mass/dt, {}};
            blowOnAll(*dem, gas);
            dem->advance(steps);
            blowOnAll(*dem, gas);
            dem->advance(3);

            const double reached = -std::expm1(-stiffness*static_cast<double>(steps + 3));
            const Vector3 velocity = everyGrain(*dem).at(7).velocity;
            EXPECT_NEAR(velocity[0], 2*reached, 1e-14*reached);
            EXPECT_NEAR(velocity[1], -reached, 1e-14*reached);
        }
    }
}

// With a steady force F and weight the particle tends to u + (F + m g)/b, exponentially.
TEST(AirForce, TendsToTheTerminalVelocityUnderOtherForces)
{
    const auto dem = cloud({{"gravity", "9.81"}});
    const double b = 0.4*mass/dt;
    blowOnAll(*dem, {{0.1, 0, 0}, b, {2*b, 0, 0}});
    dem->advance(5);

    const double share = 1 - std::exp(-0.4*5);
    const Vector3 velocity = everyGrain(*dem).at(7).velocity;
    EXPECT_NEAR(velocity[0], 2.1*share, 1e-14);
    EXPECT_NEAR(velocity[2], -9.81*mass/b*share, 1e-17);
}

TEST(AirForce, WithoutDragGivesTheSteadyForceAlone)
{
    const auto dem = cloud();
    blowOnAll(*dem, {{5, 5, 5}, 0, {mass, 0, 0}});
    dem->advance(100);

    EXPECT_NEAR(everyGrain(*dem).at(7).velocity[0], 1e-3, 1e-16);
    EXPECT_EQ(everyGrain(*dem).at(7).velocity[1], 0);
    if (dem->particles().count > 0)
    {
        EXPECT_EQ(dem->impulse(0), (Vector3{0, 0, 0}));
    }
}

// (m + m_a) dv/dt = b (u - v) + F, on the whole and in what the air must give up: m v - F t.
TEST(AirForce, MovesParticlesWithFluidThatTheyTakeAlong)
{
    const double added = 9*mass;
    for (const double stiffness : {1e-9, 0.1, 30.0})
    {
        for (const long steps : {1L, 7L})
        {
            const auto dem = cloud({{"gravity", "9.81"}});
            const double b = stiffness*(mass + added)/dt;
            const double push = 2e-3*mass/dt;
            const GasState gas{{2, 0, 0}, b, {0, push, 0}};
            dem->useAddedMass();
            for (const long interval : {steps, 3L})
            {
                blowOnAll(*dem, gas);
                for (int i = 0; i < dem->particles().count; ++i)
                {
                    dem->setAddedMass(i, added);
                }
                dem->advance(interval);
            }

            const double reached = -std::expm1(-stiffness*static_cast<double>(steps + 3));
            const ParticleView here = dem->particles();
            for (int i = 0; i < here.count; ++i)
            {
                EXPECT_NEAR(here.velocity[i][0], 2*reached, 1e-13*reached);
                EXPECT_NEAR(here.velocity[i][1], push/b*reached, 1e-13*push/b*reached);
                EXPECT_NEAR(here.velocity[i][2], -9.81*mass/b*reached, 1e-13*9.81*mass/b*reached);
            }
        }
    }
}

TEST(AirForce, AccountsForTheMomentumOfFluidThatIsTakenAlong)
{
    const auto dem = cloud({{"gravity", "9.81"}});
    dem->useAddedMass();
    const auto before = everyGrain(*dem);
    blow(*dem);
    for (int i = 0; i < dem->particles().count; ++i)
    {
        dem->setAddedMass(i, mass*dem->particles().id[i]);
    }
    dem->advance(11);
    expectMomentumExplained(*dem, before, 11*dt, 9.81);
}

// Newton's third law needs the impulse that was really given, to the last digit.
TEST(AirForce, AccountsForAllMomentumThatDragGives)
{
    const auto dem = cloud({{"gravity", "9.81"}});
    for (const long steps : {1L, 2L, 40L})
    {
        const auto before = everyGrain(*dem);
        blow(*dem);
        dem->advance(steps);
        expectMomentumExplained(*dem, before, static_cast<double>(steps)*dt, 9.81);
    }
}

// At up to 30 m/s particles cross the box, so ranks, and the memory is sorted on the way.
// Contacts are off, or their momentum would be in the balance too.
TEST(AirForce, TravelsWithItsParticle)
{
    const auto dem = cloud();
    dem->command("neigh_modify exclude type 1 1");
    blow(*dem);
    dem->advance(1);
    const auto before = everyGrain(*dem);
    const ParticleView start = dem->particles();
    const std::vector<int> idsAtStart(start.id, start.id + start.count);

    blow(*dem);
    dem->advance(200);
    dem->advance(300);
    expectMomentumExplained(*dem, before, 500*dt, 0);

    const ParticleView end = dem->particles();
    const std::vector<int> idsAtEnd(end.id, end.id + end.count);
    EXPECT_NE(idsAtStart, idsAtEnd);
    EXPECT_EQ(everyGrain(*dem).size(), 64u);
}

// Collisions only pass momentum on.
TEST(AirForce, AccountsForAllMomentumOfACollidingCloud)
{
    const auto dem = cloud();
    blow(*dem);
    dem->advance(500);

    Vector3 left{};
    const ParticleView here = dem->particles();
    for (int i = 0; i < here.count; ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            left[k] += here.mass[i]*here.velocity[i][k] - dem->impulse(i)[k]
                - airOf(here.id[i]).force[k]*500*dt;
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, left.data(), 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    for (const double residual : left)
    {
        EXPECT_NEAR(residual, 0, 1e-13*64*mass*30);
    }
}

TEST(AirForce, CountsNoImpulseInASetUp)
{
    const auto dem = cloud();
    const auto before = everyGrain(*dem);
    blow(*dem);
    dem->advance(3);
    dem->command("run 0");
    dem->advance(4);
    dem->setTimeStep(0.5*dt);
    dem->advance(2);
    expectMomentumExplained(*dem, before, 8*dt, 0);
}

TEST(AirForce, StartsTheImpulseFromTheGivenValue)
{
    const auto dem = cloud();
    const ParticleView here = dem->particles();
    for (int i = 0; i < here.count; ++i)
    {
        dem->setGas(i, {{0, 0, 0}, 1, {}}, {1, -2, 3});
    }
    dem->advance(5);
    if (dem->particles().count > 0)
    {
        EXPECT_EQ(dem->impulse(0), (Vector3{1, -2, 3}));
    }
}

// The same momentum without the start, after a trip through ranks and memory.
TEST(AirForce, TellsWhatTheAirDidInTheInterval)
{
    const auto dem = cloud();
    const Vector3 start{1e-3*mass, -2e-3*mass, 3e-3*mass};
    const ParticleView before = dem->particles();
    for (int i = 0; i < before.count; ++i)
    {
        dem->setGas(i, airOf(before.id[i]), start);
    }
    dem->advance(500);
    const ParticleView here = dem->particles();
    for (int i = 0; i < here.count; ++i)
    {
        const AirAction action = dem->airAction(i);
        EXPECT_EQ(action.force, airOf(here.id[i]).force);
        for (int k = 0; k < 3; ++k)
        {
            EXPECT_NEAR(action.dragImpulse[k] + start[k], dem->impulse(i)[k], 1e-13*mass*30);
        }
    }
}

// A force fix that a command adds later would act unseen by the drag: here it must be felt as
// one of the other forces. Terminal velocity F/b.
TEST(AirForce, StaysTheLastForce)
{
    const auto dem = cloud();
    const double b = 1e3*mass/dt;
    dem->command("fix push all addforce " + std::to_string(b) + " 0 0");
    blowOnAll(*dem, {{0, 0, 0}, b, {}});
    dem->advance(3);

    EXPECT_NEAR(everyGrain(*dem).at(7).velocity[0], 1, 1e-6);
}

TEST(AirForce, LeavesParticlesAloneThatAreBornInAnInterval)
{
    DemEngine dem(MPI_COMM_WORLD, optionsFor());
    dem.runScript(script("insertion.in"));
    dem.couple();
    dem.advance(20);

    ASSERT_GT(dem.particleCount(), 0);
    EXPECT_EQ(dem.maximumSpeed(), 0);

    blowOnAll(dem, {{1, 0, 0}, 1e3*mass/dt, {}});
    dem.advance(3);
    EXPECT_NEAR(dem.maximumSpeed(), 1, 1e-12);
}

} // namespace interstice::test
