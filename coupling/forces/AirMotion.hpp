// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/mesh/PowderOnMesh.hpp"

#include <optional>
#include <vector>

namespace Foam
{
class turbulenceModel;
}

namespace interstice
{

/// Void fraction above which a grain feels what a lone sphere feels, and air is no bed's.
constexpr double loneGrainVoidFraction = 0.9;

/// How the air moves in a step: fields, and their values at the parcels of this rank, each made when it is
/// first asked for. All but the plain members are collective.
class AirMotion
{
public:
    /// Air at a parcel; all zero at one that no cell holds.
    struct Around
    {
        Foam::vector vorticity; ///< curl u [1/s]
        double viscosity; ///< dynamic [Pa s]
        double voidFraction;
    };

    /// Turbulence at a parcel; all zero at one that no cell holds, and in laminar air.
    struct Turbulence
    {
        double rms; ///< of one component of the velocity, sqrt(2 k/3) [m/s]
        double time; ///< Lagrangian time scale [s]
        Foam::vector gradient; ///< of rms [1/s]
    };

    /// `parcels`: how many this rank owns. `density` [kg/m3], kinematic viscosity `nu`.
    AirMotion(const Foam::volVectorField& U, const Foam::volScalarField& nu, double density,
        const PowderOnMesh& onMesh, const ParticleExchange& exchange, std::size_t parcels);

    const double density;
    const Foam::volScalarField& nu;
    const PowderOnMesh& onMesh;
    const double interval; ///< [s]
    const int step; ///< of time, from the start of the first run

    const Foam::volVectorField& vorticity(); ///< [1/s]

    /// mu div(grad(u)), largest where there is powder, over all ranks [Pa/m].
    double largestViscousForce() const;

    /// grad(p), largest where there is powder, over all ranks [Pa/m].
    double largestPressureForce() const;

    /// Of the fastest air outside of beds, with a length [m]; over all ranks.
    double largestReynolds(double length) const;

    /// Of turbulence, sqrt(2 k/3), largest where there are lone grains, over all ranks; zero for laminar air [m/s].
    double largestFluctuation() const;

    /// Dynamic, of all cells, over all ranks [Pa s].
    double largestViscosity() const;

    /// Of all cells, over all ranks [Pa].
    double largestPressure() const;

    const std::vector<Around>& around();

    std::vector<Turbulence> turbulence() const;

    /// du/dt + u.grad(u) at the parcels [m/s2].
    const std::vector<Foam::vector>& acceleration();

private:
    template<class Field>
    double largestInPowder(const Field& field) const;
    const Foam::volScalarField& pressure() const;
    const Foam::turbulenceModel& turbulenceOfCase() const;
    std::vector<Packed<5>> atParcels(Foam::List<Packed<5>>&& cells) const;

    const Foam::volVectorField& U_;
    const ParticleExchange& exchange_;
    std::size_t parcels_;
    std::optional<Foam::volVectorField> vorticity_;
    std::optional<std::vector<Around>> around_;
    std::optional<std::vector<Foam::vector>> acceleration_;
};

} // namespace interstice
