// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"
#include "coupling/effects/EffectTable.hpp"
#include "coupling/forces/AirMotion.hpp"

#include <optional>
#include <vector>

namespace interstice
{

/// The air before it has moved.
struct AirAtRest
{
    double density; ///< [kg/m3]
    double viscosity; ///< dynamic, largest [Pa s]
};

/// A force of the air on parcels besides drag and pressure.
class ParcelForce
{
public:
    virtual ~ParcelForce() = default;

    /// Key, meaning of the number, and limit, for the table.
    virtual Effect effect() const = 0;

    /// What decides, if that is known before the air has moved. Collective.
    virtual std::optional<double> numberAtStart(const AirAtRest& /*air*/, const DemEngine& /*dem*/) const
    {
        return {};
    }

    /// What decides, as the air and the parcels are now: the largest over all ranks. Collective.
    virtual double number(AirMotion& air, const DemEngine& dem) const = 0;

    /// Gives the parcels of this rank the force for the coming interval. What a parcel is given is owed by
    /// the air: it goes off `own[slot].given`, like a remainder of drag, and is taken from the air in the
    /// next step. Collective.
    virtual void act(AirMotion& air, DemEngine& dem, std::vector<GasRecord>& own) = 0;

protected:
    /// A force that lasts for the interval.
    static void give(GasRecord& to, const Foam::vector& force, double interval)
    {
        for (int d = 0; d < 3; ++d)
        {
            to.force[d] += force[d];
            to.given[d] -= interval*force[d];
        }
    }

    /// A parcel that the air sees: in a cell, and not inside a solid.
    static bool seen(const GasRecord& gas) { return gas.dragCoefficient > 0; }
};

} // namespace interstice
