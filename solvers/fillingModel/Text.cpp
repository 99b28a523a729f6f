// SPDX-License-Identifier: GPL-3.0-or-later
#include "Text.hpp"

#include <cstdarg>
#include <cstdio>

namespace interstice
{

std::string formatted(const char* format, ...)
{
    va_list list;
    va_start(list, format);
    va_list again;
    va_copy(again, list);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, list)), ' ');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    va_end(list);
    return text;
}

} // namespace interstice
