// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/ParcelForces.hpp"

#include "coupling/forces/Dispersion.hpp"
#include "coupling/forces/ShearLift.hpp"
#include "coupling/forces/SpinLift.hpp"
#include "coupling/forces/VirtualMass.hpp"
#include "coupling/forces/ViscousForce.hpp"
#include "coupling/forces/tell.hpp"
#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/Parameters.hpp"

#include "Time.H"

namespace interstice
{

using namespace Foam;

namespace
{

void requireGrains(double coarseGraining, const std::string& key, const std::string& where)
{
    if (coarseGraining > 1)
    {
        throw InputError({"The spin of a parcel is that of none of its grains.",
            "spinLift on, coarseGraining " + Foam::name(coarseGraining), "spinLift off or auto, or coarseGraining 1",
            key + "; " + where, "Leave spinLift out, or simulate the grains themselves."});
    }
}

void requireGas(double density, const std::string& key)
{
    if (!Rarefaction::isGas(density))
    {
        throw InputError({"Only a gas slips on grains.", "rarefaction on, " + Foam::name(density) + " kg/m3",
            "rarefaction off or auto, or a gas: " + Foam::name(Rarefaction::densestGas) + " kg/m3 at most",
            key + "; constant/transportProperties, key rho",
            "Leave rarefaction out: molecules of a liquid have no free path."});
    }
}

void requireTurbulence(const fvMesh& mesh, const std::string& key)
{
    if (!turbulent(mesh))
    {
        throw InputError({"Fluctuations of the air are those of a turbulence model.", "dispersion on, laminar air",
            "dispersion off or auto, or a turbulence model",
            key + "; constant/turbulenceProperties, key simulationType",
            "Leave dispersion out, or choose a model: simulationType RAS."});
    }
}

} // namespace

ParcelForces::ParcelForces(const Scene& scene, const dictionary& effects, EffectTable& table)
:
    table_(table)
{
    const Parameters p(effects);
    const auto wish = [&p](const char* key) { return EffectTable::wish(p.name(key, "auto"), p.where(key)); };

    add(std::make_unique<ShearLift>(scene.coarseGraining), wish("shearLift"));
    virtualMass_ = add(std::make_unique<VirtualMass>(), wish("virtualMass"));
    viscous_ = add(std::make_unique<ViscousForce>(), wish("viscousForce"));
    const Effect::Wish spin = wish("spinLift");
    if (spin == Effect::Wish::on)
    {
        requireGrains(scene.coarseGraining, p.where("spinLift"), scene.coarseGrainingAt);
    }
    if (scene.coarseGraining <= 1)
    {
        add(std::make_unique<SpinLift>(), spin);
    }
    const Effect::Wish gusts = wish("dispersion");
    if (gusts == Effect::Wish::on)
    {
        requireTurbulence(scene.mesh, p.where("dispersion"));
    }
    add(std::make_unique<Dispersion>(scene.coarseGraining), gusts);
    auto rarefied = std::make_unique<Rarefaction>(scene.coarseGraining, pressureAtRest(scene.mesh));
    rarefied_ = rarefied.get();
    rarefaction_ = add(std::move(rarefied), wish("rarefaction"));
    rarefactionAt_ = p.where("rarefaction");
    others_ = std::make_unique<CaseEffects>(scene, p, table);
    p.allKnown();
}

ParcelForces::~ParcelForces() = default;

word ParcelForces::wantedOfTheAir(const dictionary& effects)
{
    const Parameters p(effects);
    for (const word& key : effects.sortedToc())
    {
        if (!CaseEffects::ofContacts(key) && EffectTable::wish(p.name(key, "auto"), p.where(key)) == Effect::Wish::on)
        {
            return key;
        }
    }
    return {};
}

std::size_t ParcelForces::add(std::unique_ptr<ParcelForce> force, Effect::Wish wish)
{
    Effect effect = force->effect();
    effect.wish = wish;
    forces_.push_back({std::move(force), table_.add(effect)});
    return forces_.back().place;
}

double ParcelForces::addedDensity(double fluidDensity) const
{
    return table_.on(virtualMass_) ? VirtualMass::coefficient*fluidDensity : 0;
}

void ParcelForces::resume(const std::map<std::string, double>& largest, double time)
{
    for (const Entry& entry : forces_)
    {
        const auto found = largest.find(table_.effects()[entry.place].key);
        if (found != largest.end())
        {
            table_.meet(entry.place, found->second, time);
        }
    }
}

void ParcelForces::start(const AirAtRest& air, const DemEngine& dem, double time)
{
    if (table_.effects()[rarefaction_].wish == Effect::Wish::on)
    {
        requireGas(air.density, rarefactionAt_);
    }
    for (const Entry& entry : forces_)
    {
        if (const std::optional<double> number = entry.force->numberAtStart(air, dem))
        {
            tell(table_, entry.place, *number, time);
        }
    }
}

void ParcelForces::look(AirMotion& air, const DemEngine& dem, double time)
{
    for (const Entry& entry : forces_)
    {
        tell(table_, entry.place, entry.force->number(air, dem), time);
    }
    others_->look(air, time);
}

void ParcelForces::act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own, const Time& time)
{
    if (lookDue(time))
    {
        look(air, dem, time.value());
    }
    for (const Entry& entry : forces_)
    {
        if (table_.on(entry.place))
        {
            const EffectTable::Timed timed(table_, entry.place);
            entry.force->act(air, dem, own);
        }
    }
}

} // namespace interstice
