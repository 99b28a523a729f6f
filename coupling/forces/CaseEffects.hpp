// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"
#include "coupling/effects/EffectTable.hpp"
#include "coupling/forces/AirMotion.hpp"
#include "coupling/mesh/Parameters.hpp"

#include <functional>
#include <vector>

namespace interstice
{

/// Effects that other files of the case choose, or that nobody can: what they chose stands in the table, and the user is
/// told if the numbers of the run say otherwise.
///
/// `turbulence`      simulationType of constant/turbulenceProperties; Reynolds number of the fastest air and the
///                   smallest extent of the mesh
/// `compressibility` of constant/transportProperties; pressure over the absolute one at rest
/// `airGravity`      gravity of constant/transportProperties; weight of the air over that of the lightest particle
/// `history`         Basset's force; not available
class CaseEffects
{
public:
    /// Adds rows to `table`, which must outlive this. `keys` is the group `effects`, in which a choice may be confirmed:
    /// throws InputError if it contradicts the other file, and for `history on`. Local.
    CaseEffects(const Foam::fvMesh& mesh, const Parameters& keys, EffectTable& table);

    /// Collective. The numbers as they are now.
    void look(AirMotion& air, const DemEngine& dem, double time);

private:
    using Number = std::function<double(AirMotion&, const DemEngine&)>;

    struct Entry
    {
        std::size_t place; // in the table
        Number number;
    };

    void add(Effect effect, bool on, const Parameters& keys, const char* elsewhere, Number number);

    EffectTable& table_;
    std::vector<Entry> entries_;
};

} // namespace interstice
