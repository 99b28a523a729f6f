// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/DemEngineImplementation.hpp"
#include "coupling/dem/ParticleRows.hpp"
#include "coupling/laws/InputError.hpp"
#include "coupling/laws/sphereVolume.hpp"

#include <update.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace interstice
{

namespace
{

const char* const memoryId = "interstice_memory";

} // namespace

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

    LAMMPS_NS::LAMMPS& liggghts = implementation_->liggghts.lammps();
    implementation_->air = std::make_unique<dem::AirForce>(liggghts);
    implementation_->memory = dem::rowsOfRestart(liggghts, memoryId, memorySize);
}

ParticleView DemEngine::particles() const
{
    const LAMMPS_NS::Atom& atom = implementation_->atom();
    return {atom.nlocal, atom.x, atom.v, atom.omega, atom.radius, atom.rmass, atom.tag, atom.type};
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

double DemEngine::minimumDensity() const
{
    const ParticleView here = particles();
    double mine = std::numeric_limits<double>::infinity();
    for (int i = 0; i < here.count; ++i)
    {
        mine = std::min(mine, here.mass[i]/sphereVolume(2*here.radius[i]));
    }
    return implementation_->reduced(mine, MPI_MIN);
}

std::array<double, 2> DemEngine::quickestParticle() const
{
    struct // as MPI_DOUBLE_INT has it
    {
        double square; // of radius and root of density
        int rank;
    } least{std::numeric_limits<double>::infinity(), 0};
    const MPI_Comm communicator = implementation_->liggghts.communicator();
    MPI_Comm_rank(communicator, &least.rank);
    const ParticleView here = particles();
    std::array<double, 2> found{};
    for (int i = 0; i < here.count; ++i)
    {
        const double r = here.radius[i];
        const double density = here.mass[i]/sphereVolume(2*r);
        if (r*r*density < least.square)
        {
            least.square = r*r*density;
            found = {r, density};
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, communicator);
    MPI_Bcast(found.data(), 2, MPI_DOUBLE, least.rank, communicator);
    return found;
}

std::vector<bool> DemEngine::particleTypes() const
{
    std::vector<int> present(implementation_->atom().ntypes, 0);
    const ParticleView here = particles();
    for (int i = 0; i < here.count; ++i)
    {
        present[here.type[i] - 1] = 1;
    }
    MPI_Allreduce(MPI_IN_PLACE, present.data(), static_cast<int>(present.size()), MPI_INT, MPI_MAX,
        implementation_->liggghts.communicator());
    return {present.begin(), present.end()};
}

void DemEngine::setGas(int slot, const GasState& gas, const Vector3& startImpulse)
{
    implementation_->air->setGas(slot, gas, startImpulse);
}

void DemEngine::useAddedMass()
{
    if (!implementation_->air->usesAddedMass())
    {
        implementation_->air->useAddedMass();
    }
}

void DemEngine::setAddedMass(int slot, double mass)
{
    implementation_->air->setAddedMass(slot, mass);
}

void DemEngine::useSpinDrag()
{
    if (!implementation_->air->spin())
    {
        implementation_->air->useSpinDrag();
    }
}

void DemEngine::setSpinDrag(int slot, const Vector3& spin, double coefficient)
{
    implementation_->air->spin()->set(slot, spin, coefficient);
}

void DemEngine::useMemory()
{
    if (!implementation_->memory)
    {
        implementation_->memory = dem::defineRows(implementation_->liggghts.lammps(), memoryId, memorySize);
    }
}

double* DemEngine::memory(int slot)
{
    return implementation_->memory->array_atom[slot];
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
    const long long last = stepsDone() + std::max(steps, 0L);
    goOn(steps, [this, last] { implementation_->air->begin(last); });
    implementation_->air->end();
}

void DemEngine::advanceWithoutAir(long steps)
{
    goOn(steps, [] {});
}

template<class Begin>
void DemEngine::goOn(long steps, const Begin& begin)
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
    begin();
    implementation_->liggghts.goOn(steps);
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
