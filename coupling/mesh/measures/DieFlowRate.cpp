// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/DieFlowRate.hpp"

#include "coupling/laws/sphereVolume.hpp"

#include "addToRunTimeSelectionTable.H"

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(DieFlowRate, 0);
addToRunTimeSelectionTable(functionObject, DieFlowRate, dictionary);

DieFlowRate::DieFlowRate(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, dict,
        {"flowRate [m3/s]", "volumeInDie [m3]", "maximum [m3/s]", "timeOfMaximum [s]"})
{
    read(dict);
}

bool DieFlowRate::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    die_ = std::make_unique<DieCavity>(p.sub("die"), time_);
    window_ = p.number("window", "s", Parameters::Range::positive);
    p.allKnown();
    return true;
}

std::vector<double> DieFlowRate::measure(const PowderState& powder)
{
    double volume = 0;
    for (int i = 0; i < powder.count; ++i)
    {
        const double r = powder.radius[i];
        volume += die_->share(toFoam(powder.position[i]), r)*sphereVolume(2*r);
    }
    reduce(volume, sumOp<scalar>());

    const double now = time_.value();
    past_.push_back({now, volume});
    // A little slack: sums of time steps are not exact.
    const double since = now - window_*(1 - 1e-9);
    while (past_.size() > 2 && past_[1].time <= since)
    {
        past_.pop_front();
    }
    const double flow = rate();
    if (past_.front().time <= since && flow > maximum_)
    {
        maximum_ = flow;
        timeOfMaximum_ = now;
    }
    return {flow, volume, maximum_, timeOfMaximum_};
}

double DieFlowRate::rate() const
{
    if (past_.size() < 2)
    {
        return 0;
    }
    const Sample& a = past_[0];
    const Sample& b = past_[1];
    const Sample& last = past_.back();
    const double start = std::max(last.time - window_, a.time);
    const double part = std::min((start - a.time)/(b.time - a.time), 1.0);
    return (last.volume - a.volume - part*(b.volume - a.volume))/(last.time - start);
}

} // namespace interstice
