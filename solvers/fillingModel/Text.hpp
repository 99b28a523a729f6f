// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interstice
{

/// What printf would print.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

} // namespace interstice
