// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/unit/FoamTest.hpp"

#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/PowderState.hpp"

#include "IStringStream.H"
#include "Time.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>
#include <mpi.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace interstice
{

/// Spheres that a test puts on the mesh as its powder, dealt out to the ranks like cards: the same
/// list on every rank, and each rank owns its share.
class Spheres
{
public:
    static constexpr double density = 7360; ///< [kg/m3]

    void add(const Foam::vector& centre, double radius, const Foam::vector& velocity = Foam::Zero)
    {
        if (added_++ % Foam::Pstream::nProcs() == Foam::Pstream::myProcNo())
        {
            positions_.push_back({centre.x(), centre.y(), centre.z()});
            velocities_.push_back({velocity.x(), velocity.y(), velocity.z()});
            radii_.push_back(radius);
            masses_.push_back(massOf(radius));
            ids_.push_back(added_);
        }
    }

    static double massOf(double radius)
    {
        return density*4.0/3.0*Foam::constant::mathematical::pi*radius*radius*radius;
    }

    int count() const { return added_; } ///< on all ranks
    int own() const { return int(ids_.size()); }
    int id(int i) const { return ids_[i]; }
    void show(PowderState& state);

private:
    int added_ = 0;
    std::vector<std::array<double, 3>> positions_;
    std::vector<std::array<double, 3>> velocities_;
    std::vector<const double*> positionRows_;
    std::vector<const double*> velocityRows_;
    std::vector<double> radii_;
    std::vector<double> masses_;
    std::vector<int> ids_;
};

inline void Spheres::show(PowderState& state)
{
    positionRows_.clear();
    velocityRows_.clear();
    for (int i = 0; i < own(); ++i)
    {
        positionRows_.push_back(positions_[i].data());
        velocityRows_.push_back(velocities_[i].data());
    }
    state.count = own();
    state.position = positionRows_.data();
    state.velocity = velocityRows_.data();
    state.radius = radii_.data();
    state.mass = masses_.data();
    state.id = ids_.data();
    state.total = count();
}

/// A mesh and an empty powder, for function objects to act on. The mesh must be gone before the
/// clock of the case is, so it lives from the first to the last test of a suite.
class MeasureTest : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        mesh_ = std::make_unique<Foam::fvMesh>(
            Foam::IOobject(Foam::fvMesh::defaultRegion, "0", foamTime()));
    }
    static void TearDownTestSuite() { mesh_.reset(); }

    void SetUp() override { foamTime().setTime(0.0, 0); }

    static Foam::fvMesh& mesh() { return *mesh_; }

    static Foam::dictionary dictionary(const std::string& text)
    {
        Foam::IStringStream stream(text);
        return Foam::dictionary(stream);
    }

    /// A function object that writes no file.
    template<class Measure>
    static std::unique_ptr<Measure> make(const std::string& keys)
    {
        return std::make_unique<Measure>(
            "measure", foamTime(), dictionary("writeToFile off; " + keys));
    }

    PowderState powder{mesh()};

private:
    inline static std::unique_ptr<Foam::fvMesh> mesh_;
};

/// The problem that an action ends with; a failed test if it ends well.
template<class Action>
InputError::Problem problemOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const InputError& error)
    {
        return error.problem();
    }
    ADD_FAILURE() << "an InputError is wanted";
    return {};
}

} // namespace interstice
