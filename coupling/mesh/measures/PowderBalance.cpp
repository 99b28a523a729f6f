// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/PowderBalance.hpp"

#include "addToRunTimeSelectionTable.H"

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(PowderBalance, 0);
addToRunTimeSelectionTable(functionObject, PowderBalance, dictionary);

namespace
{

/// A balance that does not show its last digits cannot be checked.
dictionary precise(const dictionary& dict)
{
    dictionary result(dict);
    result.add("writePrecision", 16); // a value that is there stays
    return result;
}

} // namespace

PowderBalance::PowderBalance(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, precise(dict),
        {"massInDie [kg]", "massInShoe [kg]", "massElsewhere [kg]", "massAtStart [kg]",
            "massMissing [kg]", "particles [-]", "outside [-]", "lost [-]",
            "momentumRemainderX [N s]", "momentumRemainderY [N s]", "momentumRemainderZ [N s]",
            "dragImpulseX [N s]", "dragImpulseY [N s]", "dragImpulseZ [N s]",
            "clippedVolume [m3]", "movedVolume [m3]", "hiddenVolume [m3]"})
{
    read(dict);
}

bool PowderBalance::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    die_ = p.has("die") ? std::make_unique<DieCavity>(p.sub("die"), time_) : nullptr;
    if (p.has("shoe"))
    {
        readShoe(p.sub("shoe"));
    }
    p.allKnown();
    return true;
}

void PowderBalance::readShoe(const dictionary& dict)
{
    const Parameters p(dict);
    wall_ = p.text("wall", "shoe");
    where_ = p.where("wall");
    dictionary room(dict);
    room.remove("wall");
    shoe_ = std::make_unique<DieCavity>(room, time_);
}

std::vector<double> PowderBalance::measure(const PowderState& powder)
{
    enum Place { inDie, inShoe, elsewhere, places };
    const vector gone = shoe_ ? travel(powder, wall_, where_) : vector::zero;
    scalarList mass(places, 0.0);
    for (int i = 0; i < powder.count; ++i)
    {
        const vector centre = toFoam(powder.position[i]);
        const Place place = die_ && die_->holds(centre) ? inDie
            : shoe_ && shoe_->holds(centre - gone)      ? inShoe
                                                        : elsewhere;
        mass[place] += powder.mass[i];
    }
    Pstream::listCombineGather(mass, plusEqOp<scalar>());
    Pstream::listCombineScatter(mass);

    const double missing =
        powder.initialMass - (mass[inDie] + mass[inShoe] + mass[elsewhere]);
    const vector& remainder = powder.momentumRemainder;
    const vector& impulse = powder.stepImpulse;
    return {mass[inDie], mass[inShoe], mass[elsewhere], powder.initialMass, missing,
        double(powder.total), double(powder.outside), double(powder.lost),
        remainder.x(), remainder.y(), remainder.z(), impulse.x(), impulse.y(), impulse.z(),
        powder.clippedVolume, powder.movedVolume, powder.hiddenVolume};
}

} // namespace interstice
