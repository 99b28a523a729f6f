// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/AirSpin.hpp"

#include "coupling/dem/ParticleRows.hpp"
#include "coupling/laws/ImplicitDrag.hpp"

#include <atom.h>
#include <update.h>

#include <algorithm>

namespace interstice::dem
{

namespace
{

enum Column
{
    airSpin = 0,     // 3
    coefficient = 3, // c
    torque = 4,      // 3, applied
    columns = 7
};

} // namespace

AirSpin::AirSpin(LAMMPS_NS::LAMMPS& liggghts)
    : liggghts_(liggghts), rows_(defineRows(liggghts, "interstice_spin", columns))
{
}

void AirSpin::set(int slot, const Vector3& spin, double c)
{
    double* row = rows_->array_atom[slot];
    std::copy(spin.begin(), spin.end(), row + airSpin);
    row[coefficient] = c;
}

const double* AirSpin::applied(int slot) const
{
    return rows_->array_atom[slot] + torque;
}

// `held`: what LIGGGHTS' torques contain of this already.
void AirSpin::act(double interval, bool held)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    for (int i = 0; i < atom.nlocal; ++i)
    {
        double* row = rows_->array_atom[i];
        const double inertia = 0.4*atom.rmass[i]*atom.radius[i]*atom.radius[i];
        const ImplicitDrag drag(row[coefficient], inertia, interval);
        for (int k = 0; k < 3; ++k)
        {
            const double others = atom.torque[i][k] - (held ? row[torque + k] : 0);
            row[torque + k] = drag.force(row[airSpin + k] - atom.omega[i][k], others);
            atom.torque[i][k] = others + row[torque + k];
        }
    }
}

void AirSpin::begin()
{
    act(0.5*liggghts_.update->dt, true);
}

void AirSpin::act(bool wholeStep)
{
    act(wholeStep ? liggghts_.update->dt : 0.5*liggghts_.update->dt, false);
}

void AirSpin::forget()
{
    for (int i = 0; i < liggghts_.atom->nlocal; ++i)
    {
        std::fill_n(rows_->array_atom[i] + torque, 3, 0.0);
    }
}

} // namespace interstice::dem
