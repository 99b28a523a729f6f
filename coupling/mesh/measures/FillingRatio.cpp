// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/FillingRatio.hpp"

#include "coupling/laws/InputError.hpp"

#include "IFstream.H"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"

#include <cstdio>

namespace interstice
{

using namespace Foam;

defineTypeNameAndDebug(FillingRatio, 0);
addToRunTimeSelectionTable(functionObject, FillingRatio, dictionary);

namespace
{

const char* const frontCrossed = "frontCrossed";
const char* const rearArrives = "rearArrives";
const char* const atEnd = "end";

double readFullMass(const Parameters& p, const Time& time)
{
    const auto positive = Parameters::Range::positive;
    if (!p.has("fullMassFile"))
    {
        return p.number("fullMass", "kg", positive);
    }
    if (p.has("fullMass"))
    {
        throw InputError({"The mass that fills the die must be given once.",
            "fullMass and fullMassFile", "one of them", p.where("fullMassFile"),
            "Remove one of them."});
    }
    const fileName file = time.globalPath()/p.text("fullMassFile");
    if (!isFile(file))
    {
        throw InputError({"The mass that fills the die cannot be read.", "no file " + file, "",
            p.where("fullMassFile"), "Fill the die first, or give fullMass."});
    }
    IFstream stream(file);
    dictionary content(stream);
    content.name() = file;
    return Parameters(content).number("fullMass", "kg", positive);
}

std::string percent(double ratio)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100*ratio);
    return text;
}

} // namespace

FillingRatio::FillingRatio(const word& name, const Time& time, const dictionary& dict)
:
    PowderMeasure(name, time, dict,
        {"fillingRatio [-]", "massInDie [kg]", "particlesInDie [-]", "shoeTravel [m]"})
{
    read(dict);
}

bool FillingRatio::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    const Parameters p(dict);
    declareCommon(p);
    die_ = std::make_unique<DieCavity>(p.sub("die"), time_);
    fullMass_ = readFullMass(p, time_);
    if (p.has("shoe"))
    {
        readShoe(p.sub("shoe"));
    }
    p.allKnown();
    return true;
}

void FillingRatio::readShoe(const dictionary& dict)
{
    const auto any = Parameters::Range::any;
    const Parameters p(dict);
    const std::string wall = p.text("wall", "shoe");
    const vector along = p.direction("direction", "", vector(1, 0, 0));
    const double front = p.number("front", "m", any);
    const double rear = p.number("rear", "m", any);
    p.allKnown();
    if (mag(along) < SMALL || front <= rear)
    {
        throw InputError({"A shoe has its front ahead of its rear.",
            "front " + Foam::name(front) + " m, rear " + Foam::name(rear) + " m",
            "front above rear, and a direction that is not zero", p.where("front"),
            "Correct front, rear or direction."});
    }
    const vector unit = along/mag(along);
    const Extent die = extentAlong(die_->bounds(), unit);
    shoe_ = std::make_unique<Shoe>(
        Shoe{wall, unit, die.high - front, die.low - rear, p.where("wall")});
}

std::vector<double> FillingRatio::measure(const PowderState& powder)
{
    double mass = 0;
    label inside = 0;
    for (int i = 0; i < powder.count; ++i)
    {
        const vector centre = toFoam(powder.position[i]);
        const double share = die_->share(centre, powder.radius[i]);
        mass += share*powder.mass[i];
        inside += share >= 0.5;
    }
    reduce(mass, sumOp<scalar>());
    reduce(inside, sumOp<label>());

    const double ratio = mass/fullMass_;
    double gone = 0;
    if (shoe_)
    {
        gone = travel(powder, shoe_->wall, shoe_->where) & shoe_->direction;
        if (gone >= shoe_->untilFrontCrossed)
        {
            record(frontCrossed, ratio);
        }
        if (gone >= shoe_->untilRearArrives)
        {
            record(rearArrives, ratio);
        }
    }
    powder.notes["filling"] = percent(ratio);
    return {ratio, mass, double(inside), gone};
}

bool FillingRatio::end()
{
    if (!values().empty())
    {
        record(atEnd, values().front());
    }
    return true;
}

bool FillingRatio::reached(const word& moment, double& value) const
{
    return getProperty(moment, value);
}

// A moment comes once. It is kept with the state of the function objects, so that a restarted run
// knows that it is over.
void FillingRatio::record(const word& moment, double value)
{
    double before;
    if (moment != atEnd && reached(moment, before))
    {
        return;
    }
    setProperty(moment, value);
    Info<< "Filling ratio, " << moment << ": " << percent(value).c_str() << " at "
        << time_.timeName() << " s" << nl << endl;
    if (!writeToFile())
    {
        return;
    }
    if (!moments_.valid())
    {
        moments_ = createFile("moments");
        head(moments_.ref(), {"moment", "fillingRatio [-]"});
    }
    writeCurrentTime(moments_.ref());
    moments_.ref() << tab << moment << tab << value << endl;
}

} // namespace interstice
