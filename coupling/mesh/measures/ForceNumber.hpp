// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/DieCavity.hpp"
#include "coupling/mesh/measures/PowderMeasure.hpp"

namespace interstice
{

/// Force number: weight of the particles over what the air does to them, G_p/F_drag in Eq. 20 of
/// Materials 18 (2025) 3261.
///
///     forceNumber     = sum_i m_i |m_i g| / sum_i m_i |F_drag,i|                        [-]
///     withPressure    = sum_i m_i |m_i g| / sum_i m_i |F_drag,i - V_i grad(p)|          [-]
///
/// over the particles whose centre is in the die, and over all. A ratio of means, since the mean of
/// ratios would be ruled by the few particles that happen to move with the air. In a bed the
/// pressure part is as large as the drag; the study leaves it out. Parcels count as such: weight,
/// drag and volume all grow with k^3, so the number does not depend on k.
///
/// Forces are means over the last time step, drag as it really acted in it. Without air, or where
/// there is no powder, the number is inf or nan.
///
/// Usage
///
///     forceNumber
///     {
///         type    forceNumber;
///         die     { low (0 0 -0.005); high (0.008 0.008 0); }
///     }
///
/// Property | Description                                     | Unit  | Default
/// die      | see DieCavity                                   |       | required
/// gravity  | acceleration; that of the LIGGGHTS script if not given | m/s2 | that of the script
class ForceNumber final : public PowderMeasure
{
public:
    TypeName("forceNumber");

    ForceNumber(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;

private:
    std::vector<double> measure(const PowderState& powder) override;

    std::unique_ptr<DieCavity> die_;
    bool ownGravity_ = false;
    Foam::vector gravity_;
};

} // namespace interstice
