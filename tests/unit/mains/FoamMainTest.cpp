// SPDX-License-Identifier: GPL-3.0-or-later
// The ground that tests with OpenFOAM stand on: case, ranks, errors.
#include "tests/unit/FoamTest.hpp"

#include "fvCFD.H"

#include <gtest/gtest.h>
#include <mpi.h>

namespace
{

TEST(FoamTestMain, GivesAMeshWhoseVolumeIsTheBoxOnAnyNumberOfRanks)
{
    const Foam::fvMesh mesh(
        Foam::IOobject(Foam::fvMesh::defaultRegion, "0", interstice::foamTime()));

    EXPECT_NEAR(Foam::gSum(mesh.V()), 1.0, 1e-12);
    EXPECT_EQ(Foam::returnReduce(mesh.nCells(), Foam::sumOp<Foam::label>()), 64);
}

TEST(FoamTestMain, HasOneOpenFoamRankForEachMpiRank)
{
    int size = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);

    EXPECT_EQ(Foam::UPstream::nProcs(), size);
}

TEST(FoamTestMain, TurnsAFatalErrorIntoAnException)
{
    EXPECT_THROW(FatalErrorInFunction << "on purpose" << Foam::abort(Foam::FatalError),
        Foam::error);
}

} // namespace
