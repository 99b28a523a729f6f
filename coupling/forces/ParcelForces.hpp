// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/forces/CaseEffects.hpp"
#include "coupling/forces/ParcelForce.hpp"
#include "coupling/forces/Rarefaction.hpp"

#include <map>
#include <memory>
#include <string>

namespace interstice
{

/// The forces on parcels besides drag and pressure that a case can have: which it calls for, and what they do.
/// One that is left out costs a look at its number every 20 steps; one that the case has switched off for good
/// costs the same, since the user is told if it would have mattered.
class ParcelForces
{
public:
    /// Reads `effects`: a key a force, auto, on or off. Throws InputError for another key or word, and if grains
    /// of parcels are asked to do what only lone grains can. Local.
    ///
    /// Adds rows to `table`, which must outlive this, as `scene.dem` must.
    ParcelForces(const Scene& scene, const Foam::dictionary& effects, EffectTable& table);
    ~ParcelForces();

    /// First key of `effects` that is on and means nothing without air; empty if none is. Local. Throws as the constructor.
    static Foam::word wantedOfTheAir(const Foam::dictionary& effects);

    /// Collective. Decides what is known before the air has moved. `time` [s]. Throws InputError if a liquid is asked to
    /// slip as only a gas does.
    void start(const AirAtRest& air, const DemEngine& dem, double time);

    /// Collective. For the step that is done by the air and not yet by the powder.
    void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own, const Foam::Time& time);

    /// Collective. Goes on with the largest numbers of an earlier run, by key.
    void resume(const std::map<std::string, double>& largest, double time);

    /// Whether viscous stresses act on the powder; the air then keeps its own share of them only.
    bool viscous() const { return table_.on(viscous_); }

    /// Mean free path of the air's molecules if drag is to know of it, else zero [m].
    double freePath(const AirAtRest& air) const { return table_.on(rarefaction_) ? rarefied_->freePath(air) : 0; }

    /// Mass of fluid that parcels take along, by their volume [kg/m3].
    double addedDensity(double fluidDensity) const;

private:
    void look(AirMotion& air, const DemEngine& dem, double time);
    std::size_t add(std::unique_ptr<ParcelForce> force, Effect::Wish wish);

    struct Entry
    {
        std::unique_ptr<ParcelForce> force;
        std::size_t place; // in the table
    };
    std::vector<Entry> forces_;
    std::unique_ptr<CaseEffects> others_;
    EffectTable& table_;
    std::size_t virtualMass_; // places in the table
    std::size_t viscous_;
    std::size_t rarefaction_;
    const Rarefaction* rarefied_; // one of the forces
    std::string rarefactionAt_; // file and key
};

} // namespace interstice
