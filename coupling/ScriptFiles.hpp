// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Time.H"

#include <map>
#include <string>

namespace interstice
{

/// The LIGGGHTS script of a case: an absolute path; or one relative to the case folder, else the name of
/// a script that comes with the library. Throws InputError naming the places.
Foam::fileName findScript(
    const std::string& name, const Foam::Time& time, const std::string& where);

/// All numbers and words that stand at the top of an OpenFOAM dictionary file, as text, by their
/// key: one file then feeds both engines. Throws InputError if there is no such file.
std::map<std::string, std::string> numbersIn(
    const Foam::fileName& dictionary, const std::string& where);

} // namespace interstice
