// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace interstice
{

/// Runs the program: the words after its name.
///
/// Returns what a shell expects: 0 if all went well, 1 if the input cannot be used (message on
/// `errors`), 2 if the command line is not understood.
int fillingModelProgram(
    const std::vector<std::string>& words, std::ostream& out, std::ostream& errors);

} // namespace interstice
