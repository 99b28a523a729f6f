// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/forces/AirMotion.hpp"

#include "coupling/laws/Dispersion.hpp"

#include "fvc.H"
#include "turbulenceModel.H"

#include <cmath>

namespace interstice
{

using namespace Foam;

AirMotion::AirMotion(const volVectorField& U, const volScalarField& viscosity, double rho,
    const PowderOnMesh& powder, const ParticleExchange& exchange, std::size_t parcels)
:
    density(rho),
    nu(viscosity),
    onMesh(powder),
    interval(U.time().deltaTValue()),
    step(U.time().timeIndex()),
    U_(U),
    exchange_(exchange),
    parcels_(parcels)
{}

const volVectorField& AirMotion::vorticity()
{
    if (!vorticity_)
    {
        vorticity_.emplace(fvc::curl(U_));
    }
    return *vorticity_;
}

double AirMotion::largestViscousForce() const
{
    return density*largestInPowder(fvc::laplacian(nu, U_, "laplacian(nuEff,U)")());
}

double AirMotion::largestPressureForce() const
{
    return density*largestInPowder(fvc::grad(pressure())());
}

const turbulenceModel& AirMotion::turbulenceOfCase() const
{
    return U_.db().lookupObject<turbulenceModel>(turbulenceModel::propertiesName);
}

double AirMotion::largestFluctuation() const
{
    const tmp<volScalarField> energy(turbulenceOfCase().k());
    double largest = 0;
    for (const int celli : onMesh.cells())
    {
        if (onMesh.voidFraction()[celli] > loneGrainVoidFraction)
        {
            largest = max(largest, energy()[celli]);
        }
    }
    return std::sqrt(2*returnReduce(largest, maxOp<double>())/3);
}

std::vector<AirMotion::Turbulence> AirMotion::turbulence() const
{
    const tmp<volScalarField> energy(turbulenceOfCase().k());
    const tmp<volScalarField> dissipation(turbulenceOfCase().epsilon());
    const volScalarField rms(sqrt(2.0/3.0*max(energy(), dimensionedScalar(energy().dimensions(), Zero))));
    const volVectorField gradient(fvc::grad(rms));
    List<Packed<5>> cells(rms.size());
    forAll(cells, celli)
    {
        const vector& g = gradient[celli];
        cells[celli] = {rms[celli], lagrangianTime(energy()[celli], dissipation()[celli]), g.x(), g.y(), g.z()};
    }
    std::vector<Turbulence> found;
    found.reserve(parcels_);
    for (const Packed<5>& air : atParcels(std::move(cells)))
    {
        found.push_back({air[0], air[1], vector(air[2], air[3], air[4])});
    }
    return found;
}

template<class Field>
double AirMotion::largestInPowder(const Field& field) const
{
    double largest = 0;
    for (const int celli : onMesh.cells())
    {
        largest = max(largest, mag(field[celli]));
    }
    return returnReduce(largest, maxOp<double>());
}

// Over density.
const volScalarField& AirMotion::pressure() const
{
    return U_.db().lookupObject<volScalarField>("p");
}

double AirMotion::largestReynolds(double length) const
{
    double largest = 0;
    forAll(U_, celli)
    {
        if (onMesh.voidFraction()[celli] > loneGrainVoidFraction)
        {
            largest = max(largest, mag(U_[celli])*length/nu[celli]);
        }
    }
    return returnReduce(largest, maxOp<double>());
}

double AirMotion::largestViscosity() const
{
    return density*gMax(nu.primitiveField());
}

double AirMotion::largestPressure() const
{
    return density*gMax(mag(pressure().primitiveField())());
}

std::vector<Packed<5>> AirMotion::atParcels(List<Packed<5>>&& cells) const
{
    std::vector<Packed<5>> own(parcels_, Packed<5>(Zero));
    exchange_.toOwners(onMesh.atParcels(std::move(cells)), own);
    return own;
}

const std::vector<AirMotion::Around>& AirMotion::around()
{
    if (!around_)
    {
        const volVectorField& curl = vorticity();
        List<Packed<5>> cells(curl.size());
        forAll(cells, celli)
        {
            const vector& w = curl[celli];
            cells[celli] = {w.x(), w.y(), w.z(), density*nu[celli], onMesh.voidFraction()[celli]};
        }
        around_.emplace();
        around_->reserve(parcels_);
        for (const Packed<5>& air : atParcels(std::move(cells)))
        {
            around_->push_back({vector(air[0], air[1], air[2]), air[3], air[4]});
        }
    }
    return *around_;
}

const std::vector<vector>& AirMotion::acceleration()
{
    if (!acceleration_)
    {
        const volVectorField rate(fvc::ddt(U_) + (U_ & fvc::grad(U_)));
        List<Packed<5>> cells(rate.size());
        forAll(cells, celli)
        {
            const vector& a = rate[celli];
            cells[celli] = {a.x(), a.y(), a.z(), 0, 0};
        }
        acceleration_.emplace();
        acceleration_->reserve(parcels_);
        for (const Packed<5>& air : atParcels(std::move(cells)))
        {
            acceleration_->push_back(vector(air[0], air[1], air[2]));
        }
    }
    return *acceleration_;
}

} // namespace interstice
