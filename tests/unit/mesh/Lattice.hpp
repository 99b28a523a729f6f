// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/unit/mesh/MeshTest.hpp"

#include <array>
#include <cmath>

namespace interstice
{

/// The box of the cases `walls` and `periodic` as an array, on every rank whole: for formulas that
/// know neither faces nor ranks.
class Lattice
{
public:
    explicit Lattice(bool periodic) : periodic_(periodic) {}

    static constexpr std::array<int, 3> cells{24, 20, 20};
    static constexpr std::array<double, 3> width{0.5e-3, 0.4e-3, 0.5e-3}; // [m]
    static constexpr double volume = width[0]*width[1]*width[2];

    static int count() { return cells[0]*cells[1]*cells[2]; }
    static int index(int i, int j, int k) { return i + cells[0]*(j + cells[1]*k); }

    /// The cell that holds a point of the box.
    static int indexAt(const Foam::point& p)
    {
        return index(int(p.x()/width[0]), int(p.y()/width[1]), int(p.z()/width[2]));
    }

    /// The row next to i in direction d: round the box, or i itself at a wall.
    int beside(int d, int i) const
    {
        return periodic_ ? (i + cells[d]) % cells[d] : std::min(std::max(i, 0), cells[d] - 1);
    }

    /// Adds q to the eight cells around a point by linear weights; at a wall the wall cell takes
    /// the share that would fall behind the wall.
    void addTrilinear(std::vector<double>& field, const Foam::point& p, double q) const
    {
        std::array<std::array<int, 2>, 3> row;
        std::array<std::array<double, 2>, 3> weight;
        for (int d = 0; d < 3; ++d)
        {
            const double x = p[d]/width[d] - 0.5;
            const double low = std::floor(x);
            row[d] = {beside(d, int(low)), beside(d, int(low) + 1)};
            weight[d] = {1 - (x - low), x - low};
        }
        for (int corner = 0; corner < 8; ++corner)
        {
            const int a = corner & 1;
            const int b = (corner >> 1) & 1;
            const int c = corner >> 2;
            field[index(row[0][a], row[1][b], row[2][c])] +=
                q*weight[0][a]*weight[1][b]*weight[2][c];
        }
    }

    /// Explicit steps of the heat equation, D t [m2] in all.
    void diffuse(std::vector<double>& field, double total, int steps) const
    {
        for (int step = 0; step < steps; ++step)
        {
            const std::vector<double> old(field);
            for (int n = 0; n < count(); ++n)
            {
                const std::array<int, 3> at{
                    n % cells[0], n/cells[0] % cells[1], n/cells[0]/cells[1]};
                for (int d = 0; d < 3; ++d)
                {
                    for (const int side : {-1, 1})
                    {
                        std::array<int, 3> next(at);
                        next[d] = beside(d, at[d] + side);
                        field[n] += total/steps/(width[d]*width[d])
                            *(old[index(next[0], next[1], next[2])] - old[n]);
                    }
                }
            }
        }
    }

private:
    bool periodic_;
};

} // namespace interstice
