// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Time.H"
#include "regIOobject.H"
#include "vectorField.H"

#include <map>
#include <string>

namespace interstice
{

/// The powder as function objects see it, registered with the mesh as "powderState".
///
/// Particles owned by this rank, in place; void when the next time step begins. Parcels where the
/// powder is coarse grained. The sums at the end are over all ranks.
class PowderState : public Foam::regIOobject
{
public:
    /// Not "powder": that is the cloud of particles on the disk.
    static constexpr const char* registryName = "powderState";

    explicit PowderState(const Foam::objectRegistry& registry)
    :
        Foam::regIOobject(Foam::IOobject(registryName, registry.time().timeName(), registry,
            Foam::IOobject::NO_READ, Foam::IOobject::NO_WRITE))
    {}

    bool writeData(Foam::Ostream& os) const override { return os.good(); }

    static const PowderState& of(const Foam::objectRegistry& registry)
    {
        return registry.lookupObject<PowderState>(registryName);
    }

    // Own particles, [i] for i < count
    int count = 0;
    const double* const* position = nullptr; ///< [m]
    const double* const* velocity = nullptr; ///< [m/s]
    const double* radius = nullptr; ///< [m]
    const double* mass = nullptr; ///< [kg]
    const int* id = nullptr;
    Foam::vectorField drag; ///< mean over the last interval [N]; empty without air
    Foam::vectorField pressureForce; ///< -V grad(p) over the last interval [N]; empty without air

    // Where the powder started
    Foam::scalar initialMass = 0; ///< of all particles at the start [kg]

    // Of the last step
    Foam::scalar interval = 0; ///< coupling interval [s]
    Foam::vector momentumRemainder = Foam::Zero; ///< waiting to be given to the air [N s]
    Foam::vector stepImpulse = Foam::Zero; ///< given to the powder by drag [N s]
    Foam::scalar clippedVolume = 0; ///< of powder not seen by the air [m3]
    Foam::scalar movedVolume = 0; ///< handed to neighbour cells by the floor [m3]
    Foam::scalar hiddenVolume = 0; ///< of powder inside solids, not seen by the air [m3]
    int hidden = 0; ///< particles inside solids, at least in part
    long long total = 0; ///< particles
    long long outside = 0; ///< particles that no cell holds
    long long lost = 0; ///< particles gone from the simulation since the start

    /// Short notes for the line a step, such as "filling 31.2 %", by their name.
    mutable std::map<std::string, std::string> notes;

    /// Gravity as the powder feels it [m/s2].
    Foam::vector gravity = Foam::Zero;

    /// Rigid walls seen so far: position of each mesh wall relative to its start [m].
    std::map<std::string, Foam::vector> wallTravel;
};

} // namespace interstice
