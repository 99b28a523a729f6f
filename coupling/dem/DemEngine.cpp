// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/DemEngine.hpp"

#include "coupling/dem/AirForce.hpp"
#include "coupling/dem/LiggghtsInstance.hpp"
#include "coupling/dem/MeshWalls.hpp"
#include "coupling/laws/InputError.hpp"

#include <lammps.h>

#include <atom.h>
#include <domain.h>
#include <fix_gravity.h>
#include <fix_property_global.h>
#include <force.h>
#include <modify.h>
#include <update.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace interstice
{

struct DemEngine::Implementation
{
    Implementation(MPI_Comm communicator, const DemOptions& options)
        : liggghts(communicator, options), walls(liggghts.lammps(), liggghts.communicator())
    {
    }

    bool coupled() const
    {
        return air != nullptr;
    }

    /// After whatever may have changed the run. A set-up of LIGGGHTS ends by forgetting that walls
    /// move: until the next step they would stand still for the powder and the air.
    void setUp()
    {
        air->actLast();
        const std::map<std::string, WallPose> motion = walls.poses();
        walls.setVelocities(motion);
        liggghts.setUp();
        walls.setVelocities(motion);
        walls.record();
        upToDate = true;
    }

    /// The same where forces are what they were: the path then goes on as without it.
    void setUpAgain()
    {
        air->keepForces();
        setUp();
        air->restoreForces();
    }

    LAMMPS_NS::Atom& atom() const
    {
        return *liggghts.lammps().atom;
    }

    double reduced(double mine, MPI_Op operation) const
    {
        double all = 0;
        MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, operation, liggghts.communicator());
        return all;
    }

    bool anyFix(const std::function<bool(const LAMMPS_NS::Fix&)>& is) const
    {
        const LAMMPS_NS::Modify& modify = *liggghts.lammps().modify;
        return std::any_of(modify.fix, modify.fix + modify.nfix,
                           [&is](const LAMMPS_NS::Fix* fix) { return is(*fix); });
    }

    dem::LiggghtsInstance liggghts;
    dem::MeshWalls walls;
    std::unique_ptr<dem::AirForce> air;
    std::string script; ///< the last one that ran
    bool upToDate = false; ///< no command has come since the last set-up
};

DemEngine::DemEngine(MPI_Comm communicator, const DemOptions& options)
    : implementation_(std::make_unique<Implementation>(communicator, options))
{
}

DemEngine::~DemEngine() = default;

void DemEngine::runScript(const std::string& path)
{
    implementation_->liggghts.runScript(path);
    implementation_->script = path;
    implementation_->upToDate = false;
}

void DemEngine::command(const std::string& text)
{
    implementation_->liggghts.command(text);
    implementation_->upToDate = false;
}

void DemEngine::couple()
{
    prepare();
    implementation_->setUp();
}

void DemEngine::couple(const DemClockAndWalls& before)
{
    if (stepsDone() != before.stepsDone)
    {
        throw InputError({"A run that goes on must read the particles of its checkpoint.",
            "the script ends at DEM step " + std::to_string(stepsDone()),
            "step " + std::to_string(before.stepsDone) + ", as in the checkpoint",
            "LIGGGHTS script " + implementation_->script,
            "Let the script begin with\n    if \"${resume} == 1\" then \"read_restart ${checkpoint}\" "
            "else \"...\"\nand make particles, and run, only where resume is 0."});
    }
    prepare();
    implementation_->liggghts.setClock(before.time, before.timeStep);
    implementation_->setUp();
    implementation_->walls.countFrom(before.walls);
    implementation_->air->restoreForces();
}

void DemEngine::prepare()
{
    assert(!implementation_->coupled());
    const auto require = [this](bool fulfilled, const char* rule, const char* remedy)
    {
        if (!fulfilled)
        {
            throw InputError({rule, "nothing of the kind", "",
                "LIGGGHTS script " + implementation_->script, remedy});
        }
    };
    require(hasBox(), "The DEM needs a box.", "Add create_box or read_restart.");
    require(implementation_->atom().rmass && implementation_->atom().radius,
            "The DEM needs particles with a radius and a mass of their own.",
            "Use atom_style granular.");
    require(hasIntegrator(), "The DEM needs a fix that moves the particles.",
            "Add for example: fix integrate all nve/sphere");
    require(implementation_->liggghts.lammps().update->timestep_set,
            "The DEM needs a time step.", "Add for example: timestep 1e-6");

    implementation_->air = std::make_unique<dem::AirForce>(implementation_->liggghts.lammps());
}

bool DemEngine::hasBox() const
{
    return implementation_->liggghts.lammps().domain->box_exist != 0;
}

bool DemEngine::hasIntegrator() const
{
    return implementation_->anyFix(
        [](const LAMMPS_NS::Fix& fix) { return fix.time_integrate != 0; });
}

bool DemEngine::hasGranularPair() const
{
    LAMMPS_NS::Force& force = *implementation_->liggghts.lammps().force;
    return force.pair && force.pair_match("gran", 0);
}

bool DemEngine::hasWalls() const
{
    return implementation_->anyFix([](const LAMMPS_NS::Fix& fix)
                                   { return std::strncmp(fix.style, "wall/gran", 9) == 0; });
}

DemBox DemEngine::box() const
{
    const LAMMPS_NS::Domain& domain = *implementation_->liggghts.lammps().domain;
    DemBox box;
    for (int k = 0; k < 3; ++k)
    {
        box.low[k] = domain.boxlo[k];
        box.high[k] = domain.boxhi[k];
        box.periodic[k] = domain.periodicity[k] != 0;
    }
    return box;
}

Vector3 DemEngine::gravity() const
{
    const LAMMPS_NS::Modify& modify = *implementation_->liggghts.lammps().modify;
    Vector3 sum{};
    for (int i = 0; i < modify.nfix; ++i)
    {
        if (auto* gravity = dynamic_cast<LAMMPS_NS::FixGravity*>(modify.fix[i]))
        {
            Vector3 one{};
            gravity->get_gravity(one.data());
            for (int k = 0; k < 3; ++k)
            {
                sum[k] += one[k];
            }
        }
    }
    return sum;
}

std::vector<double> DemEngine::materialProperty(const std::string& name) const
{
    const LAMMPS_NS::Modify& modify = *implementation_->liggghts.lammps().modify;
    for (int i = 0; i < modify.nfix; ++i)
    {
        auto* property = dynamic_cast<LAMMPS_NS::FixPropertyGlobal*>(modify.fix[i]);
        const auto has = [&](const char* shape)
        { return property && property->check_fix(name.c_str(), shape, 0, 0, "", false); };
        int count = 0;
        if (has("scalar"))
        {
            count = 1;
        }
        else if (has("vector"))
        {
            count = property->size_vector;
        }
        else if (has("matrix"))
        {
            count = property->size_array_rows*property->size_array_cols;
        }
        if (count > 0)
        {
            return {property->get_values(), property->get_values() + count};
        }
    }
    return {};
}

ParticleView DemEngine::particles() const
{
    const LAMMPS_NS::Atom& atom = implementation_->atom();
    return {atom.nlocal, atom.x, atom.v, atom.radius, atom.rmass, atom.tag};
}

long long DemEngine::particleCount() const
{
    long long mine = implementation_->atom().nlocal;
    long long all = 0;
    MPI_Allreduce(
        &mine, &all, 1, MPI_LONG_LONG, MPI_SUM, implementation_->liggghts.communicator());
    return all;
}

double DemEngine::maximumSpeed() const
{
    const ParticleView here = particles();
    double square = 0;
    for (int i = 0; i < here.count; ++i)
    {
        const double* v = here.velocity[i];
        square = std::max(square, v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
    }
    return std::sqrt(implementation_->reduced(square, MPI_MAX));
}

double DemEngine::maximumRadius() const
{
    const ParticleView here = particles();
    const double mine = here.count ? *std::max_element(here.radius, here.radius + here.count) : 0;
    return implementation_->reduced(mine, MPI_MAX);
}

double DemEngine::minimumRadius() const
{
    const ParticleView here = particles();
    const double none = std::numeric_limits<double>::max();
    const double mine =
        here.count ? *std::min_element(here.radius, here.radius + here.count) : none;
    const double all = implementation_->reduced(mine, MPI_MIN);
    return all == none ? 0 : all;
}

void DemEngine::setGas(int slot, const GasState& gas, const Vector3& startImpulse)
{
    implementation_->air->setGas(slot, gas, startImpulse);
}

Vector3 DemEngine::impulse(int slot) const
{
    return implementation_->air->impulse(slot);
}

AirAction DemEngine::airAction(int slot) const
{
    return implementation_->air->action(slot);
}

const std::string& DemEngine::heldParticle() const
{
    return implementation_->air->held();
}

double DemEngine::time() const
{
    return implementation_->liggghts.time();
}

double DemEngine::timeStep() const
{
    return implementation_->liggghts.lammps().update->dt;
}

long long DemEngine::stepsDone() const
{
    return implementation_->liggghts.lammps().update->ntimestep;
}

void DemEngine::setTimeStep(double dt)
{
    if (!(dt > 0))
    {
        throw InputError({"The DEM time step must be positive.", std::to_string(dt) + " s",
                          "more than 0", "", "Give a positive time step."});
    }
    LAMMPS_NS::Update& update = *implementation_->liggghts.lammps().update;
    // The time so far was made of the old steps.
    update.update_time();
    update.dt = dt;
    update.timestep_set = true;

    // Only a set-up reaches every holder of the step: reset_dt() passes wall contacts by.
    if (implementation_->coupled() && implementation_->upToDate)
    {
        implementation_->setUpAgain();
    }
    else
    {
        implementation_->upToDate = false;
    }
}

void DemEngine::advance(long steps)
{
    assert(implementation_->coupled());
    if (steps <= 0)
    {
        return;
    }
    if (!implementation_->upToDate)
    {
        implementation_->setUp();
    }
    implementation_->air->begin(stepsDone() + steps);
    implementation_->liggghts.goOn(steps);
    implementation_->air->end();
}

std::vector<std::string> DemEngine::meshWalls() const
{
    return implementation_->walls.ids();
}

std::vector<Triangle> DemEngine::wallTriangles(const std::string& fixId) const
{
    return implementation_->walls.triangles(fixId);
}

WallPose DemEngine::wallPose(const std::string& fixId) const
{
    return implementation_->walls.pose(fixId);
}

DemClockAndWalls DemEngine::writeRestart(const std::string& path)
{
    assert(implementation_->coupled());
    if (!implementation_->upToDate)
    {
        implementation_->setUp();
    }
    // Kept before: the command sends particles to other ranks, and their forces not with them.
    implementation_->air->keepForces();
    command("write_restart " + path);
    const DemClockAndWalls now{stepsDone(), time(), timeStep(), implementation_->walls.markers()};
    implementation_->setUp();
    implementation_->air->restoreForces();
    return now;
}

void DemEngine::readRestart(const std::string& path)
{
    implementation_->liggghts.requireFile(path, "restart file");
    command("read_restart " + path);
}

} // namespace interstice
