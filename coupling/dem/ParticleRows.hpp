// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lammps.h>

#include <fix_property_atom.h>
#include <input.h>
#include <modify.h>

#include <string>

namespace interstice::dem
{

/// Numbers beside each particle, zero at first: LIGGGHTS sorts them and sends them along with the particles, and
/// restart files keep them. `count` is at least 2. Collective.
inline LAMMPS_NS::FixPropertyAtom* defineRows(LAMMPS_NS::LAMMPS& liggghts, const char* id, int count)
{
    std::string text = std::string("fix ") + id + " all property/atom " + id + " vector yes no no";
    for (int column = 0; column < count; ++column)
    {
        text += " 0.0";
    }
    liggghts.input->one(text.c_str());
    auto* rows = dynamic_cast<LAMMPS_NS::FixPropertyAtom*>(liggghts.modify->find_fix_id(id));
    rows->just_created = 0; // or else the next set-up would write zeros over what was kept until then
    return rows;
}

/// The same if the restart file that was read has them, with the numbers from there; else nothing. Before the first
/// set-up, which forgets the file. Collective.
inline LAMMPS_NS::FixPropertyAtom* rowsOfRestart(LAMMPS_NS::LAMMPS& liggghts, const char* id, int count)
{
    LAMMPS_NS::FixPropertyAtom* rows = defineRows(liggghts, id, count);
    if (liggghts.modify->have_restart_data(rows))
    {
        return rows;
    }
    liggghts.modify->delete_fix(id);
    return nullptr;
}

} // namespace interstice::dem
