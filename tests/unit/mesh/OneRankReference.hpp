// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Pstream.H"
#include "fvMesh.H"
#include "labelIOList.H"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace interstice
{

/// On one rank: writes a field for the runs on more ranks. There: compares with it cell by cell,
/// to a tolerance relative to its largest value (interstice_mesh_test(... WITH_REFERENCE)).
inline void compareWithOneRank(const std::string& name, const Foam::fvMesh& mesh,
    const Foam::scalarField& field, double tolerance)
{
    // ctest starts each run in a folder <test>.np<ranks>.
    const std::filesystem::path here = std::filesystem::current_path();
    const std::filesystem::path folder =
        here.parent_path()/(here.stem().string() + ".np1")/(name + ".reference");
    if (!Foam::Pstream::parRun())
    {
        std::ofstream(folder, std::ios::binary)
            .write(reinterpret_cast<const char*>(field.cdata()), sizeof(double)*field.size());
        return;
    }

    std::vector<double> whole(std::filesystem::file_size(folder)/sizeof(double));
    std::ifstream(folder, std::ios::binary)
        .read(reinterpret_cast<char*>(whole.data()), sizeof(double)*whole.size());
    double largest = 0;
    for (const double value : whole)
    {
        largest = std::max(largest, std::abs(value));
    }
    const Foam::labelIOList cellOfWhole(Foam::IOobject("cellProcAddressing",
        mesh.facesInstance(), Foam::polyMesh::meshSubDir, mesh, Foam::IOobject::MUST_READ));
    ASSERT_EQ(cellOfWhole.size(), field.size());
    forAll(field, cell)
    {
        ASSERT_NEAR(field[cell], whole[cellOfWhole[cell]], tolerance*largest)
            << name << ", cell " << cell;
    }
}

} // namespace interstice
