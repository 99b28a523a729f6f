// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/PowderOnMesh.hpp"

#include "coupling/laws/ImplicitDrag.hpp"
#include "coupling/laws/drag/RarefiedDrag.hpp"
#include "coupling/laws/sphereVolume.hpp"

#include "zeroGradientFvPatchFields.H"

namespace interstice
{

using namespace Foam;

namespace
{

template<class Type>
GeometricField<Type, fvPatchField, volMesh> cellField(const fvMesh& mesh, const word& name,
    const dimensionSet& dimensions, const Type& value, IOobject::writeOption write)
{
    return GeometricField<Type, fvPatchField, volMesh>(
        IOobject(name, mesh.time().timeName(), mesh, IOobject::NO_READ, write), mesh,
        dimensioned<Type>(name, dimensions, value), zeroGradientFvPatchField<Type>::typeName);
}

// Cells whose void fractions differ by less are one to the drag law: its curvature then changes
// the mean by 0.1 % at most.
constexpr double uniformVoidFraction = 0.02;

vector toFoam(const Vec3& v)
{
    return vector(v[0], v[1], v[2]);
}

// Pressure gradient that the powder of each cell feels: that of the cells in which the air sees it. Drag
// is not moved by the floor.
List<Packed<3>> pressingOnPowder(const volVectorField& gradient, const VoidFractionFloor& floor)
{
    List<Packed<3>> felt(gradient.size());
    forAll(felt, celli)
    {
        const vector& g = gradient[celli];
        felt[celli] = {g.x(), g.y(), g.z()};
    }
    floor.adjoint(felt);
    return felt;
}

} // namespace

PowderOnMesh::PowderOnMesh(const fvMesh& mesh, const Settings& settings,
    std::unique_ptr<DragLaw> drag)
:
    mesh_(mesh),
    settings_(settings),
    law_(std::move(drag)),
    grains_(settings.coarseGraining, settings.where),
    box_(mesh),
    halo_(mesh),
    locator_(mesh),
    smoothing_(mesh, halo_, settings.smoothingWidth),
    floor_(mesh, halo_, settings.minimumVoidFraction),
    transfer_(mesh, halo_,
        DepositKernel::New(settings.deposit, mesh, halo_, box_, settings.where), smoothing_),
    voidFraction_(cellField<scalar>(mesh, "powderVoidFraction", dimless, 1, IOobject::NO_WRITE)),
    drag_(cellField<scalar>(mesh, "dragCoefficient", dimDensity/dimTime, 0, IOobject::NO_WRITE)),
    dragSource_(cellField<vector>(mesh, "dragSource", dimForce/dimVolume, Zero,
        IOobject::NO_WRITE))
{}

void PowderOnMesh::rarefy(double meanFreePath)
{
    law_ = std::make_unique<RarefiedDrag>(std::move(law_), meanFreePath);
    rarefied_ = true;
}

void PowderOnMesh::cover(const volScalarField& covered)
{
    scalarList open(1 - covered.primitiveField());
    halo_.toGhosts(open);
    transfer_.close(open);
    smoothing_.close(open);
    floor_.close(open);
}

void PowderOnMesh::place(std::vector<ParcelRecord>&& parcels, const std::vector<int>& cells)
{
    parcels_ = std::move(parcels);
    cells_ = cells;
    pointField positions(static_cast<label>(parcels_.size()));
    forAll(positions, i)
    {
        positions[i] = toFoam(parcels_[i].position);
    }
    transfer_.place(positions, cells_);
    smoothing_.reach(transfer_.weights().cells);
    hide();
}

// What is inside solids, by the records; and what no cell receives.
void PowderOnMesh::hide()
{
    int count = 0;
    double volume = 0;
    for (std::size_t i = 0; i < parcels_.size(); ++i)
    {
        ParcelRecord& parcel = parcels_[i];
        if (!transfer_.weights().received(static_cast<int>(i)))
        {
            parcel.presence = 0;
        }
        const double hidden = 1 - parcel.presence;
        count += hidden > 0;
        volume += hidden*sphereVolume(parcel.diameter);
    }
    report_.hidden = returnReduce(count, sumOp<int>());
    report_.hiddenVolume = returnReduce(volume, sumOp<double>());
}

void PowderOnMesh::depositVolume()
{
    const List<Packed<1>> deposited = transfer_.deposit<1>(
        [this](int i)
        { return Packed<1>(parcels_[i].presence*sphereVolume(parcels_[i].diameter)); });
    scalarField solids(mesh_.nCells());
    forAll(solids, celli)
    {
        solids[celli] = deposited[celli][0];
    }
    report_.floor = floor_.apply(solids);
    voidFraction_.primitiveFieldRef() = 1 - solids;
    voidFraction_.correctBoundaryConditions();
}

// `air`: velocity and void fraction.
double PowderOnMesh::parcelDrag(const ParcelRecord& parcel, const Packed<4>& air, double density,
    double viscosity) const
{
    LocalFlow flow;
    flow.slip = mag(vector(air[0], air[1], air[2]) - toFoam(parcel.velocity));
    flow.voidFraction = max(air[3], settings_.minimumDragVoidFraction);
    flow.density = density;
    flow.viscosity = viscosity;
    flow.diameter = parcel.diameter;
    return grains_.parcelDragCoefficient(*law_, flow);
}

// Drag coefficient b of a parcel, and of its shares. Returns the mean void fraction around it.
double PowderOnMesh::dragOfShares(int parcel, const List<Packed<4>>& air, double density,
    double viscosity)
{
    const ParticleWeights& weights = transfer_.weights();
    const int begin = weights.offsets[parcel];
    const int end = weights.offsets[parcel + 1];

    Packed<4> mean(Zero);
    double least = 1;
    double most = 0;
    for (int w = begin; w < end; ++w)
    {
        const Packed<4>& cell = air[weights.cells[w]];
        for (unsigned n = 0; n < 4; ++n)
        {
            mean[n] += weights.shares[w]*cell[n];
        }
        least = min(least, cell[3]);
        most = max(most, cell[3]);
    }

    // Inside a bed one evaluation is as good as eight.
    const bool uniform = most - least < uniformVoidFraction;
    const double meanDrag =
        uniform ? parcelDrag(parcels_[parcel], mean, density, viscosity) : 0;
    double sum = 0;
    for (int w = begin; w < end; ++w)
    {
        const double b = uniform
            ? meanDrag
            : parcelDrag(parcels_[parcel], air[weights.cells[w]], density, viscosity);
        dragShares_[w] = parcels_[parcel].presence*weights.shares[w]*b;
        sum += dragShares_[w];
    }
    coefficients_[parcel] = sum;
    return mean[3];
}

void PowderOnMesh::depositDrag(const volVectorField& U, double density, const volScalarField& nu,
    double interval)
{
    List<Packed<4>> air(mesh_.nCells());
    forAll(air, celli)
    {
        const vector& u = U[celli];
        air[celli] = {u.x(), u.y(), u.z(), voidFraction_[celli]};
    }
    halo_.toGhosts(air);

    coefficients_.resize(parcels_.size());
    effective_.resize(parcels_.size());
    dragShares_.resize(transfer_.weights().shares.size());
    double shortest = GREAT;
    for (std::size_t i = 0; i < parcels_.size(); ++i)
    {
        const double mass = parcels_[i].mass;
        const double alpha =
            dragOfShares(static_cast<int>(i), air, density, density*nu[cells_[i]]);
        effective_[i] = meanSlip(coefficients_[i]*interval/mass);
        if (coefficients_[i] > 0)
        {
            shortest = min(shortest, alpha*alpha*mass/coefficients_[i]);
        }
    }
    report_.shortestResponse = returnReduce(shortest, minOp<double>());

    const std::vector<double>& shares = transfer_.weights().shares;
    const List<Packed<4>> densities = transfer_.depositShares<4>(
        [&](int i, int w)
        {
            const ParcelRecord& p = parcels_[i];
            const double b = effective_[i]*dragShares_[w];
            const double carried = -p.presence*shares[w]/interval;
            return Packed<4>{b, b*p.velocity[0] + carried*p.carry[0], b*p.velocity[1] + carried*p.carry[1],
                b*p.velocity[2] + carried*p.carry[2]};
        });
    forAll(densities, celli)
    {
        const Packed<4>& q = densities[celli];
        drag_[celli] = q[0];
        dragSource_[celli] = vector(q[1], q[2], q[3]);
    }
    drag_.correctBoundaryConditions();
    dragSource_.correctBoundaryConditions();
}

std::vector<GasRecord> PowderOnMesh::gasAtParcels(const volVectorField& U,
    const volVectorField& pressureGradient, double interval) const
{
    const List<Packed<3>> pressing = pressingOnPowder(pressureGradient, floor_);
    List<Packed<6>> air(mesh_.nCells());
    forAll(air, celli)
    {
        const vector& u = U[celli];
        const Packed<3>& g = pressing[celli];
        air[celli] = {u.x(), u.y(), u.z(), g[0], g[1], g[2]};
    }
    transfer_.smoothed(air);

    const ParticleWeights& weights = transfer_.weights();
    std::vector<GasRecord> gas(parcels_.size());
    for (std::size_t i = 0; i < gas.size(); ++i)
    {
        vector drag(Zero); // sum of b u over the shares
        vector gradient(Zero);
        for (int w = weights.offsets[i]; w < weights.offsets[i + 1]; ++w)
        {
            const Packed<6>& cell = air[weights.cells[w]];
            drag += dragShares_[w]*vector(cell[0], cell[1], cell[2]);
            gradient += weights.shares[w]*vector(cell[3], cell[4], cell[5]);
        }
        const ParcelRecord& p = parcels_[i];
        const double b = coefficients_[i];
        const double volume = p.presence*sphereVolume(p.diameter);
        gas[i].dragCoefficient = b;
        for (int d = 0; d < 3; ++d)
        {
            gas[i].velocity[d] = b > 0 ? drag[d]/b : 0;
            gas[i].force[d] = -volume*gradient[d];
            gas[i].given[d] = effective_[i]*interval*(drag[d] - b*p.velocity[d])
                - (1 - p.presence)*p.carry[d];
        }
    }
    return gas;
}

} // namespace interstice
