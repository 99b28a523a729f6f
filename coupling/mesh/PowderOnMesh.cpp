// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/PowderOnMesh.hpp"

#include "coupling/laws/ImplicitDrag.hpp"

#include "mathematicalConstants.H"
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

double sphereVolume(double diameter)
{
    return constant::mathematical::pi/6*diameter*diameter*diameter;
}

vector toFoam(const Vec3& v)
{
    return vector(v[0], v[1], v[2]);
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
    open_(halo_.size(), 1.0),
    voidFraction_(cellField<scalar>(mesh, "powderVoidFraction", dimless, 1, IOobject::NO_WRITE)),
    drag_(cellField<scalar>(mesh, "dragCoefficient", dimDensity/dimTime, 0, IOobject::NO_WRITE)),
    dragSource_(cellField<vector>(mesh, "dragSource", dimForce/dimVolume, Zero,
        IOobject::NO_WRITE)),
    carry_(cellField<vector>(mesh, "momentumCarry", dimForce/dimVolume, Zero,
        IOobject::NO_WRITE))
{}

void PowderOnMesh::cover(const volScalarField& covered)
{
    open_ = 1 - covered.primitiveField();
    halo_.toGhosts(open_);
    smoothing_.close(open_);
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
    transfer_.place(positions, cells_, open_);
    report_ = Report();
    report_.hidden = returnReduce(transfer_.weights().hidden, sumOp<int>());
}

void PowderOnMesh::depositVolume()
{
    const List<Packed<1>> deposited = transfer_.deposit<1>(
        [this](int i) { return Packed<1>(sphereVolume(parcels_[i].diameter)); });
    scalarField solids(mesh_.nCells());
    forAll(solids, celli)
    {
        solids[celli] = deposited[celli][0];
    }
    report_.floor = floor_.apply(solids);
    voidFraction_.primitiveFieldRef() = 1 - solids;
    voidFraction_.correctBoundaryConditions();
}

double PowderOnMesh::parcelDrag(int parcel, double voidFraction, const vector& gasVelocity,
    double density, double viscosity) const
{
    LocalFlow flow;
    flow.slip = mag(gasVelocity - toFoam(parcels_[parcel].velocity));
    flow.voidFraction = max(voidFraction, settings_.minimumDragVoidFraction);
    flow.density = density;
    flow.viscosity = viscosity;
    flow.diameter = parcels_[parcel].diameter;
    return grains_.parcelDragCoefficient(*law_, flow);
}

void PowderOnMesh::depositDrag(const volVectorField& U, double density, const volScalarField& nu,
    double interval)
{
    List<Packed<4>> air(mesh_.nCells());
    forAll(air, celli)
    {
        const vector& u = U[celli];
        air[celli][0] = u.x();
        air[celli][1] = u.y();
        air[celli][2] = u.z();
        air[celli][3] = voidFraction_[celli];
    }
    const std::vector<Packed<4>> around = transfer_.interpolate(std::move(air));

    coefficients_.resize(parcels_.size());
    effective_.resize(parcels_.size());
    double shortest = GREAT;
    for (std::size_t i = 0; i < parcels_.size(); ++i)
    {
        const Packed<4>& a = around[i];
        const double b = parcelDrag(static_cast<int>(i), a[3], vector(a[0], a[1], a[2]), density,
            density*nu[cells_[i]]);
        coefficients_[i] = b;
        effective_[i] = ImplicitDrag(b, parcels_[i].mass, interval).effectiveCoefficient();
        shortest = min(shortest, a[3]*a[3]*parcels_[i].mass/b);
    }
    report_.shortestResponse = returnReduce(shortest, minOp<double>());

    const List<Packed<7>> densities = transfer_.deposit<7>(
        [&](int i)
        {
            const ParcelRecord& p = parcels_[i];
            Packed<7> q;
            q[0] = effective_[i];
            for (int d = 0; d < 3; ++d)
            {
                q[1 + d] = effective_[i]*p.velocity[d];
                q[4 + d] = -p.carry[d]/interval;
            }
            return q;
        });
    forAll(densities, celli)
    {
        const Packed<7>& q = densities[celli];
        drag_[celli] = q[0];
        dragSource_[celli] = vector(q[1], q[2], q[3]);
        carry_[celli] = vector(q[4], q[5], q[6]);
    }
    drag_.correctBoundaryConditions();
    dragSource_.correctBoundaryConditions();
    carry_.correctBoundaryConditions();
}

std::vector<GasRecord> PowderOnMesh::gasAtParcels(const volVectorField& U,
    const volVectorField& pressureGradient, double interval) const
{
    List<Packed<6>> air(mesh_.nCells());
    forAll(air, celli)
    {
        for (direction d = 0; d < 3; ++d)
        {
            air[celli][d] = U[celli][d];
            air[celli][3 + d] = pressureGradient[celli][d];
        }
    }
    const std::vector<Packed<6>> around = transfer_.sample(std::move(air));

    std::vector<GasRecord> gas(parcels_.size());
    for (std::size_t i = 0; i < gas.size(); ++i)
    {
        const ParcelRecord& p = parcels_[i];
        const double volume = sphereVolume(p.diameter);
        gas[i].dragCoefficient = coefficients_[i];
        for (int d = 0; d < 3; ++d)
        {
            gas[i].velocity[d] = around[i][d];
            gas[i].force[d] = -volume*around[i][3 + d];
            gas[i].given[d] = effective_[i]*interval*(around[i][d] - p.velocity[d]);
        }
    }
    return gas;
}

} // namespace interstice
