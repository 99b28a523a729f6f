// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

namespace LAMMPS_NS
{
class LAMMPS;
class FixPropertyAtom;
} // namespace LAMMPS_NS

namespace interstice::dem
{

/// How the air slows the spin of particles inside LIGGGHTS: a torque c (w_air - w) in every DEM step, by the exact
/// solution for a spin and an air that nothing else changes meanwhile. Half steps at both ends of an interval, as for
/// drag (AirForce). All calls are local but for the constructor.
class AirSpin
{
public:
    /// Defines the particles' rows. Collective.
    explicit AirSpin(LAMMPS_NS::LAMMPS& liggghts);

    /// For the coming interval: the air's spin w_air [rad/s], and c [N m s].
    void set(int slot, const Vector3& spin, double coefficient);

    /// What is in LIGGGHTS' torque of this [N m].
    const double* applied(int slot) const;

    /// First half step of an interval: in the torques that LIGGGHTS holds, in the place of what is applied.
    void begin();

    /// Upon torques that LIGGGHTS has just found: over a whole step, or the half step that ends the interval.
    void act(bool wholeStep);

    /// LIGGGHTS has found all torques anew, and there is no air.
    void forget();

private:
    void act(double interval, bool held);

    LAMMPS_NS::LAMMPS& liggghts_;
    LAMMPS_NS::FixPropertyAtom* rows_;
};

} // namespace interstice::dem
