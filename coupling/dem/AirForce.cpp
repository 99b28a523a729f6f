// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/AirForce.hpp"

#include "coupling/dem/ParticleRows.hpp"
#include "coupling/laws/ImplicitDrag.hpp"

#include <atom.h>
#include <fix_external.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interstice::dem
{

namespace
{

const char* const airId = "interstice_air";
const char* const keptId = "interstice_kept";
const char* const fluidId = "interstice_added_mass";
const char* const forceId = "interstice_force";

/// Columns of a particle's row.
enum Column
{
    gasVelocity = 0,     // 3
    dragCoefficient = 3, // b
    gasForce = 4,        // 3
    dragImpulse = 7,     // 3
    slipWeight = 10,     // b phi(x) over a whole step, x = b dt/m, or b dt/(m + m_a)
    restWeight = 11,     // phi(x) - 1
    startImpulse = 12,   // 3, where dragImpulse began
    columns = 15
};

/// Columns of a particle that takes fluid along.
enum FluidColumn
{
    addedMass = 0, // m_a
    ownShare = 1,  // m/(m + m_a)
    fluidColumns = 2
};

/// Particles by themselves.
struct Alone
{
    double inertia(int, double mass) const { return mass; }

    /// What LIGGGHTS is to be given besides the other forces.
    double force(int, double drag, double gas, double) const { return drag + gas; }

    /// What of it the air must give up besides `gas`.
    double owed(double drag, double, double) const { return drag; }
};

/// Particles with fluid that they take along: (m + m_a) dv/dt is the sum R of all forces but the one for that fluid.
/// LIGGGHTS divides by m, so that it must be given R m/(m + m_a).
struct WithFluid
{
    double** rows;

    double inertia(int i, double mass) const { return mass + rows[i][addedMass]; }

    double force(int i, double drag, double gas, double others) const
    {
        return rows[i][ownShare]*(others + gas + drag) - others;
    }

    double owed(double, double force, double gas) const { return force - gas; }
};

} // namespace

AirForce::AirForce(LAMMPS_NS::LAMMPS& liggghts) : liggghts_(liggghts)
{
    air_ = defineRows(liggghts, airId, columns);
    kept_ = defineRows(liggghts, keptId, 6);
    defineForce();
}

void AirForce::keepForces()
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    for (int i = 0; i < atom.nlocal; ++i)
    {
        double* row = kept_->array_atom[i];
        for (int k = 0; k < 3; ++k)
        {
            row[k] = atom.f[i][k] - force_->fexternal[i][k];
            row[3 + k] = atom.torque[i][k] - (spin_ ? spin_->applied(i)[k] : 0);
        }
    }
}

void AirForce::restoreForces()
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    for (int i = 0; i < atom.nlocal; ++i)
    {
        const double* row = kept_->array_atom[i];
        std::copy_n(row, 3, atom.f[i]);
        std::copy_n(row + 3, 3, atom.torque[i]);
    }
}

void AirForce::defineForce()
{
    const std::string text = std::string("fix ") + forceId + " all external pf/callback 1 1";
    liggghts_.input->one(text.c_str());
    force_ = dynamic_cast<LAMMPS_NS::FixExternal*>(liggghts_.modify->find_fix_id(forceId));
    force_->set_callback(
        [](void* self, LAMMPS_NS::bigint step, int, int*, double**, double** external)
        { static_cast<AirForce*>(self)->act(step, external); },
        this);
}

void AirForce::actLast()
{
    const LAMMPS_NS::Modify& modify = *liggghts_.modify;
    const auto isForce = [](int mask) { return (mask & LAMMPS_NS::FixConst::POST_FORCE) != 0; };
    const int after = liggghts_.modify->find_fix(forceId) + 1;

    if (std::any_of(modify.fmask + after, modify.fmask + modify.nfix, isForce))
    {
        liggghts_.input->one((std::string("unfix ") + forceId).c_str());
        defineForce();
    }
}

void AirForce::setGas(int slot, const GasState& gas, const Vector3& start)
{
    double* row = air_->array_atom[slot];
    row[dragCoefficient] = gas.dragCoefficient;
    for (int k = 0; k < 3; ++k)
    {
        row[gasVelocity + k] = gas.velocity[k];
        row[gasForce + k] = gas.force[k];
        row[dragImpulse + k] = start[k];
        row[startImpulse + k] = start[k];
    }
}

Vector3 AirForce::impulse(int slot) const
{
    const double* sum = air_->array_atom[slot] + dragImpulse;
    return {sum[0], sum[1], sum[2]};
}

AirAction AirForce::action(int slot) const
{
    const double* row = air_->array_atom[slot];
    AirAction action;
    for (int k = 0; k < 3; ++k)
    {
        action.dragImpulse[k] = row[dragImpulse + k] - row[startImpulse + k];
        action.force[k] = row[gasForce + k];
    }
    return action;
}

void AirForce::useAddedMass()
{
    fluid_ = defineRows(liggghts_, fluidId, fluidColumns);
}

void AirForce::setAddedMass(int slot, double mass)
{
    fluid_->array_atom[slot][addedMass] = mass;
}

void AirForce::useSpinDrag()
{
    spin_ = std::make_unique<AirSpin>(liggghts_);
}

void AirForce::begin(long long lastStep)
{
    if (fluid_)
    {
        const LAMMPS_NS::Atom& atom = *liggghts_.atom;
        for (int i = 0; i < atom.nlocal; ++i)
        {
            double* fluid = fluid_->array_atom[i];
            fluid[ownShare] = atom.rmass[i]/(atom.rmass[i] + fluid[addedMass]);
        }
        begin(WithFluid{fluid_->array_atom});
    }
    else
    {
        begin(Alone{});
    }
    if (spin_)
    {
        spin_->begin();
    }
    lastStep_ = lastStep;
    blowing_ = true;
}

template<class Body>
void AirForce::begin(const Body& body)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    const double dt = liggghts_.update->dt;

    for (int i = 0; i < atom.nlocal; ++i)
    {
        double* air = air_->array_atom[i];
        double* applied = force_->fexternal[i];
        const double b = air[dragCoefficient];
        const double inertia = body.inertia(i, atom.rmass[i]);

        // Fixed for the interval, so the exponentials are paid once.
        const double whole = meanSlip(b*dt/inertia);
        air[slipWeight] = b*whole;
        air[restWeight] = whole - 1;

        // LIGGGHTS still holds the last force of the interval before. Its second half step is
        // now taken in the new air.
        const ImplicitDrag opening(b, inertia, 0.5*dt);
        for (int k = 0; k < 3; ++k)
        {
            const double others = atom.f[i][k] - applied[k];
            const double gas = air[gasForce + k];
            const double drag = opening.force(air[gasVelocity + k] - atom.v[i][k], others + gas);
            const double force = body.force(i, drag, gas, others);
            air[dragImpulse + k] += 0.5*dt*body.owed(drag, force, gas);
            atom.f[i][k] += force - applied[k];
            applied[k] = force;
        }
    }
}

void AirForce::end()
{
    blowing_ = false;
}

void AirForce::act(long long step, double** external)
{
    if (!blowing_)
    {
        // A set-up, or a run by a command of the user: begin() counts on finding no air in it.
        for (int i = 0; i < liggghts_.atom->nlocal; ++i)
        {
            std::fill_n(external[i], 3, 0.0);
        }
        if (spin_)
        {
            spin_->forget();
        }
    }
    else if (fluid_)
    {
        act(step, external, WithFluid{fluid_->array_atom});
    }
    else
    {
        act(step, external, Alone{});
    }
    hold(external);
}

template<class Body>
void AirForce::act(long long step, double** external, const Body& body)
{
    if (step < lastStep_)
    {
        actOverWholeStep(external, body);
    }
    else
    {
        actOverClosingHalf(external, body);
    }
    if (spin_)
    {
        spin_->act(step < lastStep_);
    }
}

template<class Body>
void AirForce::actOverWholeStep(double** external, const Body& body)
{
    const int count = liggghts_.atom->nlocal;
    const double* const* velocity = liggghts_.atom->v;
    const double* const* others = liggghts_.atom->f;
    double** rows = air_->array_atom;
    const double dt = liggghts_.update->dt;

    for (int i = 0; i < count; ++i)
    {
        double* air = rows[i];
        const double onSlip = air[slipWeight];
        const double onRest = air[restWeight];
        for (int k = 0; k < 3; ++k)
        {
            const double slip = air[gasVelocity + k] - velocity[i][k];
            const double gas = air[gasForce + k];
            const double drag = onSlip*slip + onRest*(others[i][k] + gas);
            const double force = body.force(i, drag, gas, others[i][k]);
            air[dragImpulse + k] += dt*body.owed(drag, force, gas);
            external[i][k] = force;
        }
    }
}

template<class Body>
void AirForce::actOverClosingHalf(double** external, const Body& body)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    const double dt = liggghts_.update->dt;

    for (int i = 0; i < atom.nlocal; ++i)
    {
        double* air = air_->array_atom[i];
        const ImplicitDrag closing(air[dragCoefficient], body.inertia(i, atom.rmass[i]), 0.5*dt);
        for (int k = 0; k < 3; ++k)
        {
            const double gas = air[gasForce + k];
            const double drag =
                closing.force(air[gasVelocity + k] - atom.v[i][k], atom.f[i][k] + gas);
            const double force = body.force(i, drag, gas, atom.f[i][k]);
            air[dragImpulse + k] += 0.5*dt*body.owed(drag, force, gas);
            external[i][k] = force;
        }
    }
}

void AirForce::hold(double** external)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    for (int i = 0; i < atom.nlocal; ++i)
    {
        // Any sum with a value that is no number, or is infinite, is none either.
        double sum = 0;
        for (int k = 0; k < 3; ++k)
        {
            sum += atom.v[i][k] + atom.f[i][k] + external[i][k];
        }
        if (std::isfinite(sum))
        {
            continue;
        }
        if (held_.empty())
        {
            describe(i, external[i]);
        }
        std::fill_n(atom.v[i], 3, 0.0);
        std::fill_n(atom.omega[i], 3, 0.0);
        std::fill_n(atom.f[i], 3, 0.0);
        std::fill_n(atom.torque[i], 3, 0.0);
        std::fill_n(external[i], 3, 0.0);
        std::fill_n(air_->array_atom[i], static_cast<int>(columns), 0.0);
    }
}

void AirForce::describe(int slot, const double* external)
{
    const LAMMPS_NS::Atom& atom = *liggghts_.atom;
    const auto text = [](const double* x)
    {
        std::ostringstream words;
        words << '(' << x[0] << ' ' << x[1] << ' ' << x[2] << ')';
        return words.str();
    };
    std::ostringstream words;
    words << "particle " << atom.tag[slot] << " at " << text(atom.x[slot]) << " m: velocity "
          << text(atom.v[slot]) << " m/s, force of contacts and the script " << text(atom.f[slot])
          << " N, of the air " << text(external) << " N";
    held_ = words.str();
}

} // namespace interstice::dem
