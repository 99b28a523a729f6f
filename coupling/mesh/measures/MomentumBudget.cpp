// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/MomentumBudget.hpp"

#include "IOdictionary.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(MomentumBudget, 0);
addToRunTimeSelectionTable(functionObject, MomentumBudget, dictionary);

namespace
{

// Conservation shows in the last digits or not at all.
dictionary inFull(const dictionary& dict)
{
    dictionary result(dict);
    result.add("writePrecision", 16);
    return result;
}

} // namespace

MomentumBudget::MomentumBudget(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, inFull(dict),
        {"airX [N s]", "airY [N s]", "airZ [N s]", "powderX [N s]", "powderY [N s]",
            "powderZ [N s]", "remainderX [N s]", "remainderY [N s]", "remainderZ [N s]"})
{
    read(dict);
}

bool MomentumBudget::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    p.allKnown();
    return true;
}

vector MomentumBudget::ofAir() const
{
    const dimensionedScalar density(
        "rho", dimDensity, mesh_.lookupObject<IOdictionary>("transportProperties"));
    const auto& alpha = mesh_.lookupObject<volScalarField>("voidFraction").oldTime();
    const auto& U = mesh_.lookupObject<volVectorField>("U");
    return density.value()
        *gSum(vectorField(mesh_.V().field()*alpha.primitiveField()*U.primitiveField()));
}

std::vector<double> MomentumBudget::measure(const PowderState& powder)
{
    vector momentum(Zero);
    for (int i = 0; i < powder.count; ++i)
    {
        momentum += powder.mass[i]*toFoam(powder.velocity[i]);
    }
    reduce(momentum, sumOp<vector>());

    const vector air = ofAir();
    const vector& remainder = powder.momentumRemainder;
    return {air.x(), air.y(), air.z(), momentum.x(), momentum.y(), momentum.z(), remainder.x(),
        remainder.y(), remainder.z()};
}

} // namespace interstice
