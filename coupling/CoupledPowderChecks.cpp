// SPDX-License-Identifier: GPL-3.0-or-later
// What CoupledPowder refuses: scenes that make no sense, and values that are no number.
#include "coupling/CoupledPowder.hpp"

#include "coupling/RunFailure.hpp"
#include "coupling/dem/DemEngine.hpp"
#include "coupling/exchange/ParticleExchange.hpp"
#include "coupling/laws/InputError.hpp"

#include "PstreamReduceOps.H"

#include <cmath>
#include <sstream>

namespace interstice
{

using namespace Foam;

namespace
{

vector toFoam(const Vec3& v)
{
    return vector(v[0], v[1], v[2]);
}

std::string metres(double length)
{
    std::ostringstream text;
    text << length << " m";
    return text.str();
}

} // namespace

void CoupledPowder::checkScene() const
{
    const DemBox box = dem_->box();
    const boundBox& cells = mesh_.bounds();
    const boundBox powder(toFoam(box.low), toFoam(box.high));
    if (!cells.overlaps(powder))
    {
        throw InputError({"Mesh and powder must share space.",
            "LIGGGHTS' box and the mesh do not overlap", "overlapping boxes",
            "create_box in the LIGGGHTS script; system/blockMeshDict",
            "Check units (metres) and origin of both."});
    }
    const double diameter = 2*dem_->maximumRadius();
    if (diameter > cmptMin(cells.span()) && onMesh_->box().period() == vector::zero)
    {
        throw InputError({"A particle must be smaller than the domain.",
            "a diameter of " + metres(diameter), "less than " + metres(cmptMin(cells.span())),
            "particle radius in the LIGGGHTS script", "Check units (metres)."});
    }
}

// Where the floor of the void fraction moves the powder of a large parcel to other cells, the parcel does
// not feel what it does to the air there; without smoothing that blew up (stability map).
void CoupledPowder::checkSmoothing(double width, const std::string& where) const
{
    const double diameter = 2*dem_->maximumRadius();
    const double cell = std::cbrt(gMin(mesh_.V()));
    if (movesAir() && diameter > 2.01*cell && width < diameter)
    {
        throw InputError({"A parcel larger than two cells must be smoothed.",
            "a diameter of " + metres(diameter) + ", cells of " + metres(cell)
                + ", smoothingWidth " + metres(width),
            "smoothingWidth of at least the diameter; twice the diameter is good", where,
            "Set smoothingWidth to " + std::to_string(2*diameter) + ", use larger cells or a smaller "
            "coarseGraining."});
    }
}

void CoupledPowder::checkPowderInMesh() const
{
    const long long all = dem_->particleCount();
    const label outside = returnReduce(label(exchange_->outside().size()), sumOp<label>());
    if (all > 0 && outside == all)
    {
        throw InputError({"Mesh and powder must share space.",
            "all " + std::to_string(all) + " particles outside the mesh",
            "particles in the mesh, or none yet",
            "the particles' places in the LIGGGHTS script; system/blockMeshDict",
            "Check units (metres) and origin of both."});
    }
}

// Throws RunFailure on all ranks if a particle's position, velocity or force is no number.
void CoupledPowder::checkParticles() const
{
    std::string found = dem_->heldParticle();
    const ParticleView view = dem_->particles();
    for (int i = 0; i < view.count && found.empty(); ++i)
    {
        const double* x = view.position[i];
        if (!std::isfinite(x[0] + x[1] + x[2]))
        {
            found = "particle " + std::to_string(view.id[i]) + ", its position";
        }
    }
    if (!found.empty())
    {
        found += ", on rank " + std::to_string(Pstream::myProcNo());
    }
    RunFailure::throwOnAllRanks(!found.empty(), "A particle has a value that is no number.", found,
        MPI_COMM_WORLD);
}

} // namespace interstice
