// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/Dispersion.hpp"

#include "coupling/forces/weight.hpp"
#include "coupling/laws/CounterNoise.hpp"
#include "coupling/laws/Dispersion.hpp"
#include "coupling/laws/EffectNumbers.hpp"

#include <cmath>
#include <random>

namespace interstice
{

using namespace Foam;

namespace
{

// Columns of what is remembered of a particle.
enum Column
{
    gust = 0, // 3, fluctuation over its root mean square
    slip = 3, // 3, that drag had in the mean over the last eddies [m/s]
    begun = 6, // 1 after the first step
    columns = 7
};
static_assert(columns == DemEngine::memorySize);

// A time that followed each gust would favour gusts that blow along the slip, and so move the air in the mean.
double rememberSlip(double* memory, const vector& latest, double ratio)
{
    const double share = memory[begun] ? -std::expm1(-ratio) : 1;
    vector mean;
    for (int d = 0; d < 3; ++d)
    {
        memory[slip + d] += share*(latest[d] - memory[slip + d]);
        mean[d] = memory[slip + d];
    }
    return mag(mean);
}

// Velocity beside the mean that a grain sees, as its mean over the interval; the memory goes on to the interval's end.
vector blow(double* memory, const AirMotion::Turbulence& air, double time, double response, double interval,
    CounterNoise noise)
{
    std::normal_distribution<double> chance;
    const LangevinStep step(interval/time);
    vector seen;
    for (int d = 0; d < 3; ++d)
    {
        double& w = memory[gust + d];
        if (!memory[begun])
        {
            w = chance(noise);
        }
        const double first = chance(noise);
        const LangevinStep::Result next = step(w, air.gradient[d]*time/(1 + response/time), first, chance(noise));
        w = next.end;
        seen[d] = air.rms*next.mean;
    }
    memory[begun] = 1;
    return seen;
}

} // namespace

Effect Dispersion::effect() const
{
    return {"dispersion", "drag of turbulent fluctuations over weight", largestDispersionShare};
}

// Of the smallest grain, in the strongest turbulence.
double Dispersion::number(AirMotion& air, const DemEngine& dem) const
{
    const double fluctuation = air.largestFluctuation();
    return fluctuation > 0 ? stokesDragShare(fluctuation, 2*dem.minimumRadius()/coarseGraining_,
               air.largestViscosity(), dem.minimumDensity(), pullOn(dem))
                           : 0;
}

// The drag's impulse counts what a fluctuation gives, so that the air owes it.
void Dispersion::act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own)
{
    dem.useMemory();
    const std::vector<AirMotion::Around>& around = air.around();
    const std::vector<AirMotion::Turbulence> turbulence = air.turbulence();
    const ParticleView view = dem.particles();
    for (int i = 0; i < view.count; ++i)
    {
        if (!seen(own[i]) || around[i].voidFraction <= loneGrainVoidFraction)
        {
            continue;
        }
        double* memory = dem.memory(i);
        const double b = own[i].dragCoefficient;
        Vec3& u = own[i].velocity;
        vector latest;
        for (int d = 0; d < 3; ++d)
        {
            latest[d] = memory[begun] ? dem.airAction(i).dragImpulse[d]/(b*air.interval) : u[d] - view.velocity[i][d];
        }
        const AirMotion::Turbulence& here = turbulence[i];
        const double along = max(here.time, VSMALL);
        const double time =
            max(seenTime(along, rememberSlip(memory, latest, air.interval/along), here.rms), VSMALL);
        const vector more =
            blow(memory, here, time, view.mass[i]/b, air.interval, CounterNoise(view.id[i], air.step));
        for (int d = 0; d < 3; ++d)
        {
            u[d] += more[d];
        }
    }
}

} // namespace interstice
