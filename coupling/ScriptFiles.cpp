// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/ScriptFiles.hpp"

#include "coupling/laws/InputError.hpp"

#include "IFstream.H"
#include "OSspecific.H"
#include "dictionary.H"

#include <cstdio>
#include <vector>

namespace interstice
{

using namespace Foam;

fileName findScript(const std::string& name, const Time& time, const std::string& where)
{
    std::vector<fileName> places{fileName(name)};
    if (!places.front().isAbsolute())
    {
        places = {time.globalPath()/name, fileName(INTERSTICE_SOURCE_SCRIPTS)/name,
            fileName(INTERSTICE_INSTALLED_SCRIPTS)/name};
    }
    std::string wanted;
    for (const fileName& path : places)
    {
        if (isFile(path))
        {
            return path;
        }
        wanted += (wanted.empty() ? "a file " : "\nor ") + path;
    }
    throw InputError({"The LIGGGHTS script of the powder must exist.", name, wanted, where,
        "Correct the name or write the script."});
}

std::map<std::string, std::string> numbersIn(const fileName& path, const std::string& where)
{
    if (!isFile(path))
    {
        throw InputError({"The file of parameters must exist.", "no file " + path,
            "an OpenFOAM dictionary", where, "Correct the path."});
    }
    IFstream stream(path);
    const dictionary dict(stream);
    std::map<std::string, std::string> values;
    for (const entry& e : dict)
    {
        if (!e.isStream() || e.stream().size() != 1)
        {
            continue;
        }
        const token& t = e.stream()[0];
        if (t.isNumber())
        {
            char text[32];
            std::snprintf(text, sizeof text, "%.15g", double(t.number()));
            values[e.keyword()] = text;
        }
        else if (t.isWord() || t.isString())
        {
            values[e.keyword()] = t.isWord() ? std::string(t.wordToken())
                                             : std::string(t.stringToken());
        }
    }
    return values;
}

} // namespace interstice
