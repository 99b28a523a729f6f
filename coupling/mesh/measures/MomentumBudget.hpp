// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/PowderMeasure.hpp"

namespace interstice
{

/// Momentum of air and powder, and what is on its way from one to the other.
///
/// In a box that nothing enters, leaves or pushes, with neither walls nor gravity,
///
///     air + powder - remainder = constant
///
/// holds to the tolerance of the pressure solver. The remainder is what drag gave to the powder
/// and the air has not lost yet; it loses it in the next step.
///
/// Columns [N s], each x, y, z: air, powder, remainder. The air's inertia in a step counts with
/// the void fraction of the step's beginning, as in its momentum equation:
///
///     air = sum rho alpha^n U^{n+1} V
///
/// Usage
///
///     momentumBudget
///     {
///         type    momentumBudget;
///     }
///
/// Property       | Description                                   | Unit | Default
/// writePrecision | significant digits                            |      | 16
class MomentumBudget final : public PowderMeasure
{
public:
    TypeName("momentumBudget");

    MomentumBudget(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;

private:
    std::vector<double> measure(const PowderState& powder) override;
    Foam::vector ofAir() const;
};

} // namespace interstice
