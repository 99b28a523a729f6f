// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Pstream.H"
#include "vector.H"

#include <array>
#include <fstream>
#include <string>

namespace interstice
{

/// Writes a box [m] with its centre in the origin as STL, and returns the path: each rank has its own
/// file. Fewer than 12 triangles leave it open.
inline std::string boxFile(const std::string& name, const Foam::vector& size, int triangles = 12)
{
    const std::array<std::array<int, 4>, 6> faces{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    const std::string path = name + std::to_string(Foam::Pstream::myProcNo()) + ".stl";
    std::ofstream file(path);
    file.precision(17);
    file << "solid box\n";
    for (int t = 0; t < triangles; ++t)
    {
        const auto& f = faces[t/2];
        file << "facet normal 0 0 0\nouter loop\n";
        for (const int corner : {f[0], t % 2 ? f[2] : f[1], t % 2 ? f[3] : f[2]})
        {
            file << "vertex " << (corner & 1 ? 0.5 : -0.5)*size.x() << ' '
                 << (corner & 2 ? 0.5 : -0.5)*size.y() << ' '
                 << (corner & 4 ? 0.5 : -0.5)*size.z() << '\n';
        }
        file << "endloop\nendfacet\n";
    }
    file << "endsolid box\n";
    return path;
}

} // namespace interstice
