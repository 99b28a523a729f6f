// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/TimeStepChoice.hpp"

#include "coupling/dem/DemEngine.hpp"
#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/Parameters.hpp"

#include "IOstreams.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interstice
{

using namespace Foam;

namespace
{

std::string text(double number)
{
    std::ostringstream stream;
    stream << number;
    return stream.str();
}

// Of the Rayleigh or the Hertz time beyond which contacts gain energy.
constexpr double longestShare = 0.5;

double contactShare(const Parameters& p, const word& key, double byDefault)
{
    const double share = p.number(key, "", Parameters::Range::fraction, byDefault);
    if (share > longestShare)
    {
        const char* time = key == "hertzFraction" ? "Hertz" : "Rayleigh";
        throw InputError({"The DEM step is too long for the contacts.", key + " " + text(share),
            "at most " + text(longestShare) + " of the " + time + " time", p.where(key),
            "Remove " + key + " to have it chosen, or lower it."});
    }
    return share;
}

// The largest (sign 1) or smallest (-1) of a property, or what stands for none.
double extreme(const std::vector<double>& values, int sign, double none)
{
    double found = none;
    for (const double value : values)
    {
        found = sign*value > sign*found ? value : found;
    }
    return found;
}

// Two significant digits, downwards: round steps make round output times.
double roundedDown(double step)
{
    const double unit = std::pow(10.0, std::floor(std::log10(step)) - 1);
    return std::floor(step/unit*(1 + 1e-9))*unit;
}

} // namespace

TimeStepChoice::TimeStepChoice(Time& time, const dictionary& dict)
:
    time_(time),
    start_(time.startTime().value())
{
    using Range = Parameters::Range;
    const Parameters p(dict);
    file_ = Parameters::nameOf(dict);
    couplingNumber_ = p.number("couplingNumber", "", Range::positive, 0.2);
    stabilityLimit_ = p.number("stabilityLimit", "", Range::positive, 1);
    parcelCourant_ = p.number("parcelCourant", "", Range::positive, 0.5);
    fixedDemStep_ = p.number("demStep", "s", Range::positive, -1);
    rayleighFraction_ = contactShare(p, "rayleighFraction", 0.2);
    hertzFraction_ = contactShare(p, "hertzFraction", 0.15);
    expectedSpeed_ = p.number("expectedSpeed", "m/s", Range::positive, 0.5);
    minDemStep_ = p.number("minDemStep", "s", Range::positive, 1e-9);
    maxDemStep_ = p.number("maxDemStep", "s", Range::positive, 1e-4);
    p.allKnown();

    const Parameters control(time.controlDict());
    adjust_ = control.flag("adjustTimeStep", true);
    maxCo_ = control.number("maxCo", "", Range::positive, 1);
    maxDeltaT_ = control.number("maxDeltaT", "s", Range::positive, GREAT);
    const double interval = control.number("writeInterval", "", Range::positive, 1);
    const word writeControl = time.controlDict().getOrDefault<word>("writeControl", "timeStep");
    if (writeControl == "runTime" || writeControl == "adjustable"
        || writeControl == "adjustableRunTime")
    {
        writeInterval_ = interval;
    }
}

// OpenFOAM counts outputs from where a program was started; we, from where the run began: it may have
// been stopped anywhere.
void TimeStepChoice::resume(double start, double deltaT)
{
    first_ = false;
    start_ = start;
    if (adjust_)
    {
        time_.setDeltaT(deltaT, false);
    }
}

bool TimeStepChoice::outputDue() const
{
    const bool ends = time_.value() > time_.endTime().value() - 0.5*time_.deltaTValue();
    return ends || (writeInterval_ > 0 ? reachesOutput_ : time_.outputTime());
}

// A whole number, as a time that falls short by half a DEM step counts.
double TimeStepChoice::outputsUntil(double time, double demStep) const
{
    return std::floor((time - start_ + 0.5*demStep)/writeInterval_);
}

DemStepLimits TimeStepChoice::demLimits(const Scene& scene, const DemEngine& dem) const
{
    const auto property = [&](const char* name)
    {
        const std::vector<double> values = dem.materialProperty(name);
        if (values.empty())
        {
            throw InputError({"The DEM step is chosen from the stiffness of the particles.",
                std::string("no property ") + name + " in the LIGGGHTS script",
                "fix ... property/global " + std::string(name) + " peratomtype ...",
                file_, "Add it to the script, or fix the step by demStep."});
        }
        return values;
    };
    ContactMaterials materials;
    materials.youngsModulus = property("youngsModulus");
    materials.poissonsRatio = property("poissonsRatio");
    materials.ofParticles = dem.particleTypes();
    materials.restitution = extreme(dem.materialProperty("coefficientRestitution"), -1, 1);
    materials.rough = extreme(dem.materialProperty("coefficientFriction"), 1, 0) > 0;
    return demStepLimits(
        materials, scene.radius, scene.density, std::max(scene.speed, expectedSpeed_));
}

// A set-up of LIGGGHTS costs time and disturbs the last digits: only for another step.
void TimeStepChoice::setDemStep(double step, DemEngine& dem)
{
    if (std::abs(step - dem.timeStep()) > 1e-12*step)
    {
        dem.setTimeStep(step);
    }
}

void TimeStepChoice::warnOfLongStep(double step, const DemStepLimits& limits, double speed)
{
    if (warned_ || (step < 0.25*limits.rayleigh && step < 0.2*limits.hertz))
    {
        return;
    }
    warned_ = true;
    Info<< "WARNING: The DEM step of " << step << " s is " << round(100*step/limits.rayleigh)
        << " % of the Rayleigh time and " << round(100*step/limits.hertz) << " % of the Hertz time at "
        << speed << " m/s: hard impacts may gain energy. Remove demStep, rayleighFraction and "
        << "hertzFraction to have it chosen." << nl << endl;
}

void TimeStepChoice::chooseDemStep(const Scene& scene, DemEngine& dem)
{
    if (scene.radius <= 0)
    {
        if (fixedDemStep_ > 0)
        {
            setDemStep(fixedDemStep_, dem);
        }
        return; // nothing that could be unstable: the script's step stands
    }
    const bool stiffnessKnown = !dem.materialProperty("youngsModulus").empty();
    if (fixedDemStep_ > 0 && !stiffnessKnown)
    {
        setDemStep(fixedDemStep_, dem);
        return;
    }

    const DemStepLimits limits = demLimits(scene, dem);
    double step = fixedDemStep_;
    if (fixedDemStep_ > 0)
    {
        if (fixedDemStep_ > limits.longestStep())
        {
            throw InputError({"The DEM step is too long for the contacts.",
                "demStep " + text(fixedDemStep_) + " s",
                "less than half the Rayleigh time " + text(limits.rayleigh)
                    + " s, half the Hertz time " + text(limits.hertz) + " s"
                    + (limits.dashpot < GREAT
                            ? " and what friction's dashpot allows, " + text(limits.dashpot) + " s"
                            : ""),
                file_ + ", key demStep", "Remove demStep to have it chosen, or lower it."});
        }
    }
    else
    {
        step = std::min({rayleighFraction_*limits.rayleigh, hertzFraction_*limits.hertz,
            limits.dashpot, maxDemStep_});
        step = roundedDown(std::max(step, minDemStep_));
        if (!adjust_)
        {
            const double fluidStep = time_.deltaTValue();
            step = fluidStep/std::ceil(fluidStep/step*(1 - 1e-9));
        }
    }
    // No more changes than stability asks for.
    const double now = dem.timeStep();
    const bool another = fixedDemStep_ > 0 ? std::abs(step - now) > 1e-12*now
                                           : step < 0.8*now || step > 2*now;
    if (first_ || another)
    {
        setDemStep(step, dem);
        Info<< "DEM step " << step << " s: " << 100*step/limits.rayleigh
            << " % of the Rayleigh time, " << 100*step/limits.hertz << " % of the Hertz time at "
            << std::max(scene.speed, expectedSpeed_) << " m/s" << nl << endl;
        warnOfLongStep(step, limits, std::max(scene.speed, expectedSpeed_));
    }
}

double TimeStepChoice::largestStep(const Scene& scene, double demStep)
{
    double step = maxDeltaT_;
    binding_ = "maxDeltaT";
    const auto limit = [&](double candidate, const char* name)
    {
        if (candidate < step)
        {
            step = candidate;
            binding_ = name;
        }
    };
    if (scene.air)
    {
        if (scene.courant > SMALL)
        {
            limit(maxCo_/scene.courant*time_.deltaTValue(), "Courant number");
        }
        if (scene.response > 0)
        {
            limit(couplingNumber_*scene.response, "powder response");
        }
        // By at least one DEM step, or a step of one DEM step would stay so for ever.
        limit(first_ ? time_.deltaTValue() : 1.2*time_.deltaTValue() + demStep,
            first_ ? "deltaT" : "growth");
    }
    if (scene.speed > 0)
    {
        limit(parcelCourant_*scene.cell/scene.speed, "particle travel");
    }
    if (step >= GREAT)
    {
        step = time_.deltaTValue();
        binding_ = "deltaT";
    }
    return step;
}

void TimeStepChoice::refuseUnstable(const Scene& scene, double step) const
{
    const double limit = stabilityLimit_*scene.response;
    if (scene.air && scene.response > 0 && step > limit)
    {
        throw InputError({"The fixed coupling step is unstable: powder and trapped air would "
                          "swing against each other.",
            "deltaT " + text(step) + " s = " + text(step/scene.response)
                + " of the powder's response time " + text(scene.response) + " s",
            "at most " + text(limit) + " s; accurate below "
                + text(couplingNumber_*scene.response) + " s",
            "system/controlDict, key deltaT (adjustTimeStep off)",
            "Set adjustTimeStep on to have it chosen, or deltaT to "
                + text(roundedDown(couplingNumber_*scene.response)) + "."});
    }
}

// A whole number of steps to the next output, in equal shares.
long TimeStepChoice::alignWithOutput(long steps, double demStep)
{
    double next = time_.endTime().value();
    if (writeInterval_ > 0)
    {
        next = std::min(next, start_ + (outputsUntil(time_.value(), demStep) + 1)*writeInterval_);
    }
    const long distance = std::lround((next - time_.value())/demStep);
    if (distance <= 0)
    {
        return steps;
    }
    if (steps >= distance)
    {
        binding_ = "output";
        return distance;
    }
    const long parts = (distance + steps - 1)/steps;
    return (distance + parts - 1)/parts;
}

void TimeStepChoice::choose(const Scene& scene, DemEngine& dem)
{
    chooseDemStep(scene, dem);
    const double demStep = dem.timeStep();

    if (adjust_)
    {
        const long steps =
            std::max(1L, static_cast<long>(largestStep(scene, demStep)/demStep*(1 + 1e-9)));
        demSteps_ = alignWithOutput(steps, demStep);
    }
    else
    {
        const double fixed = time_.deltaTValue();
        refuseUnstable(scene, fixed);
        binding_ = "deltaT";
        demSteps_ = std::lround(fixed/demStep);
        if (demSteps_ < 1 || std::abs(demSteps_*demStep - fixed) > 1e-6*fixed)
        {
            throw InputError({"The fluid step is not a whole number of DEM steps.",
                "deltaT " + text(fixed) + " s = " + text(fixed/demStep) + " DEM steps of "
                    + text(demStep) + " s",
                "a whole number of at least 1", "system/controlDict, key deltaT",
                "Set deltaT to " + text(std::max(1L, demSteps_)*demStep) + "."});
        }
    }
    const double step = demSteps_*demStep;
    reachesOutput_ = writeInterval_ > 0
        && outputsUntil(time_.value() + step, demStep) > outputsUntil(time_.value(), demStep);
    time_.setDeltaT(step, false);
    first_ = false;
}

} // namespace interstice
