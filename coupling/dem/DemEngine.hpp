// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/RigidPose.hpp"

#include <mpi.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace interstice
{

using Vector3 = std::array<double, 3>;

/// How LIGGGHTS is opened.
struct DemOptions
{
    /// LIGGGHTS' own log: every command, and the thermo table.
    std::string logFile = "log.liggghts";

    /// What LIGGGHTS would print to the screen (warnings, mesh statistics, progress).
    std::string screenFile = "screen.liggghts";

    /// Variables handed to the script, name -> text. A script reads them as ${name}; a
    /// `variable name index value` in it is then only the default of a stand-alone run.
    std::map<std::string, std::string> variables;
};

/// The particles of this rank, seen in place: nothing is copied.
///
/// Arrays have `count` entries; position and velocity are indexed [i][0..2]. Indices and
/// pointers are void after the next call that may move particles in memory: couple(),
/// advance(), setTimeStep(), command(), runScript(), writeRestart(), readRestart().
struct ParticleView
{
    int count = 0;
    const double* const* position = nullptr; ///< [m]
    const double* const* velocity = nullptr; ///< [m/s]
    const double* const* spin = nullptr;     ///< [rad/s]
    const double* radius = nullptr;          ///< [m], of the parcel
    const double* mass = nullptr;            ///< [kg], of the parcel
    const int* id = nullptr;                 ///< unique in the world, kept for life
    const int* type = nullptr;               ///< of its material, from 1
};

/// The air as one particle meets it, frozen until the next setGas().
struct GasState
{
    Vector3 velocity{};         ///< u, interstitial [m/s]
    double dragCoefficient = 0; ///< b, of the whole parcel: drag = b (u - v) [kg/s]
    Vector3 force{};            ///< every force of the air but drag, -V grad(p) etc. [N]
};

/// What the air did to one particle since the last setGas().
struct AirAction
{
    Vector3 dragImpulse{}; ///< momentum that drag gave it [N s]
    Vector3 force{};       ///< GasState::force [N]
};

struct DemBox
{
    Vector3 low{};  ///< [m]
    Vector3 high{}; ///< [m]
    std::array<bool, 3> periodic{};
};

using Triangle = std::array<Vector3, 3>;

/// Where a mesh wall is now, relative to its place when its triangles were recorded (couple(),
/// or the first set-up after its definition). Velocities are those of the last DEM step, zero
/// before the first one.
using WallPose = RigidPose;

/// One triangle of a mesh wall, by which its pose is known.
struct WallMarker
{
    int number = 0;    ///< LIGGGHTS' number of it
    Triangle atRest{}; ///< where it lay when recorded [m]
    Triangle velocities{}; ///< of its nodes now [m/s]
};

/// What a restart file of LIGGGHTS lacks.
struct DemClockAndWalls
{
    long long stepsDone = 0; ///< LIGGGHTS' step counter
    double time = 0;         ///< LIGGGHTS' `time`, on which moving walls may depend [s]
    double timeStep = 0;     ///< [s]
    std::map<std::string, WallMarker> walls;
};

/// LIGGGHTS, opened on a communicator, driven by an ordinary script and then by the air.
///
/// Life: construct, runScript(), couple(), and then again and again: read particles(), give
/// each one its air by setGas(), advance(), read impulse().
///
/// Unless a call says "local", it is collective: every rank of the communicator makes it, with
/// the same arguments. What a user can get wrong is thrown as InputError, on all ranks. An
/// error that LIGGGHTS finds by itself cannot be caught, LIGGGHTS ends the program (exit code 1
/// or MPI_Abort); its message is copied to stderr by the rank that has it.
///
/// The air acts in every DEM step. Drag follows the particle's current velocity by the exact
/// solution for an air frozen over the step (see ImplicitDrag.hpp), so that any stiffness
/// b dt/m is stable. LIGGGHTS is velocity Verlet: a force found in step n kicks from n - 1/2 to
/// n + 1/2. The first and the last force of an interval belong to half a step each and are
/// solved as such; without contacts the velocity at the end of an interval is then exact.
///
/// Particles born during an interval feel no air until their first setGas(). In runs that a
/// script or command() makes there is no air at all.
class DemEngine
{
public:
    /// Opens LIGGGHTS on a copy of the communicator. MPI must run already.
    DemEngine(MPI_Comm communicator, const DemOptions& options);

    /// Closes LIGGGHTS and frees the communicator's copy. Call before MPI_Finalize.
    ~DemEngine();

    DemEngine(const DemEngine&) = delete;
    DemEngine& operator=(const DemEngine&) = delete;

    /// Runs a LIGGGHTS script. Throws InputError if the file cannot be read.
    void runScript(const std::string& path);

    /// Executes one LIGGGHTS command.
    void command(const std::string& text);

    /// Adds what the air needs, after (hence acting on top of) all that the scripts defined,
    /// records the reference position of the mesh walls, and sets LIGGGHTS up for running.
    /// Throws InputError if the script made no box, no integrator or gave no time step.
    void couple();

    /// The same for a script that has read a restart file: clock, step and the walls' reference
    /// positions are those of the run that wrote it. Throws InputError if the script has not read
    /// this file, or if its walls have another shape.
    void couple(const DemClockAndWalls& before);

    // What the script defined. Local, same answer on all ranks.

    bool hasBox() const;
    bool hasIntegrator() const;   ///< a fix that moves particles, such as nve/sphere
    bool hasCohesion() const; ///< a cohesion model of pair_style gran
    bool hasRollingFriction() const; ///< a model of rolling friction of pair_style gran
    bool hasWalls() const;        ///< a fix wall/gran of any kind
    DemBox box() const;           ///< only if hasBox()

    /// Sum of all `fix gravity` [m/s2]; after couple().
    Vector3 gravity() const;

    /// Values of a `fix property/global` (Young's modulus "youngsModulus" [Pa], "poissonsRatio",
    /// "coefficientRestitution", ...): one value, one a type, or one a pair of types (row by
    /// row), as the script gave it. Empty if the script gave none.
    std::vector<double> materialProperty(const std::string& name) const;

    // Particles

    ParticleView particles() const; ///< local

    long long particleCount() const; ///< on all ranks together
    double maximumSpeed() const;     ///< [m/s], 0 without particles
    double maximumRadius() const;    ///< [m], 0 without particles
    double minimumRadius() const;    ///< [m], 0 without particles
    double minimumDensity() const;   ///< of a particle [kg/m3], infinite without particles

    /// Radius [m] and density [kg/m3] of the particle with the shortest Rayleigh time, which goes as radius times root of
    /// density; zero without particles.
    std::array<double, 2> quickestParticle() const;

    /// For each type of material, the first being type 1, whether any particle is of it. Others may be
    /// those of walls.
    std::vector<bool> particleTypes() const;

    // The air; after couple()

    /// Gives particle `slot` (index into particles()) its air for the coming interval and
    /// sets its drag impulse to a starting value [N s]. Local.
    void setGas(int slot, const GasState& gas, const Vector3& startImpulse = {});

    /// Mass of fluid that particle `slot` takes along in the coming interval [kg], as if it were its own but for
    /// gravity and other forces: (m + m_a) dv/dt is the sum of all forces that the particle is given. The force that
    /// this takes counts with the drag's impulse. First useAddedMass(), which is collective; then local.
    void useAddedMass();
    void setAddedMass(int slot, double mass);

    /// Torque c (w_air - w) on particle `slot` in the coming interval, w its spin: by the exact solution, like
    /// drag. `spin` w_air [rad/s], `coefficient` c [N m s]. First useSpinDrag(), which is collective; then local.
    void useSpinDrag();
    void setSpinDrag(int slot, const Vector3& spin, double coefficient);

    /// Some numbers beside each particle, zero at first, in which a law of the air may keep what it must remember of
    /// it: they travel with the particle, and lie in restart files. First useMemory(), which is collective; then local.
    static constexpr int memorySize = 7;
    void useMemory();
    double* memory(int slot);

    /// The starting value plus the momentum [N s] that drag really gave particle `slot` since
    /// setGas(): exactly, m (v1 - v0) = drag impulse + time * gas.force + what gravity,
    /// contacts and walls gave. It travels with the particle to other ranks. Local.
    Vector3 impulse(int slot) const;

    /// What the air did to particle `slot` since setGas(); it travels with the particle, too. Zero
    /// for one that never met air. Local.
    AirAction airAction(int slot) const;

    /// The first particle whose velocity or force was no number, with these, in words; empty if
    /// there was none. It and all like it are held at rest from then on. Local.
    const std::string& heldParticle() const;

    // Time

    double timeStep() const;   ///< [s]; local
    long long stepsDone() const; ///< LIGGGHTS' step counter; local
    double time() const;         ///< LIGGGHTS' `time` [s]; local

    /// Changes the DEM step [s]. LIGGGHTS is set up anew: particles, forces, contact history and
    /// moving walls go on from where they are. Insertion fixes count in steps, so their rates
    /// change with the step. Throws InputError unless dt > 0.
    void setTimeStep(double dt);

    /// Runs so many DEM steps (>= 0). Cut into intervals in any way, without air, particles
    /// follow the path of one uninterrupted LIGGGHTS run to the last bit.
    void advance(long steps);

    /// The same in a vacuum, at no cost for an air that was never given.
    void advanceWithoutAir(long steps);

    // Walls

    /// Ids of the mesh walls (fix mesh/surface...), in the order of the script. Local.
    std::vector<std::string> meshWalls() const;

    /// All triangles of a mesh wall, as they lay at couple(), same order on all ranks.
    std::vector<Triangle> wallTriangles(const std::string& fixId) const;

    /// Where the wall is now. Throws InputError for an unknown id.
    WallPose wallPose(const std::string& fixId) const;

    // Restart

    /// Writes a LIGGGHTS restart file and sets LIGGGHTS up anew: a run that reads the file makes
    /// the same set-up, and only so both follow the same path, which is that of a run that writes
    /// nothing but for the order of sums. Forces and drag impulses are in the file.
    /// Returns what must be kept with it. After couple().
    DemClockAndWalls writeRestart(const std::string& path);

    /// Reads a restart file (before any box exists). Throws InputError if it is missing.
    void readRestart(const std::string& path);

private:
    void prepare();
    template<class Begin>
    void goOn(long steps, const Begin& begin);

    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace interstice
