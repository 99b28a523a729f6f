// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"
#include "coupling/effects/EffectTable.hpp"
#include "coupling/forces/AirMotion.hpp"
#include "coupling/mesh/Parameters.hpp"

#include <functional>
#include <string>
#include <vector>

namespace interstice
{

/// What decides on effects besides the air: the mesh, the particles, how many grains are one of them, and the mesh walls
/// that the air sees.
struct Scene
{
    const Foam::fvMesh& mesh;
    const DemEngine& dem;
    double coarseGraining;
    std::string coarseGrainingAt; ///< file and key
    std::vector<std::string> wallsInAir;
};

/// Whether constant/turbulenceProperties asks for a turbulence model. Local.
bool turbulent(const Foam::fvMesh& mesh);

/// Of the air, absolute: constant/transportProperties, or that of the atmosphere [Pa]. Local.
double pressureAtRest(const Foam::fvMesh& mesh);

/// Effects that other files of the case choose, or that nobody can: what they chose stands in the table, and the user is
/// told if the numbers of the run say otherwise.
///
/// `pressureGradient` always on; force on a volume of powder over its weight
/// `movingWalls`     group `solids`; drag at the speed of the fastest mesh wall that the air does not see, over weight
/// `turbulence`      simulationType of constant/turbulenceProperties; Reynolds number of the fastest air and the
///                   smallest extent of the mesh
/// `compressibility` of constant/transportProperties; pressure over the absolute one at rest
/// `airGravity`      gravity of constant/transportProperties; weight of the air over that of the lightest particle
/// `rollingFriction` contact model of the LIGGGHTS script; coefficient
/// `cohesion`        contact model of the LIGGGHTS script; van der Waals force of an asperity of 0.1 um over weight
/// `history`         Basset's force; not available
class CaseEffects
{
public:
    /// Adds rows to `table`, which must outlive this. `keys` is the group `effects`, in which a choice may be confirmed:
    /// throws InputError if it contradicts the other file or the nature of the effect. `scene.dem` must outlive this.
    /// Local.
    CaseEffects(const Scene& scene, const Parameters& keys, EffectTable& table);

    /// Whether the effect is one between particles, which wants no air. Local.
    static bool ofContacts(const Foam::word& key);

    /// Collective. The numbers as they are now.
    void look(AirMotion& air, double time);

private:
    using Number = std::function<double(AirMotion&)>;

    struct Entry
    {
        std::size_t place; // in the table
        Number number;
    };

    void addOfTheAir(const Scene& scene, const Parameters& keys);
    void addOfThePowder(const Parameters& keys);
    void addFixed(const Effect& effect, bool on, const Parameters& keys, const char* why, Number number);
    void addChosen(const Effect& effect, bool on, const char* by, const Parameters& keys, const char* elsewhere,
        Number number);
    void enter(Effect effect, bool on, const char* by, Number number);
    double weight() const;
    double smallestGrain() const;
    double fastestUnseen() const;

    EffectTable& table_;
    const DemEngine& dem_;
    double coarseGraining_;
    std::vector<std::string> seen_; // walls
    std::vector<Entry> entries_;
};

} // namespace interstice
