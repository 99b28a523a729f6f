// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DragLaw.hpp"

#include "coupling/laws/InputError.hpp"
#include "coupling/laws/drag/BeetstraDrag.hpp"
#include "coupling/laws/drag/DiFeliceDrag.hpp"
#include "coupling/laws/drag/ErgunWenYuDrag.hpp"
#include "coupling/laws/drag/GidaspowHuilinDrag.hpp"
#include "coupling/laws/drag/GidaspowSwitchDrag.hpp"
#include "coupling/laws/drag/KochHillDrag.hpp"
#include "coupling/laws/drag/SchillerNaumannDrag.hpp"
#include "coupling/laws/drag/StokesDrag.hpp"

#include <sstream>

namespace interstice
{

namespace
{

using Maker = std::unique_ptr<DragLaw> (*)(const DragOptions&);

struct Row
{
    DragLawEntry entry;
    Maker make;
};

template<class Law>
std::unique_ptr<DragLaw> makePlain(const DragOptions&)
{
    return std::make_unique<Law>();
}

std::unique_ptr<DragLaw> makeGidaspowHuilin(const DragOptions& options)
{
    return std::make_unique<GidaspowHuilinDrag>(options);
}

const std::vector<Row>& table()
{
    static const std::vector<Row> rows{
        {{"GidaspowHuilin",
             "Ergun in the bed, Wen-Yu in the suspension, smoothly blended at a void fraction of "
             "0.8.",
             "Huilin & Gidaspow 2003"},
            makeGidaspowHuilin},
        {{"GidaspowSwitch", "The same two laws with a hard switch at 0.8.", "Gidaspow 1994"},
            makePlain<GidaspowSwitchDrag>},
        {{"ErgunWenYu", "As GidaspowSwitch, with the sphere's constant drag from Re = 1000 on.",
             "Ergun 1952, Wen & Yu 1966"},
            makePlain<ErgunWenYuDrag>},
        {{"DiFelice", "A lone sphere times a power of the void fraction; no switch.",
             "Di Felice 1994"},
            makePlain<DiFeliceDrag>},
        {{"KochHill", "Lattice-Boltzmann fit for random arrays of spheres.", "Koch & Hill 2001"},
            makePlain<KochHillDrag>},
        {{"Beetstra", "Lattice-Boltzmann fit for random arrays of spheres up to Re = 1000.",
             "Beetstra, van der Hoef & Kuipers 2007"},
            makePlain<BeetstraDrag>},
        {{"SchillerNaumann", "A lone sphere; does not know the void fraction.",
             "Schiller & Naumann 1933"},
            makePlain<SchillerNaumannDrag>},
        {{"Stokes", "A lone sphere in creeping flow.", "Stokes 1851"}, makePlain<StokesDrag>},
    };
    return rows;
}

void checkSphericity(const DragOptions& options, const std::string& where)
{
    if (options.sphericity > 0 && options.sphericity <= 1)
    {
        return;
    }

    std::ostringstream found;
    found << options.sphericity;
    throw InputError({"The sphericity of the grains is out of its range.", found.str(),
        "above 0, at most 1", where, "Set it to 1 for spheres; crushed powders have 0.6 to 0.9."});
}

} // namespace

const std::vector<DragLawEntry>& dragLaws()
{
    static const std::vector<DragLawEntry> entries = []
    {
        std::vector<DragLawEntry> list;
        for (const Row& row : table())
        {
            list.push_back(row.entry);
        }
        return list;
    }();
    return entries;
}

std::unique_ptr<DragLaw> makeDragLaw(
    const std::string& name, const DragOptions& options, const std::string& where)
{
    checkSphericity(options, where);

    std::vector<std::string> names;
    for (const Row& row : table())
    {
        if (row.entry.name == name)
        {
            return row.make(options);
        }
        names.push_back(row.entry.name);
    }
    throw unknownName("drag law", name, names, where);
}

} // namespace interstice
