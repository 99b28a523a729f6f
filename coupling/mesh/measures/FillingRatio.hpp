// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/DieCavity.hpp"
#include "coupling/mesh/measures/PowderMeasure.hpp"

#include <array>

namespace interstice
{

/// Filling ratio of a die: mass of powder in it over the mass that fills it completely.
///
///     delta = m_r / m_c                                                              [-]
///
/// Eq. 17 of Materials 18 (2025) 3261. What sticks out of the mouth does not count (DieCavity).
///
/// A sliding shoe makes the number depend on when it is read, so three moments have a name. They
/// follow from how far the shoe's wall has gone along `direction`, for faces that stood at `front`
/// and `rear` at the start:
///
///     frontCrossed   the front face leaves the far edge of the die: all of its mouth is open
///     rearArrives    the rear face meets the near edge: the mouth begins to close
///     end            the run ends
///
/// They are written to postProcessing/<name>/<startTime>/moments.dat and to the log. The line a
/// step shows the filling ratio of the step before.
///
/// Usage
///
///     fillingRatio
///     {
///         type        fillingRatio;
///         die         { low (0 0 -0.005); high (0.008 0.008 0); }
///         fullMass    2.1e-3;
///         shoe        { wall "shoe"; direction (1 0 0); front -0.001; rear -0.013; }
///     }
///
/// Property     | Description                                     | Unit | Default
/// die          | see DieCavity                                   |      | required
/// fullMass     | mass that fills the die completely              | kg   | or fullMassFile
/// fullMassFile | file in the case that has a line "fullMass 1e-3;" |    | none
/// shoe         | without it only the end has a name              |      | none
/// shoe.wall    | LIGGGHTS id of the shoe's mesh wall             |      | shoe
/// shoe.direction | direction of travel                           |      | (1 0 0)
/// shoe.front   | inner face of the front wall at the start, along direction | m | required
/// shoe.rear    | inner face of the rear wall at the start, along direction  | m | required
class FillingRatio final : public PowderMeasure
{
public:
    TypeName("fillingRatio");

    FillingRatio(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;
    bool end() override;

    /// The value at a moment, or none if it has not come.
    bool reached(const word& moment, double& value) const;

private:
    struct Shoe
    {
        std::string wall;
        Foam::vector direction;
        double untilFrontCrossed; ///< travel [m]
        double untilRearArrives; ///< travel [m]
        std::string where;
    };

    std::vector<double> measure(const PowderState& powder) override;
    void readShoe(const Foam::dictionary& dict);
    void record(const word& moment, double value);

    std::unique_ptr<DieCavity> die_;
    double fullMass_ = 0;
    std::unique_ptr<Shoe> shoe_;
    Foam::autoPtr<Foam::OFstream> moments_;
};

} // namespace interstice
