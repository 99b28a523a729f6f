// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/CaseEffects.hpp"

#include "coupling/forces/tell.hpp"
#include "coupling/forces/weight.hpp"
#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/InputError.hpp"

#include "IOdictionary.H"

#include <algorithm>

namespace interstice
{

using namespace Foam;

namespace
{

const char* const rollingFriction = "rollingFriction";
const char* const cohesion = "cohesion";

constexpr double largestBuoyancyShare = 0.01;
constexpr double largestPressureForceShare = 0.01;

// Of the forces between grains, where nobody tells better: as in foam_cases/dieFilling.
constexpr double usualHamaker = 1e-19; // [J]
constexpr double usualAsperity = 1e-7; // [m]
constexpr double usualGap = 4e-10; // [m]

IOdictionary constantFile(const fvMesh& mesh, const char* name)
{
    return IOdictionary(IOobject(
        name, mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false));
}

double largestRollingFriction(const DemEngine& dem)
{
    const std::vector<double> all = dem.materialProperty("coefficientRollingFriction");
    return dem.hasRollingFriction() && !all.empty() ? *std::max_element(all.begin(), all.end()) : 0;
}

bool contradicts(Effect::Wish wish, bool on)
{
    return wish != Effect::Wish::automatic && (wish == Effect::Wish::on) != on;
}

} // namespace

bool turbulent(const fvMesh& mesh)
{
    return constantFile(mesh, "turbulenceProperties").getOrDefault<word>("simulationType", "laminar") != "laminar";
}

double pressureAtRest(const fvMesh& mesh)
{
    return constantFile(mesh, "transportProperties").getOrDefault<scalar>("pressure", 101325);
}

CaseEffects::CaseEffects(const Scene& scene, const Parameters& keys, EffectTable& table)
:
    table_(table),
    dem_(scene.dem),
    coarseGraining_(scene.coarseGraining),
    seen_(scene.wallsInAir)
{
    addOfTheAir(scene, keys);
    addOfThePowder(keys);
}

bool CaseEffects::ofContacts(const word& key)
{
    return key == rollingFriction || key == cohesion;
}

void CaseEffects::addOfTheAir(const Scene& scene, const Parameters& keys)
{
    const IOdictionary transport(constantFile(scene.mesh, "transportProperties"));
    const double atRest = pressureAtRest(scene.mesh);
    const double extent = cmptMin(scene.mesh.bounds().span());

    addFixed({"pressureGradient", "pressure force over weight", largestPressureForceShare}, true, keys,
        "Leave it out: drag and pressure force together are what air and powder exchange.",
        [this](AirMotion& air) { return air.largestPressureForce()/weight(); });
    addChosen({"turbulence", "Reynolds number of the air", largestLaminarReynolds},
        turbulent(scene.mesh), "case", keys,
        "constant/turbulenceProperties, key simulationType",
        [extent](AirMotion& air) { return air.largestReynolds(extent); });
    addChosen({"compressibility", "pressure over that at rest", largestSqueezedAirShare},
        transport.getOrDefault<word>("compressibility", "none") != "none", "case", keys,
        "constant/transportProperties, key compressibility",
        [atRest](AirMotion& air) { return air.largestPressure()/atRest; });
    addChosen({"airGravity", "buoyancy over weight", largestBuoyancyShare},
        mag(transport.getOrDefault<vector>("gravity", Zero)) > 0, "case", keys,
        "constant/transportProperties, key gravity",
        [this](AirMotion& air) { return dem_.gravity() == Vector3{} ? 0 : air.density/dem_.minimumDensity(); });
    addFixed({"history", "Basset's force over Stokes' drag", largestHistoryShare}, false, keys,
        "Leave it out: it is not available.",
        [this](AirMotion& air) { return historyShare(1, 1, dem_.minimumDensity()/(18*air.density)); });
}

void CaseEffects::addOfThePowder(const Parameters& keys)
{
    Effect walls{"movingWalls", "drag at the speed of an unseen wall over weight", largestUnseenWallShare};
    walls.wish = Effect::Wish::off; // of any other wall than those that are seen
    addChosen(walls, !seen_.empty(), "case", keys, "the group solids", [this](AirMotion& air)
        { return stokesDragShare(fastestUnseen(), smallestGrain(), air.largestViscosity(), weight(), 1); });
    addChosen({rollingFriction, "coefficient, largest", 0}, dem_.hasRollingFriction(), "script", keys,
        "the contact model of the LIGGGHTS script", [this](AirMotion&) { return largestRollingFriction(dem_); });
    addChosen({cohesion, "Bond number of asperities of 0.1 um, A = 1e-19 J", largestBondNumber}, dem_.hasCohesion(),
        "script", keys, "the contact model of the LIGGGHTS script", [this](AirMotion&)
        { return bondNumber(usualHamaker, usualAsperity, usualGap, smallestGrain(), weight(), 1); });
}

void CaseEffects::addFixed(
    const Effect& effect, bool on, const Parameters& keys, const char* why, Number number)
{
    const Effect::Wish wish = EffectTable::wish(keys.name(effect.key, "auto"), keys.where(effect.key));
    if (contradicts(wish, on))
    {
        throw InputError({"Not every effect can be chosen.", effect.key + (on ? " off" : " on"),
            std::string(on ? "on" : "off") + " or auto", keys.where(effect.key), why});
    }
    enter(effect, on, on ? "always" : "lack", std::move(number));
}

// `elsewhere`: file and key that choose.
void CaseEffects::addChosen(const Effect& effect, bool on, const char* by, const Parameters& keys,
    const char* elsewhere, Number number)
{
    const Effect::Wish wish = EffectTable::wish(keys.name(effect.key, "auto"), keys.where(effect.key));
    if (contradicts(wish, on))
    {
        throw InputError({"Two files of the case contradict each other.",
            effect.key + (on ? " off" : " on") + " here, " + (on ? "on" : "off") + " by "
                + std::string(elsewhere),
            "the same in both", keys.where(effect.key),
            "Leave " + effect.key + " out here, or choose the same there."});
    }
    enter(effect, on, by, std::move(number));
}

// What is off is told if it would matter, and what is wished off though it is on: it is not on everywhere.
void CaseEffects::enter(Effect effect, bool on, const char* by, Number number)
{
    if (effect.wish == Effect::Wish::automatic)
    {
        effect.wish = on ? Effect::Wish::on : Effect::Wish::off;
    }
    effect.on = on;
    effect.by = by;
    entries_.push_back({table_.add(effect), std::move(number)});
}

// Of a volume of the lightest particle [N/m3].
double CaseEffects::weight() const
{
    return dem_.minimumDensity()*pullOn(dem_);
}

// [m]; infinite without particles.
double CaseEffects::smallestGrain() const
{
    return dem_.particleCount() > 0 ? 2*dem_.minimumRadius()/coarseGraining_ : GREAT;
}

// Of the walls' points of reference [m/s].
double CaseEffects::fastestUnseen() const
{
    double fastest = 0;
    for (const std::string& wall : dem_.meshWalls())
    {
        if (std::find(seen_.begin(), seen_.end(), wall) == seen_.end())
        {
            const WallPose pose = dem_.wallPose(wall);
            fastest = max(fastest, mag(vector(pose.velocity[0], pose.velocity[1], pose.velocity[2])));
        }
    }
    return fastest;
}

void CaseEffects::look(AirMotion& air, double time)
{
    for (const Entry& entry : entries_)
    {
        tell(table_, entry.place, entry.number(air), time);
    }
}

} // namespace interstice
