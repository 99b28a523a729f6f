// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DemStepLimits.hpp"

#include "Time.H"

#include <string>

namespace interstice
{

class DemEngine;

/// Two clocks in step: a DEM step within its limits, and a coupling step (the fluid's deltaT) that
/// is a whole number of them and within its own.
///
/// Limits of the coupling step, each reported by name when it binds:
///     Courant number of the air      maxCo                  system/controlDict
///     response of the powder         couplingNumber tau_eff (sealed bed; not in a held air)
///     travel of particles and walls  parcelCourant cells
///     largest step                   maxDeltaT              system/controlDict
///     first step                     deltaT                 system/controlDict
///     growth                         1.2 of the last step and one DEM step
///     output                         the next write time or the end
/// Limits of the DEM step: Rayleigh time, Hertz time, time of friction's dashpot (laws/DemStepLimits.hpp),
/// bounds of the case.
class TimeStepChoice
{
public:
    /// Reads group `timeStep` of couplingProperties:
    ///     couplingNumber   dt/tau_eff that is chosen                        default 0.2
    ///     stabilityLimit   dt/tau_eff beyond which a fixed deltaT is refused default 1
    ///     parcelCourant    cells that a particle may cross in a step         default 0.5
    ///     demStep          fixed DEM step [s]                                default: chosen
    ///     rayleighFraction, hertzFraction  shares of these times that are chosen, 0.2 and 0.15; at
    ///                      most 0.5, with a warning above 0.25 and 0.2
    ///     expectedSpeed    impact speed that the Hertz time allows for [m/s], default 0.5
    ///     minDemStep, maxDemStep           bounds [s]                        1e-9, 1e-4
    TimeStepChoice(Foam::Time& time, const Foam::dictionary& dict);

    /// For a run that goes on: from when its outputs are counted [s], and its last deltaT [s].
    void resume(double start, double deltaT);

    /// Time from which outputs are counted [s].
    double start() const { return start_; }

    /// Whether the step that was chosen last ends at an output, or ends the run, which is one as well.
    bool outputDue() const;

    /// What the limits depend on. Same on all ranks.
    struct Scene
    {
        bool air = true;
        double courant = 0; ///< of the air in the last step
        double response = 0; ///< shortest tau_eff [s]; zero: powder does not move the air
        double speed = 0; ///< of the fastest particle or wall [m/s]
        double cell = 0; ///< smallest cell size [m]
        double radius = 0; ///< of the particle with the shortest Rayleigh time [m]; zero: no particles
        double density = 0; ///< of that [kg/m3]
    };

    /// Collective. Chooses the DEM step (tells LIGGGHTS if it must change) and sets deltaT.
    /// Throws InputError if a step that the user fixed is beyond its stability limit.
    void choose(const Scene& scene, DemEngine& dem);

    const std::string& bindingLimit() const { return binding_; }
    long demSteps() const { return demSteps_; }

private:
    DemStepLimits demLimits(const Scene& scene, const DemEngine& dem) const;
    void chooseDemStep(const Scene& scene, DemEngine& dem);
    void warnOfLongStep(double step, const DemStepLimits& limits, double speed);
    static void setDemStep(double step, DemEngine& dem);
    double largestStep(const Scene& scene, double demStep);
    void refuseUnstable(const Scene& scene, double step) const;
    double outputsUntil(double time, double demStep) const;
    long alignWithOutput(long steps, double demStep);

    Foam::Time& time_;
    std::string file_;
    double couplingNumber_;
    double stabilityLimit_;
    double parcelCourant_;
    double fixedDemStep_;
    double rayleighFraction_;
    double hertzFraction_;
    double expectedSpeed_;
    double minDemStep_;
    double maxDemStep_;
    bool adjust_ = true;
    double maxCo_;
    double maxDeltaT_;
    double writeInterval_ = 0; // [s]; zero: outputs do not follow the clock
    double start_;
    bool reachesOutput_ = false;
    bool first_ = true;
    bool warned_ = false;
    std::string binding_;
    long demSteps_ = 0;
};

} // namespace interstice
