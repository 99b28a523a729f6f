// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/CaseEffects.hpp"

#include "coupling/forces/tell.hpp"
#include "coupling/laws/EffectNumbers.hpp"
#include "coupling/laws/InputError.hpp"

#include "IOdictionary.H"

namespace interstice
{

using namespace Foam;

namespace
{

constexpr double largestBuoyancyShare = 0.01;

IOdictionary constantFile(const fvMesh& mesh, const char* name)
{
    return IOdictionary(IOobject(
        name, mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false));
}

} // namespace

CaseEffects::CaseEffects(const fvMesh& mesh, const Parameters& keys, EffectTable& table)
:
    table_(table)
{
    const IOdictionary transport(constantFile(mesh, "transportProperties"));
    const IOdictionary turbulence(constantFile(mesh, "turbulenceProperties"));
    const double atRest = transport.getOrDefault<scalar>("pressure", 101325);
    const double extent = cmptMin(mesh.bounds().span());

    add({"turbulence", "Reynolds number of the air", largestLaminarReynolds},
        turbulence.getOrDefault<word>("simulationType", "laminar") != "laminar", keys,
        "constant/turbulenceProperties, key simulationType",
        [extent](AirMotion& air, const DemEngine&) { return air.largestReynolds(extent); });
    add({"compressibility", "pressure over that at rest", largestSqueezedAirShare},
        transport.getOrDefault<word>("compressibility", "none") != "none", keys,
        "constant/transportProperties, key compressibility",
        [atRest](AirMotion& air, const DemEngine&) { return air.largestPressure()/atRest; });
    add({"airGravity", "buoyancy over weight", largestBuoyancyShare},
        mag(transport.getOrDefault<vector>("gravity", Zero)) > 0, keys,
        "constant/transportProperties, key gravity", [](AirMotion& air, const DemEngine& dem)
        { return dem.gravity() == Vector3{} ? 0 : air.density/dem.minimumDensity(); });
    add({"history", "Basset's force over Stokes' drag", largestHistoryShare}, false, keys,
        "nowhere: it is not available", [](AirMotion& air, const DemEngine& dem)
        { return historyShare(1, 1, dem.minimumDensity()/(18*air.density)); });
}

// `elsewhere`: file and key that choose.
void CaseEffects::add(
    Effect effect, bool on, const Parameters& keys, const char* elsewhere, Number number)
{
    const Effect::Wish wish = EffectTable::wish(keys.name(effect.key, "auto"), keys.where(effect.key));
    if (wish != Effect::Wish::automatic && (wish == Effect::Wish::on) != on)
    {
        throw InputError({"Two files of the case contradict each other.",
            effect.key + (on ? " off" : " on") + " here, " + (on ? "on" : "off") + " by "
                + std::string(elsewhere),
            "the same in both", keys.where(effect.key),
            "Leave " + effect.key + " out here, or choose the same there."});
    }
    effect.wish = on ? Effect::Wish::on : Effect::Wish::off;
    effect.by = "case";
    entries_.push_back({table_.add(effect), std::move(number)});
}

void CaseEffects::look(AirMotion& air, const DemEngine& dem, double time)
{
    for (const Entry& entry : entries_)
    {
        tell(table_, entry.place, entry.number(air, dem), time);
    }
}

} // namespace interstice
