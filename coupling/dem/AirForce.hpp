// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/AirSpin.hpp"
#include "coupling/dem/DemEngine.hpp"

#include <memory>
#include <string>

namespace LAMMPS_NS
{
class LAMMPS;
class FixExternal;
class FixPropertyAtom;
} // namespace LAMMPS_NS

namespace interstice::dem
{

/// The air's forces inside LIGGGHTS: one row of numbers a particle, and a loop in every DEM step.
///
/// The rows are `fix property/atom`, so LIGGGHTS sorts them and sends them along with the
/// particles, and restart files keep them. The forces enter through `fix external`, which must act after every other force,
/// because the exact solution for drag needs the sum of the others.
///
/// A particle whose velocity or force is no number is held where it is, at rest: LIGGGHTS would end
/// the program as soon as it looks up its neighbours, before anything could be written.
class AirForce
{
public:
    /// Defines both fixes. Collective.
    explicit AirForce(LAMMPS_NS::LAMMPS& liggghts);

    /// Makes the force the last one again if a command has defined others. Collective.
    void actLast();

    /// Keeps all forces but the air's beside the particles, in restart files too. Local.
    void keepForces();

    /// After a set-up: takes the forces that were kept. LIGGGHTS' own are found with the velocities
    /// of the end of a step, not of its middle, so that each set-up would disturb the path. Local.
    void restoreForces();

    /// Local, as in DemEngine.
    void setGas(int slot, const GasState& gas, const Vector3& startImpulse);
    Vector3 impulse(int slot) const;
    AirAction action(int slot) const;

    /// From now on particles may take fluid along. Collective, once.
    void useAddedMass();
    bool usesAddedMass() const { return fluid_ != nullptr; }
    void setAddedMass(int slot, double mass); ///< local

    /// From now on the air may slow spins. Collective, once.
    void useSpinDrag();
    AirSpin* spin() { return spin_.get(); } ///< none before useSpinDrag(); local

    /// Starts an interval that ends with LIGGGHTS' step number `lastStep`: puts the half step
    /// that comes before the first new force into the forces that LIGGGHTS holds. Local.
    void begin(long long lastStep);

    /// Ends the interval: from now on the air is at rest. Local.
    void end();

    /// The first particle that had to be held, in words; empty if none had. Local.
    const std::string& held() const
    {
        return held_;
    }

private:
    void defineForce();
    template<class Body>
    void begin(const Body& body);
    void act(long long step, double** external);
    template<class Body>
    void act(long long step, double** external, const Body& body);
    template<class Body>
    void actOverWholeStep(double** external, const Body& body);
    template<class Body>
    void actOverClosingHalf(double** external, const Body& body);
    void hold(double** external);
    void describe(int slot, const double* external);

    LAMMPS_NS::LAMMPS& liggghts_;
    LAMMPS_NS::FixPropertyAtom* air_ = nullptr;
    LAMMPS_NS::FixPropertyAtom* kept_ = nullptr; ///< forces and torques
    LAMMPS_NS::FixPropertyAtom* fluid_ = nullptr; ///< that particles take along; only if they may
    LAMMPS_NS::FixExternal* force_ = nullptr;
    std::unique_ptr<AirSpin> spin_; ///< only if the air may slow spins
    bool blowing_ = false;
    long long lastStep_ = 0;
    std::string held_;
};

} // namespace interstice::dem
