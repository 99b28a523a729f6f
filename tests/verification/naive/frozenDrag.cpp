// SPDX-License-Identifier: GPL-3.0-or-later
//
// Naive: what the air does to a grain at the start of an interval, it does in all its DEM steps.
#include "coupling/dem/AirForce.hpp"

#include <lammps.h>

#include <atom.h>
#include <fix_external.h>
#include <fix_property_atom.h>
#include <update.h>

namespace interstice::dem
{

// Columns of a row: gas velocity, drag coefficient, force of the gas, drag impulse.
void AirForce::begin(long long lastStep)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    for (int i = 0; i < atom.nlocal; ++i)
    {
        double* air = air_->array_atom[i];
        double* applied = force_->fexternal[i];
        for (int k = 0; k < 3; ++k)
        {
            const double drag = air[3]*(air[k] - atom.v[i][k]);
            const double force = drag + air[4 + k];
            air[7 + k] += 0.5*liggghts_.update->dt*drag;
            atom.f[i][k] += force - applied[k];
            applied[k] = force;
        }
    }
    lastStep_ = lastStep;
    blowing_ = true;
}

void AirForce::act(long long step, double** external)
{
    const double share = !blowing_ ? 0 : step < lastStep_ ? 1 : 0.5;
    for (int i = 0; i < liggghts_.atom->nlocal; ++i)
    {
        double* air = air_->array_atom[i];
        for (int k = 0; k < 3; ++k)
        {
            external[i][k] *= blowing_;
            air[7 + k] += share*liggghts_.update->dt*(external[i][k] - air[4 + k]);
        }
    }
}

} // namespace interstice::dem
