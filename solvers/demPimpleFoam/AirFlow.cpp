// SPDX-License-Identifier: GPL-3.0-or-later
#include "AirFlow.hpp"

#include "findRefCell.H"
#include "fvc.H"
#include "IOdictionary.H"
#include "StringStream.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>
#include <sstream>
#include <utility>

namespace interstice
{

using namespace Foam;

namespace
{

IOobject field(const char* name, const fvMesh& mesh, IOobject::readOption read,
    IOobject::writeOption write)
{
    return IOobject(name, mesh.time().timeName(), mesh, read, write);
}

template<class Field>
void requireDimensions(const Field& field, const dimensionSet& wanted, const char* remedy)
{
    if (field.dimensions() != wanted)
    {
        OStringStream found;
        found << field.dimensions();
        OStringStream right;
        right << wanted;
        throw InputError({"A field has the wrong dimensions.", found.str(), right.str(),
            field.instance() + "/" + field.name() + ", key dimensions", remedy});
    }
}

// Values from beyond coupled patches: what decomposePar writes there is the cell's own.
template<class Field>
void meetNeighbours(Field& field)
{
    auto& patches = field.boundaryFieldRef();
    const label before = Pstream::nRequests();
    for (auto& patch : patches)
    {
        if (patch.coupled())
        {
            patch.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }
    Pstream::waitRequests(before);
    for (auto& patch : patches)
    {
        if (patch.coupled())
        {
            patch.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
}

// What pushes the air besides gravity, if the start time has a field of the name: a fan, a rotating
// frame, a test with a made-up solution.
volVectorField givenForce(const fvMesh& mesh)
{
    IOobject io(field("bodyForce", mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE));
    const bool given = io.typeHeaderOk<volVectorField>(true);
    io.writeOpt() = given ? IOobject::AUTO_WRITE : IOobject::NO_WRITE; // for a run that goes on
    volVectorField force(io, mesh, dimensionedVector(dimAcceleration, Zero));
    requireDimensions(force, dimAcceleration, "bodyForce is an acceleration of the air [m/s2].");
    meetNeighbours(force);
    return force;
}

surfaceScalarField givenFluxes(const volVectorField& U)
{
    surfaceScalarField given(IOobject("fixedFlux", U.time().timeName(), U.mesh()), U.mesh(),
        dimensionedScalar(dimless, Zero));
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& patch = U.boundaryField()[patchi];
        given.boundaryFieldRef()[patchi] = !patch.assignable() && !patch.coupled() ? 1 : 0;
    }
    return given;
}

// The loop without its line an iteration: the log has one line a step.
bool quietLoop(pimpleControl& pimple)
{
    const int level = std::exchange(messageStream::level, 0);
    const bool again = pimple.loop();
    messageStream::level = level;
    return again;
}

// Tells what is wrong with the air before OpenFOAM stumbles over it.
double checkedDensity(const volVectorField& U, const volScalarField& p)
{
    requireDimensions(U, dimVelocity, "U is the velocity of the air [m/s].");
    requireDimensions(p, sqr(dimVelocity), "p is pressure over density of the air [m2/s2].");
    const IOdictionary dict(IOobject("transportProperties", U.time().constant(), U.db(),
        IOobject::MUST_READ, IOobject::NO_WRITE, false));
    const Parameters transport(dict);
    if (transport.name("transportModel", "Newtonian") == "Newtonian")
    {
        transport.quantity("nu", dimViscosity, "m2/s", Parameters::Range::positive);
    }
    return transport.quantity("rho", dimDensity, "kg/m3", Parameters::Range::positive);
}

// Density follows pressure at constant temperature: rho (1 + p/p0), p over the one at rest, p0.
dimensionedScalar givenCompressibility(const dictionary& dict, double density)
{
    const Parameters transport(dict);
    const word law = transport.name("compressibility", "none");
    if (law != "none" && law != "isothermal")
    {
        throw unknownName("compressibility", law, {"none", "isothermal"}, transport.where("compressibility"));
    }
    return dimensionedScalar("compressibility", sqr(dimTime/dimLength), law == "none" ? 0
        : density/transport.quantity("pressure", dimPressure, "Pa", Parameters::Range::positive));
}

void requireEuler(const fvMesh& mesh)
{
    const word scheme(mesh.ddtScheme("ddt(U)"));
    if (scheme != "Euler")
    {
        throw InputError({"Powder and air are coupled by the implicit Euler scheme.", scheme,
            "Euler", "system/fvSchemes, ddtSchemes", "Set ddtSchemes { default Euler; }."});
    }
}

// The pressure equation takes convection and viscosity from the predicted velocity.
void requirePredictor(const pimpleControl& pimple)
{
    if (!pimple.momentumPredictor())
    {
        throw InputError({"The velocity of the air must be predicted before its pressure is solved.",
            "momentumPredictor off", "momentumPredictor on",
            "system/fvSolution, PIMPLE, key momentumPredictor", "Set it on, or remove it."});
    }
}

} // namespace

AirFlow::AirFlow(fvMesh& mesh, StageClock& clock)
:
    mesh_(mesh),
    clock_(clock),
    pimple_(mesh, "PIMPLE", false),
    U_(field("U", mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE), mesh),
    p_(field("p", mesh, IOobject::MUST_READ, IOobject::AUTO_WRITE), mesh),
    alpha_(field("voidFraction", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE), mesh,
        dimensionedScalar("one", dimless, 1), zeroGradientFvPatchScalarField::typeName),
    ddtAlpha_(field("ddtVoidFraction", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        mesh, dimensionedScalar(dimless/dimTime, Zero)),
    alphaPhi_(field("alphaPhi", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE),
        fvc::flux(U_)),
    phi_(field("phi", mesh, IOobject::NO_READ, IOobject::NO_WRITE), alphaPhi_),
    push_(field("push", mesh, IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE), mesh,
        dimensionedVector(dimAcceleration, Zero)),
    gradP_(field("pressureGradient", mesh, IOobject::NO_READ, IOobject::NO_WRITE), mesh,
        dimensionedVector(dimAcceleration, Zero)),
    resistance_(field("resistance", mesh, IOobject::NO_READ, IOobject::NO_WRITE), mesh,
        dimensionedScalar(dimless/dimTime, Zero), zeroGradientFvPatchScalarField::typeName),
    source_(field("momentumSource", mesh, IOobject::NO_READ, IOobject::NO_WRITE), mesh,
        dimensionedVector(dimAcceleration, Zero), zeroGradientFvPatchVectorField::typeName),
    bedResistance_("bedResistance", resistance_),
    bedSource_("bedSource", source_),
    friction_("frictionOfSolids", resistance_),
    fixedFlux_(givenFluxes(U_)),
    whole_(IOobject("whole", mesh.time().timeName(), mesh), mesh, dimensionedScalar("one", dimless, 1)),
    density_(checkedDensity(U_, p_)),
    transport_(U_, phi_),
    nu_("laminarViscosity", transport_.nu()),
    compressibility_(givenCompressibility(transport_, density_)),
    gravity_("gravityOnAir", dimAcceleration, transport_.lookupOrDefault<vector>("gravity", Zero)),
    bodyForce_(givenForce(mesh)),
    turbulence_(Turbulence::New(alpha_, U_, alphaPhi_, phi_, transport_).ptr())
{
    requireEuler(mesh);
    requirePredictor(pimple_);
    mesh.setFluxRequired(p_.name());
    meetNeighbours(U_);
    meetNeighbours(p_);
    meetNeighbours(alpha_);
    meetNeighbours(push_);
    setRefCell(p_, pimple_.dict(), pRefCell_, pRefValue_);
    U_.oldTime();
    p_.oldTime();
    alpha_.oldTime();
    ddtAlpha_.oldTime();
    alphaPhi_.oldTime();
}

void AirFlow::start(const PowderOnMesh& powder, const SolidsOnMesh& solids)
{
    alpha_ == solids.ofWholeCells(powder.voidFraction());
    alpha_.oldTime() == alpha_;
    phi_ = fvc::flux(U_);
    alphaPhi_ = fvc::interpolate(alpha_)*phi_;
    alphaPhi_.oldTime() == alphaPhi_;
}

void AirFlow::hold()
{
    gradP_ = fvc::grad(p_);
    finish();
}

void AirFlow::resume()
{
    for (const regIOobject* needed :
        std::initializer_list<const regIOobject*>{&alpha_, &ddtAlpha_, &alphaPhi_, &push_})
    {
        if (!returnReduce(IOobject(*needed).typeHeaderOk<volScalarField>(false), andOp<bool>()))
        {
            throw InputError({"A run goes on from a checkpoint that is whole.",
                "no field " + needed->name() + " in " + mesh_.time().timeName(),
                "all fields as they were written", mesh_.time().timeName(),
                "Copy it to there, or delete this time folder to go on from the one before."});
        }
    }
    finish();
}

void AirFlow::begin(const PowderOnMesh& powder, const SolidsOnMesh& solids)
{
    const dimensionedScalar rho("rho", dimDensity, density_);
    alpha_ == solids.ofWholeCells(powder.voidFraction());
    ddtAlpha_ = (alpha_ - alpha_.oldTime())/mesh_.time().deltaT();

    resistance_ = powder.dragCoefficient()/rho;
    source_ = powder.dragSource()/rho;
    bedResistance_ = resistance_/sqr(powder.voidFraction());
    bedSource_ = source_/powder.voidFraction();
    if (solids.any())
    {
        friction_ = solids.friction(powder.voidFraction(), turbulence_->nuEff());
        solids.share(powder.voidFraction(), turbulence_->nuEff(), friction_, resistance_, source_);
    }
    source_ += alpha_*(gravity_ + bodyForce_);
    report_.pressureIterations = 0;
    report_.spreadSource = 0;
}

void AirFlow::solve(const PowderOnMesh& powder, const SolidsOnMesh& solids, bool viscousForce)
{
    if (viscousForce && !divTau_)
    {
        divTau_ = std::make_unique<volVectorField>("divTau", gradP_);
    }
    begin(powder, solids);
    while (quietLoop(pimple_))
    {
        fvVectorMatrix UEqn(inertia());
        predictVelocity(UEqn);
        const volVectorField h(carried(UEqn));
        while (pimple_.correct())
        {
            correctPressure(h, solids);
        }
        if (pimple_.turbCorr())
        {
            StageClock::Scope timed(clock_, Stage::momentum);
            transport_.correct();
            turbulence_->correct();
        }
    }
    const std::string bad = badCell();
    if (returnReduce(!bad.empty(), orOp<bool>()))
    {
        stepBack();
    }
    RunFailure::throwOnAllRanks(
        !bad.empty(), "The air has a value that is no number.", bad, MPI_COMM_WORLD);
    if (compressible())
    {
        ddtAlpha_ += storage()*(p_ - p_.oldTime());
    }
    finish();
}

// What a cell takes in by compression, per pressure over density: alpha rho/(p0 dt).
tmp<volScalarField> AirFlow::storage() const
{
    return compressibility_/mesh_.time().deltaT()*alpha_;
}

// Which cell of this rank has a value that is no number; empty if none has.
std::string AirFlow::badCell() const
{
    std::ostringstream found;
    forAll(U_, celli)
    {
        const vector& u = U_[celli];
        if (!std::isfinite(mag(u) + mag(p_[celli])))
        {
            const vector& x = mesh_.C()[celli];
            found << "cell " << celli << " of rank " << Pstream::myProcNo() << " at (" << x.x() << ' '
                  << x.y() << ' ' << x.z() << ") m: U = (" << u.x() << ' ' << u.y() << ' ' << u.z()
                  << ") m/s, p = " << p_[celli] << " m2/s2, void fraction " << alpha_[celli];
            break;
        }
    }
    return found.str();
}

void AirFlow::stepBack()
{
    U_ == U_.oldTime();
    p_ == p_.oldTime();
    alpha_ == alpha_.oldTime();
    ddtAlpha_ == ddtAlpha_.oldTime();
    alphaPhi_ == alphaPhi_.oldTime();
    Time& time = const_cast<Time&>(mesh_.time());
    time.setTime(time.value() - time.deltaTValue(), time.timeIndex() - 1);
}

void AirFlow::finish()
{
    phi_ = alphaPhi_/fvc::interpolate(alpha_);
    nu_ = transport_.nu();
    const scalar dt = mesh_.time().deltaTValue();
    const scalarField throughput(fvc::surfaceSum(mag(phi_))().primitiveField());
    report_.courant = 0.5*gMax(scalarField(throughput/mesh_.V().field()))*dt;
    report_.maxSpeed = gMax(mag(U_.primitiveField()));
    const volScalarField error(fvc::div(alphaPhi_) + ddtAlpha_);
    report_.continuityError = gMax(mag(error.primitiveField()))*dt;
}

} // namespace interstice
