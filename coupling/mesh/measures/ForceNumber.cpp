// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/ForceNumber.hpp"

#include "addToRunTimeSelectionTable.H"

#include <limits>

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(ForceNumber, 0);
addToRunTimeSelectionTable(functionObject, ForceNumber, dictionary);

namespace
{

/// Sums of mass times force, and the number of particles in them.
struct Sums
{
    scalarList value = scalarList(4, 0.0); // weight, drag, drag and pressure, count

    void add(scalar mass, scalar weight, const vector& drag, const vector& pressure)
    {
        value[0] += mass*weight;
        value[1] += mass*mag(drag);
        value[2] += mass*mag(drag + pressure);
        value[3] += 1;
    }

    /// A division by zero would end the program (trapFpe).
    scalar over(int n) const
    {
        using Limits = std::numeric_limits<scalar>;
        return value[n] > 0 ? value[0]/value[n]
            : value[0] > 0  ? Limits::infinity()
                            : Limits::quiet_NaN();
    }

    void gather()
    {
        Pstream::listCombineGather(value, plusEqOp<scalar>());
        Pstream::listCombineScatter(value);
    }
};

} // namespace

ForceNumber::ForceNumber(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, dict,
        {"forceNumberInDie [-]", "withPressureInDie [-]", "particlesInDie [-]",
            "forceNumber [-]", "withPressure [-]", "particles [-]"})
{
    read(dict);
}

bool ForceNumber::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    die_ = std::make_unique<DieCavity>(p.sub("die"), time_);
    ownGravity_ = p.has("gravity");
    gravity_ = p.direction("gravity", "m/s2", Zero);
    p.allKnown();
    return true;
}

std::vector<double> ForceNumber::measure(const PowderState& powder)
{
    const double g = mag(ownGravity_ ? gravity_ : powder.gravity);
    const bool air = powder.drag.size() == powder.count;
    Sums die;
    Sums all;
    for (int i = 0; i < powder.count; ++i)
    {
        const double mass = powder.mass[i];
        const vector drag = air ? powder.drag[i] : vector::zero;
        const vector pressure = air ? powder.pressureForce[i] : vector::zero;
        all.add(mass, mass*g, drag, pressure);
        if (die_->holds(toFoam(powder.position[i])))
        {
            die.add(mass, mass*g, drag, pressure);
        }
    }
    die.gather();
    all.gather();
    return {die.over(1), die.over(2), die.value[3], all.over(1), all.over(2), all.value[3]};
}

} // namespace interstice
