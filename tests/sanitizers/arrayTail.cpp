// SPDX-License-Identifier: GPL-3.0-or-later
/// Linked into programs under the address sanitizer. Loops over vectors in Debian's OpenFOAM read 8 bytes
/// behind the last one of a list, which ends the program where a page ends there. So each array gets
/// room behind it, which libraries may read and our own sources, being instrumented, may not.
#include <sanitizer/asan_interface.h>

#include <dlfcn.h>

#include <cstddef>

void* operator new[](std::size_t size)
{
    constexpr std::size_t tail = 16;
    static const auto ofSanitizer =
        reinterpret_cast<void* (*)(std::size_t)>(dlsym(RTLD_NEXT, "_Znam"));
    char* const array = static_cast<char*>(ofSanitizer(size + tail));
    ASAN_POISON_MEMORY_REGION(array + size, tail);
    return array;
}
