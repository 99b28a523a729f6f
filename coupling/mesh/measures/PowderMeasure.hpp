// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/Parameters.hpp"
#include "coupling/mesh/PowderState.hpp"

#include "fvMeshFunctionObject.H"
#include "writeFile.H"

#include <string>
#include <vector>

namespace interstice
{

/// What the function objects of the powder share: a table with one row a time, in
/// postProcessing/<name>/<startTime>/<name>.dat, whose first line names each column and its unit.
///
/// Values are computed in each time step and written when writeControl says so. Like every
/// function object they act on a time step when the next one begins, or at the end of the run.
/// The solver brings them along, so that a controlDict needs no `libs` for them.
///
/// Property       | Description                          | Unit | Default
/// writePrecision | significant digits in the table      |      | that of controlDict
/// writeToFile    | write the table                      |      | on
///
/// and all keys that OpenFOAM gives to every function object (enabled, writeControl, ...).
class PowderMeasure : public Foam::functionObjects::fvMeshFunctionObject,
                      public Foam::functionObjects::writeFile
{
public:
    bool execute() final;
    bool write() final;

    /// Values of the last execute(), in the order of the columns.
    const std::vector<double>& values() const { return values_; }

protected:
    using word = Foam::word; // TypeName names it

    /// `columns` such as "mass [kg]"; time comes first by itself.
    PowderMeasure(const word& name, const Foam::Time& time, const Foam::dictionary& dict,
        std::vector<std::string> columns);

    /// The values of a row, over all ranks. Collective.
    virtual std::vector<double> measure(const PowderState& powder) = 0;

    /// Declares the keys that every function object may have.
    static void declareCommon(const Parameters& parameters);

    /// How far a mesh wall has gone since the start [m]; `where`: file and key that name it.
    static Foam::vector travel(
        const PowderState& powder, const std::string& wall, const std::string& where);

    static Foam::vector toFoam(const double* v) { return {v[0], v[1], v[2]}; }

    /// Writes the line that names the columns.
    void head(Foam::Ostream& os, const std::vector<std::string>& columns) const;

private:
    std::vector<std::string> columns_;
    std::vector<double> values_;
};

} // namespace interstice
