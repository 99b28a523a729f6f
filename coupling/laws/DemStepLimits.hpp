// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace interstice
{

/// Materials as a contact model has them, by type. Lists that are shorter repeat their last value.
struct ContactMaterials
{
    std::vector<double> youngsModulus; ///< [Pa]
    std::vector<double> poissonsRatio;
    std::vector<bool> ofParticles; ///< whether there are particles of this type; else it is a wall's
    double restitution = 1; ///< the smallest of all pairs
    bool rough = false; ///< some pair has friction
};

/// What a DEM step is measured by.
struct DemStepLimits
{
    double rayleigh; ///< Rayleigh time of the particles [s]; infinite without particles
    double hertz; ///< duration of the shortest impact [s]
    double dashpot; ///< with which friction's dashpot does not make slip grow [s]

    /// Beyond this contacts gain energy [s].
    double longestStep() const;
};

/// Of contacts between particles of radius [m] and density [kg/m3] (those of the shortest Rayleigh time), and
/// with walls, that meet at `speed` [m/s].
///
/// A wave runs through particles only, so walls have no Rayleigh time. In an impact both yield: against
/// a wall that is far stiffer a contact is at most twice as stiff as between two particles. An impact
/// counts as one of two particles; against a wall of the same stiffness it takes 15 % longer.
DemStepLimits demStepLimits(
    const ContactMaterials& materials, double radius, double density, double speed);

} // namespace interstice
