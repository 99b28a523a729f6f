// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

#include "Time.H"
#include "boundBox.H"
#include "vector.H"

#include <map>
#include <optional>
#include <string>

namespace interstice
{

/// What a time folder needs besides OpenFOAM's fields so that a run can go on from it:
///
///     <time>/uniform/powder/dem.restart    LIGGGHTS' particles, contacts, walls (binary)
///     <time>/uniform/powder/checkpoint     this record; written last, so that what has it is whole
///
/// In the folder of the first rank; reconstructPar and decomposePar take `uniform` along, so a run
/// may go on on another number of ranks. A time folder that a kill has torn lacks the record: it is
/// set aside as `<time>.incomplete` when the next run starts, and the one before is the latest.
struct Checkpoint
{
    // Of the run
    double time = 0; ///< [s]; the folder's name has fewer digits
    double start = 0; ///< time from which the run's outputs are counted [s]
    double deltaT = 0; ///< of the last coupling step [s]
    int timeIndex = 0;
    double response = 0; ///< shortest tau_eff in the last step [s]
    double lag = 0; ///< by which the air saw the powder late [s]
    double initialMass = 0; ///< of all particles where the run began [kg]
    long long lost = 0; ///< particles so far
    std::map<std::string, double> effects; ///< largest number of each effect so far
    DemClockAndWalls dem;

    // By which it is known
    long long particles = 0;
    double mass = 0; ///< [kg]
    double coarseGraining = 1;
    int cells = 0; ///< of the mesh, all ranks
    Foam::boundBox bounds; ///< of the mesh, all ranks
    Foam::vector owed = Foam::Zero; ///< sum of the drag impulses that the air has not lost yet [N s]

    /// File of the particles for a time folder; makes the folder, and takes away a record that is
    /// there. Collective.
    static Foam::fileName begin(const Foam::Time& time);

    /// Writes the record of what begin() began. Collective, when all ranks have written their fields.
    void complete(const Foam::Time& time) const;

    /// The checkpoint of a time folder, none if it has none. Throws InputError if its particles are
    /// not those that were written. Collective.
    static std::optional<Checkpoint> of(const Foam::Time& time);

    /// File of the particles of a time folder.
    static Foam::fileName particlesOf(const Foam::Time& time);

    /// Renames the time folders of `casePath` (of this rank: processorN) that a run of ours began and
    /// did not complete. Returns their names. Collective, before the clock looks for the latest time.
    static Foam::wordList setAsideIncomplete(const Foam::fileName& casePath);

    /// Throws InputError if a run that is resumed has another mesh or other particles. Same on all
    /// ranks.
    void requireSame(const Checkpoint& now) const;
};

} // namespace interstice
