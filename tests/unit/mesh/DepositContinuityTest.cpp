// SPDX-License-Identifier: GPL-3.0-or-later
// What the time derivative of the void fraction needs: no cell's share of a particle may jump.
#include "tests/unit/mesh/PowderScene.hpp"

namespace interstice
{
namespace
{

using Foam::label;
using Foam::point;
using Foam::scalar;
using Foam::vector;

class DepositContinuityTest : public MeshTest
{
protected:
    static bool isUniform()
    {
        return Foam::gMax(mesh().V().field()) < 1.01*Foam::gMin(mesh().V().field());
    }

    /// Collective.
    static double cellSize() { return std::cbrt(Foam::gAverage(mesh().V().field())); }

    /// At an end of the mesh that is not periodic.
    static bool isOnWall(const point& p)
    {
        const Foam::boundBox& box = mesh().bounds();
        for (int d = 0; d < 3; ++d)
        {
            const double toEnd = std::min(p[d] - box.min()[d], box.max()[d] - p[d]);
            if (ground().box.period()[d] == 0 && toEnd < 1e-6)
            {
                return true;
            }
        }
        return false;
    }

    /// Some faces between two cells of this rank, of two ranks, and of a cyclic pair; with the
    /// middle of a face its edge and its corner.
    static std::vector<point> crossings()
    {
        std::vector<point> mine;
        const auto add = [&](label face)
        {
            const Foam::face& corners = mesh().faces()[face];
            const point& a = mesh().points()[corners[0]];
            const point& b = mesh().points()[corners[1]];
            for (const point& p : {mesh().faceCentres()[face], 0.5*(a + b), a})
            {
                if (!isOnWall(p))
                {
                    mine.push_back(p);
                }
            }
        };
        for (const double part : {0.3, 0.51})
        {
            add(label(part*mesh().nInternalFaces()));
        }
        for (const Foam::polyPatch& patch : mesh().boundaryMesh())
        {
            if (patch.coupled() && patch.size() > 0)
            {
                add(patch.start() + label(0.37*patch.size())); // not beside a wall
            }
        }
        return ofAllRanks(mine);
    }

    /// A particle that moves a little.
    struct Move
    {
        point from;
        point to;
    };

    /// The largest change of a cell's share in each of many particles, by its move.
    static std::vector<double> changes(const Foam::word& kernel, const std::vector<Move>& moves)
    {
        std::vector<point> places;
        for (const Move& move : moves)
        {
            places.push_back(move.from);
            places.push_back(move.to);
        }
        PowderScene scene(ground(), kernel);
        scene.place(places);

        // Thirty-two places at once, each as a quantity of its own.
        constexpr int batch = 32;
        std::vector<double> largest(moves.size(), 0);
        for (int first = 0; first < int(places.size()); first += batch)
        {
            const auto shares = scene.transfer().deposit<batch>(
                [&](int i)
                {
                    Packed<batch> q(Foam::Zero);
                    const int n = scene.handled().ids[i] - first;
                    if (n >= 0 && n < batch)
                    {
                        q[n] = 1;
                    }
                    return q;
                });
            forAll(shares, cell)
            {
                for (int n = 0; n < std::min(batch, int(places.size()) - first); n += 2)
                {
                    double& most = largest[(first + n)/2];
                    most = std::max(most, mesh().V()[cell]
                            *std::abs(shares[cell][n + 1] - shares[cell][n]));
                }
            }
        }
        MPI_Allreduce(MPI_IN_PLACE, largest.data(), int(largest.size()), MPI_DOUBLE, MPI_MAX,
            MPI_COMM_WORLD);
        return largest;
    }

    /// Across a face, an edge or a corner, also of ranks and cyclics; half of it in cell sizes.
    static std::vector<Move> movesAcross(double distance)
    {
        const vector oblique = distance*cellSize()*vector(0.6, -0.64, 0.48);
        std::vector<Move> moves;
        for (const point& p : crossings())
        {
            moves.push_back({p - oblique, p + oblique});
        }
        return moves;
    }
};

TEST_F(DepositContinuityTest, IsContinuousInTheParticlesPosition)
{
    const std::vector<double> change = changes("kernel", movesAcross(1e-9));

    ASSERT_GE(change.size(), 6u);
    for (std::size_t i = 0; i < change.size(); ++i)
    {
        EXPECT_LE(change[i], 1e-8) << "crossing " << i;
    }
}

// No weight may jump anywhere on the way: 300 steps of 1/100 of a cell, in which a share may
// change by no more than the steepest hats allow (the finest cells are half the average).
TEST_F(DepositContinuityTest, IsContinuousAlongAPathThroughTheMesh)
{
    const Foam::boundBox& box = mesh().bounds();
    const point start = box.min() + cmptMultiply(vector(0.45, 0.1, 0.05), box.span());
    const vector step = cellSize()/100*vector(0.36, 0.48, 0.8);
    std::vector<Move> moves;
    for (int n = 0; n < 300; ++n)
    {
        moves.push_back({start + scalar(n)*step, start + scalar(n + 1)*step});
    }

    const std::vector<double> change = changes("kernel", moves);

    const double steepest = isUniform() ? 0.03 : 0.06;
    for (std::size_t n = 0; n < change.size(); ++n)
    {
        EXPECT_LE(change[n], steepest) << "step " << n;
        EXPECT_GT(change[n], 0) << "step " << n;
    }
}

// The reason for the kernel: without it the particle leaves one cell for the next at once. (Nearer
// to a face than 1e-9 it may be in either cell.)
TEST_F(DepositContinuityTest, JumpsIfAParticleCountsWhereItsCentreIs)
{
    for (const double change : changes("centre", movesAcross(1e-8)))
    {
        EXPECT_NEAR(change, 1, 1e-12);
    }
}

} // namespace
} // namespace interstice
