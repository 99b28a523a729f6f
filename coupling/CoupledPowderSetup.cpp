// SPDX-License-Identifier: GPL-3.0-or-later
// How the case is read and the powder comes to lie on the mesh.
#include "coupling/Checkpoint.hpp"
#include "coupling/CoupledPowder.hpp"
#include "coupling/ScriptFiles.hpp"
#include "coupling/TimeStepChoice.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/forces/ParcelForces.hpp"
#include "coupling/forces/tell.hpp"
#include "coupling/laws/DimensionlessGroups.hpp"
#include "coupling/laws/InputError.hpp"
#include "coupling/laws/sphereVolume.hpp"
#include "coupling/mesh/Parameters.hpp"

#include "IOdictionary.H"

#include <algorithm>

namespace interstice
{

using namespace Foam;

namespace
{

IOdictionary couplingProperties(const fvMesh& mesh)
{
    return IOdictionary(IOobject("couplingProperties", mesh.time().constant(), mesh,
        IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE, false));
}

PowderOnMesh::Settings meshSettings(const dictionary& dict, double coarseGraining)
{
    using Range = Parameters::Range;
    const Parameters p(dict);
    PowderOnMesh::Settings s;
    s.deposit = p.name("deposit", s.deposit);
    s.smoothingWidth = p.number("smoothingWidth", "m", Range::notNegative, 0);
    s.minimumVoidFraction = p.number("minimum", "", Range::fraction, s.minimumVoidFraction);
    s.minimumDragVoidFraction =
        p.number("minimumForDrag", "", Range::fraction, s.minimumDragVoidFraction);
    s.coarseGraining = coarseGraining;
    s.where = p.where("deposit");
    p.allKnown();
    return s;
}

std::unique_ptr<DragLaw> dragLaw(const dictionary& dict)
{
    const Parameters p(dict);
    DragOptions options;
    options.sphericity = p.number("sphericity", "", Parameters::Range::positive, 1);
    options.cleanBlend = p.flag("cleanBlend", false);
    const word law = p.name("law", dragLaws().front().name);
    p.allKnown();
    return makeDragLaw(law, options, p.where("law"));
}

// `effect` of the air is wished on; empty: none is.
void requireAir(const word& effect, const std::optional<AirCoupling>& wish, const Parameters& p)
{
    if (wish == AirCoupling::none && !effect.empty())
    {
        throw InputError({"An effect of the air wants air.", "air " + std::string(nameOf(*wish)) + ", " + effect + " on",
            effect + " off or auto, or air twoWay, oneWay or auto",
            p.where("air") + "; " + Parameters(p.sub("effects")).where(effect), "Leave one of the two out."});
    }
}

} // namespace

CoupledPowder::CoupledPowder(fvMesh& mesh, const AirAtStart& air, StageClock& clock)
:
    mesh_(mesh),
    clock_(clock),
    density_(air.density),
    viscosity_(air.density*gMax(air.nu.primitiveField())),
    lightest_(GREAT),
    state_(mesh)
{
    const IOdictionary dict(couplingProperties(mesh));
    const Parameters p(dict);
    const std::optional<AirCoupling> wish = airCoupling(p.name("air", "auto"), p.where("air"));
    const word effectOfTheAir = ParcelForces::wantedOfTheAir(p.sub("effects"));
    requireAir(effectOfTheAir, wish, p);
    const dictionary& powder = p.group("powder");
    coarseGraining_ = Parameters(powder).number(
        "coarseGraining", "", Parameters::Range::positive, 1);

    onMesh_ = std::make_unique<PowderOnMesh>(
        mesh, meshSettings(p.sub("voidFraction"), coarseGraining_), dragLaw(p.sub("drag")));
    solids_ = std::make_unique<SolidsOnMesh>(mesh);
    timeStep_ = std::make_unique<TimeStepChoice>(
        const_cast<Time&>(mesh.time()), p.sub("timeStep"));
    exchange_ = std::make_unique<ParticleExchange>(MPI_COMM_WORLD, onMesh_->locator().bounds());

    const std::optional<Checkpoint> before = checkpoint();
    {
        StageClock::Scope timed(clock_, Stage::dem);
        openDem(powder, before ? &*before : nullptr);
    }
    chooseAir(wish, air.driven, !effectOfTheAir.empty());
    readSolids(p.sub("solids"));
    forces_ = std::make_unique<ParcelForces>(
        Scene{mesh, *dem_, coarseGraining_, Parameters(powder).where("coarseGraining"), solidWalls_},
        p.sub("effects"), effects_);
    if (hasAir())
    {
        forces_->start({density_, viscosity_}, *dem_, mesh_.time().value());
    }
    p.allGroupsKnown();
    checkScene();
    checkSmoothing(p.sub("voidFraction").getOrDefault<scalar>("smoothingWidth", 0),
        Parameters(p.sub("voidFraction")).where("smoothingWidth"));

    // The powder as it lies, so that the first d(alpha)/dt starts from it.
    moveSolids(0);
    placeParcels(0);
    checkPowderInMesh();
    onMesh_->depositVolume();
    adaptDrag();
    const volVectorField atRest(IOobject("airAtRest", mesh.time().timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero));
    onMesh_->depositDrag(atRest, density_, air.nu, mesh.time().deltaTValue());
    response_ = onMesh_->report().shortestResponse;
    refreshState();
    state_.initialMass = record().mass;
    if (before)
    {
        resume(*before);
    }
}

void CoupledPowder::openDem(const dictionary& dict, const Checkpoint* before)
{
    const Parameters p(dict);
    p.number("coarseGraining", "", Parameters::Range::positive, 1);
    const fileName script = findScript(p.text("script"), mesh_.time(), p.where("script"));
    DemOptions options;
    options.logFile = before ? "log.liggghts." + mesh_.time().timeName() : "log.liggghts";
    options.screenFile = options.logFile + ".screen";
    if (p.has("parameters"))
    {
        options.variables =
            numbersIn(mesh_.time().globalPath()/p.text("parameters"), p.where("parameters"));
    }
    const bool wantsWalls = p.flag("walls", true);
    checkpoints_ = p.flag("checkpoints", true);
    p.allKnown();
    options.variables["case"] = mesh_.time().globalPath();
    options.variables["scripts"] = script.path();
    options.variables["ranks"] = Foam::name(Pstream::nProcs());
    options.variables["resume"] = before ? "1" : "0";
    options.variables["checkpoint"] = before ? Checkpoint::particlesOf(mesh_.time()) : "none";

    dem_ = std::make_unique<DemEngine>(MPI_COMM_WORLD, options);
    dem_->runScript(script);
    if (before)
    {
        dem_->couple(before->dem);
    }
    else
    {
        dem_->couple();
    }
    if (wantsWalls && !dem_->hasWalls())
    {
        throw InputError({"Powder needs walls to rest on.", "no fix wall/gran in " + script,
            "a wall, or walls off", p.where("walls"),
            "Add fix ... wall/gran to the script, or set walls off if nothing shall hold the "
            "powder."});
    }
}

// Critical over smallest sensitivity to air: of the particle that feels it most; infinite as long as there is none.
double CoupledPowder::airNumber() const
{
    DieFilling filling{};
    filling.gasDensity = density_;
    filling.gasViscosity = viscosity_;
    filling.gravity = mag(vector(dem_->gravity()[0], dem_->gravity()[1], dem_->gravity()[2]));
    double smallest = GREAT;
    const ParticleView view = dem_->particles();
    for (int i = 0; i < view.count; ++i)
    {
        filling.particleDiameter = 2*view.radius[i]/coarseGraining_;
        filling.particleDensity = view.mass[i]/sphereVolume(2*view.radius[i]);
        smallest = min(smallest, airSensitivity(filling));
    }
    reduce(smallest, minOp<double>());
    return dem_->particleCount() > 0 ? airlessSensitivity/max(smallest, SMALL) : GREAT;
}

// By itself the air is left out if nothing but powder could move it, the powder does not feel it, and no effect of it is
// wanted. Later it cannot be had back: who would feel it then is told.
void CoupledPowder::chooseAir(const std::optional<AirCoupling>& wish, bool driven, bool wanted)
{
    const double number = airNumber();
    Effect effect{"air", "1.91e7 over zeta, the sensitivity to air", 1};
    const bool felt = number > effect.limit;
    air_ = wish ? *wish : felt || driven || wanted ? AirCoupling::twoWay : AirCoupling::none;
    effect.wish = hasAir() ? wish ? Effect::Wish::on : Effect::Wish::automatic : Effect::Wish::off;
    effect.on = hasAir();
    effect.how = nameOf(air_);
    effect.by = wish || (!felt && !driven && wanted) ? "user" : !felt && driven ? "drive" : "number";
    if (hasAir() || !felt)
    {
        effect.largest = number;
    }
    airPlace_ = effects_.add(effect);
    if (!wish && !hasAir())
    {
        Info<< "The air is left out: zeta is " << airlessSensitivity/number << ", above " << airlessSensitivity
            << ", and nothing but powder could move it. Set air on to simulate it." << nl << endl;
    }
    else if (!hasAir())
    {
        tell(effects_, airPlace_, number, mesh_.time().value());
    }
}

void CoupledPowder::readSolids(const dictionary& dict)
{
    for (const word& name : dict.toc())
    {
        const Parameters p(dict.subDict(name));
        const std::string wall = p.text("wall", string(name));
        const std::vector<std::string> walls = dem_->meshWalls();
        if (std::find(walls.begin(), walls.end(), wall) == walls.end())
        {
            throw unknownName("mesh wall of the LIGGGHTS script", wall, walls, p.where("wall"));
        }
        const fileName surface = mesh_.time().globalPath()/p.text("surface");
        const bool seen = p.flag("seenByAir", true);
        p.allKnown();
        if (seen && movesAir())
        {
            solids_->add(
                std::make_unique<MovingSolid>(mesh_, name, surface, p.where("surface")));
            solidWalls_.push_back(wall);
        }
    }
}

} // namespace interstice
