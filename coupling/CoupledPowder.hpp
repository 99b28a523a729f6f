// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/effects/AirCoupling.hpp"
#include "coupling/effects/EffectTable.hpp"
#include "coupling/mesh/PowderOnMesh.hpp"
#include "coupling/mesh/PowderState.hpp"
#include "coupling/mesh/SolidsOnMesh.hpp"
#include "coupling/report/StageClock.hpp"

#include <memory>
#include <optional>

namespace interstice
{

struct Checkpoint;
class DemEngine;
class ParcelForces;
class ParticleExchange;
class TimeStepChoice;

/// The air as the powder finds it.
struct AirAtStart
{
    double density; ///< [kg/m3]
    const Foam::volScalarField& nu; ///< kinematic viscosity
    bool driven; ///< by something else than powder
};

/// The powder: LIGGGHTS, its particles on the mesh, and what they exchange with the air. This is
/// the library's front; a solver needs nothing else of it.
///
/// In each time step, t^n to t^{n+1}:
///
///     powder.chooseTimeStep(courant)   a whole number of DEM steps, within every limit
///     ++runTime
///     powder.toAir(U, nu)              void fraction at predicted positions, drag coefficients
///     ... the air moves ...
///     powder.fromAir(U, nu, gradP)     air at the particles; DEM sub-steps to t^{n+1}
///
/// All member functions are collective unless said otherwise. Errors of the user's making are
/// InputErrors, thrown on all ranks. Keys of constant/couplingProperties: see the README of
/// foam_cases/dieFilling and the readers in CoupledPowderSetup.cpp and TimeStepChoice.hpp.
class CoupledPowder
{
public:
    /// Opens LIGGGHTS, runs the case's script and deposits the powder as it lies, in air at rest. If
    /// the folder of the start time has a checkpoint, the script reads the particles from it.
    CoupledPowder(Foam::fvMesh& mesh, const AirAtStart& air, StageClock& clock);
    ~CoupledPowder();
    CoupledPowder(const CoupledPowder&) = delete;
    CoupledPowder& operator=(const CoupledPowder&) = delete;

    /// To be called before the clock looks for the latest time: renames time folders of `casePath`
    /// (of this rank: processorN) that a kill has torn to `<time>.incomplete`. Returns their times.
    static Foam::wordList setAsideIncomplete(const Foam::fileName& casePath);

    /// True: the run goes on from a checkpoint.
    bool resumed() const { return resumed_; }

    /// False: no air is simulated and the powder falls freely (`air none`).
    bool hasAir() const { return air_ != AirCoupling::none; }

    /// Whether the air is to be solved: false also where a given one moves the powder (`air oneWay`).
    bool movesAir() const { return air_ == AirCoupling::twoWay; }

    /// Whether the powder feels the air's viscous stresses besides its pressure, div(tau) beside -grad(p): the air
    /// has then alpha div(tau) in its equation, else div(alpha tau).
    bool feelsViscosity() const;

    /// Sets deltaT of the clock. `courant`: of the air in the step just done, zero without air.
    void chooseTimeStep(double courant);

    /// Powder to mesh, for the step that has just begun.
    void toAir(const Foam::volVectorField& U, const Foam::volScalarField& nu);

    /// Air to particles, then DEM to the time of the clock. `stressGradient` is what pushes a particle's volume,
    /// grad(p), or grad(p) - div(tau) if the powder feels it [Pa/m].
    void fromAir(const Foam::volVectorField& U, const Foam::volScalarField& nu,
        const Foam::volVectorField& stressGradient);

    /// DEM to the time of the clock, with no air.
    void fall();

    // What the equations of the air take from the powder. Local.
    PowderOnMesh& onMesh() { return *onMesh_; }
    const SolidsOnMesh& solids() const { return *solids_; }
    const PowderState& state() const { return state_; }
    const EffectTable& effects() const { return effects_; }
    const std::string& bindingLimit() const; ///< which limit set the time step
    long demSteps() const; ///< in this time step
    double demTimeStep() const; ///< [s]

    /// What the exchange of particles between ranks cost so far, means a coupling step. Collective.
    struct Traffic
    {
        double bytesPerParticle = 0; ///< sent, of all particles
        double messagesPerRank = 0; ///< sent, with content
        double travellers = 0; ///< share of the particles handled away from home, last step
    };
    Traffic traffic() const;

    /// Writes the particles, where they are now, as the cloud lagrangian/powder of the clock's
    /// time. Particles that no cell holds are left out.
    void writeCloud();

    /// Whether fields and particles are to be written now. Local, same on all ranks.
    bool outputDue() const;

    /// Whether a run can go on from an output (`checkpoints off` in `powder`: it cannot).
    bool writesCheckpoints() const { return checkpoints_; }

    /// Around writing the fields of a time: the particles, and the record that all is written.
    void beginCheckpoint();
    void completeCheckpoint();

private:
    void openDem(const Foam::dictionary& dict, const Checkpoint* before);
    std::optional<Checkpoint> checkpoint() const;
    void resume(const Checkpoint& before);
    Checkpoint record() const;
    void chooseAir(const std::optional<AirCoupling>& wish, bool driven, bool wanted);
    double airNumber() const;
    void readSolids(const Foam::dictionary& dict);
    void checkScene() const;
    void checkSmoothing(double width, const std::string& where) const;
    void checkPowderInMesh() const;
    void moveSolids(double interval);
    void placeParcels(double interval);
    void adaptDrag();
    bool predicted() const;
    double seenAfter(double interval);
    void tellLag();
    void checkParticles() const;
    void refreshState();
    void refreshForces();

    Foam::fvMesh& mesh_;
    StageClock& clock_;
    double density_; // of the air [kg/m3]
    double viscosity_; // at the start, largest [Pa s]
    AirCoupling air_ = AirCoupling::twoWay;
    bool resumed_ = false;
    bool checkpoints_ = true;
    double coarseGraining_ = 1;
    double lag_ = 0; // by which the air sees the powder late [s]
    bool lagTold_ = false;
    double lightest_; // density of the lightest particle so far [kg/m3]
    std::unique_ptr<Checkpoint> pending_; // begun, not complete
    double response_ = 0; // shortest tau_eff, as the last step had it [s]
    std::unique_ptr<DemEngine> dem_;
    std::unique_ptr<PowderOnMesh> onMesh_;
    std::unique_ptr<SolidsOnMesh> solids_;
    std::vector<std::string> solidWalls_; // LIGGGHTS fix of each solid
    std::unique_ptr<ParticleExchange> exchange_;
    std::unique_ptr<TimeStepChoice> timeStep_;
    EffectTable effects_;
    std::size_t airPlace_ = 0; // in that table
    std::unique_ptr<ParcelForces> forces_;
    PowderState state_;
};

} // namespace interstice
