// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/Interstice.hpp"

#include "coupling/laws/DragLaw.hpp"

#include <cstdio>
#include <type_traits>

int main()
{
    // The front needs the library and OpenFOAM at link time; the laws say that it works.
    static_assert(!std::is_copy_constructible<interstice::CoupledPowder>::value, "one owner");
    const bool linked = &interstice::CoupledPowder::fall != nullptr;
    std::printf("%s %d\n", interstice::dragLaws().front().name.c_str(), linked);
    return 0;
}
