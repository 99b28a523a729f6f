// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/PowderMeasure.hpp"

#include "coupling/laws/InputError.hpp"

#include "fvMesh.H"

namespace interstice
{

using namespace Foam;

PowderMeasure::PowderMeasure(const word& name, const Time& time, const dictionary& dict,
    std::vector<std::string> columns)
:
    fvMeshFunctionObject(name, time, dict),
    writeFile(mesh_, name, name, dict),
    columns_(std::move(columns))
{
    if (writeToFile())
    {
        head(file(), columns_);
    }
}

void PowderMeasure::declareCommon(const Parameters& parameters)
{
    for (const char* key : {"type", "libs", "functionObjectLibs", "enabled", "region", "log",
             "timeStart", "timeEnd", "controlMode", "triggerStart", "triggerEnd",
             "nStepsToStartTimeChange", "executeControl", "executeInterval", "writeControl",
             "writeInterval", "writePrecision", "writeToFile", "useUserTime"})
    {
        parameters.has(key);
    }
}

bool PowderMeasure::execute()
{
    if (!mesh_.foundObject<PowderState>(PowderState::registryName))
    {
        throw InputError({"This function object measures powder.", "no powder on the mesh",
            "a run of demPimpleFoam", "system/controlDict, functions, " + name(),
            "Remove it, or run it with the solver."});
    }
    values_ = measure(PowderState::of(mesh_));
    return true;
}

bool PowderMeasure::write()
{
    if (writeToFile() && !values_.empty())
    {
        Ostream& os = file();
        writeCurrentTime(os);
        for (const double value : values_)
        {
            os << tab << value;
        }
        os << endl;
    }
    return true;
}

vector PowderMeasure::travel(
    const PowderState& powder, const std::string& wall, const std::string& where)
{
    const auto found = powder.wallTravel.find(wall);
    if (found == powder.wallTravel.end())
    {
        std::vector<std::string> walls;
        for (const auto& known : powder.wallTravel)
        {
            walls.push_back(known.first);
        }
        throw unknownName("mesh wall of the LIGGGHTS script", wall, walls, where);
    }
    return found->second;
}

void PowderMeasure::head(Ostream& os, const std::vector<std::string>& columns) const
{
    os << setw(0) << "# time [s]";
    for (const std::string& column : columns)
    {
        os << tab << column.c_str();
    }
    os << endl;
}

} // namespace interstice
