// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/DieCavity.hpp"
#include "coupling/mesh/measures/PowderMeasure.hpp"

#include <map>

namespace interstice
{

/// Where the powder is, and what the coupling has not settled yet.
///
/// Every particle counts whole in one place, that of its centre: the die, else the shoe, else
/// elsewhere (spilled). So
///
///     massInDie + massInShoe + massElsewhere + massMissing = massAtStart
///
/// holds to round-off; massMissing is what has left the simulation, and below zero what was
/// inserted since.
///
/// Columns, beside the masses [kg]: particles in the simulation, outside of every cell, and lost
/// since the start; the momentum [N s] that drag gave to the powder and that the air will lose in
/// the next step, and what drag gave in this step; powder [m3] that a full cell hid from the air
/// (clipped) or handed to its neighbours (moved), and what is inside solids, unseen (hidden).
///
/// Usage
///
///     powderBalance
///     {
///         type    powderBalance;
///         die     { low (0 0 -0.005); high (0.008 0.008 0); }
///         shoe    { wall "shoe"; low (-0.013 0 0); high (-0.001 0.008 0.03); }
///     }
///
/// Property       | Description                                   | Unit | Default
/// die            | see DieCavity                                 |      | none: nothing is in it
/// shoe           | room in the shoe                              |      | none: nothing is in it
/// shoe.wall      | LIGGGHTS id of the mesh wall it moves with    |      | shoe
/// shoe.low, high | corners of a box at the start; or shoe.surface, a closed surface | m | required
/// writePrecision | significant digits                            |      | 16
class PowderBalance final : public PowderMeasure
{
public:
    TypeName("powderBalance");

    PowderBalance(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;

private:
    std::vector<double> measure(const PowderState& powder) override;
    void readShoe(const Foam::dictionary& dict);

    std::unique_ptr<DieCavity> die_;
    std::unique_ptr<DieCavity> shoe_; // where it stood at the start
    std::string wall_;
    std::string where_;
};

} // namespace interstice
