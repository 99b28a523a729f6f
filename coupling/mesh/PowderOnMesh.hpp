// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/CoarseGraining.hpp"
#include "coupling/mesh/CellLocator.hpp"
#include "coupling/mesh/ParticleMeshTransfer.hpp"
#include "coupling/mesh/VoidFractionFloor.hpp"

#include "volFields.H"

namespace interstice
{

/// What the mesh needs to know of a parcel.
struct ParcelRecord
{
    Vec3 position; ///< at the end of the coming interval, predicted; outside of solids [m]
    Vec3 velocity; ///< at its start [m/s]
    Vec3 carry; ///< momentum that drag gave it beyond what the air lost so far [N s]
    double diameter; ///< [m]
    double mass; ///< with that of fluid which goes along [kg]
    double presence; ///< share that the air sees, 1 outside of solids
    int id;
};

/// What a parcel needs to know of the air.
struct GasRecord
{
    Vec3 velocity; ///< interstitial [m/s]
    double dragCoefficient; ///< of the parcel [kg/s]
    Vec3 force; ///< -V grad(p) [N]
    Vec3 given; ///< momentum that the air lost to it by drag in the interval, less the carry that
                ///< it could not take from one inside a solid [N s]
};

/// The powder as fields on the mesh, and the air as values at the parcels.
///
/// Holds the parcels handled on this rank. In each coupling step: place, depositVolume,
/// depositDrag, (the air moves), gasAtParcels. All but `place` are collective.
class PowderOnMesh
{
public:
    struct Settings
    {
        Foam::word deposit = "kernel"; ///< see DepositKernel
        double smoothingWidth = 0; ///< b of Smoothing [m]
        double minimumVoidFraction = 0.3; ///< floor of the field
        double minimumDragVoidFraction = 0.36; ///< floor inside the drag law: random close packing
        double coarseGraining = 1; ///< k
        std::string where; ///< file, for messages
    };

    /// What the last deposit did, over all ranks.
    struct Report
    {
        VoidFractionFloor::Report floor;
        int hidden = 0; ///< parcels inside a solid, in whole or in part
        double hiddenVolume = 0; ///< of them, not seen by the air [m3]
        double shortestResponse = 0; ///< smallest tau_eff = alpha^2 m/b of a parcel [s]
    };

    PowderOnMesh(const Foam::fvMesh& mesh, const Settings& settings,
        std::unique_ptr<DragLaw> drag);

    const CellLocator& locator() const { return locator_; }
    const PeriodicBox& box() const { return box_; }
    const CellHalo& halo() const { return halo_; }
    const Smoothing& smoothing() const { return smoothing_; }

    /// From now on drag is that of a gas with this mean free path [m], more than 0. Once; local.
    void rarefy(double meanFreePath);
    bool rarefied() const { return rarefied_; }

    /// Collective. Covered fraction of each cell: powder and its densities are of what is left open.
    void cover(const Foam::volScalarField& covered);

    /// Parcels handled here and their cells, of this step. Local.
    void place(std::vector<ParcelRecord>&& parcels, const std::vector<int>& cells);
    const std::vector<ParcelRecord>& parcels() const { return parcels_; }
    const std::vector<int>& cells() const { return cells_; }

    /// Void fraction from the parcels' volumes.
    void depositVolume();

    /// Drag coefficients in the air as it is now (velocity `U`, density [kg/m3], kinematic
    /// viscosity `nu`), effective over an interval [s]; and the carry. Each share of a parcel
    /// meets the air of its own cell: the law is far from linear in the void fraction, and
    /// averaging that first would lose drag wherever a bed has a surface.
    void depositDrag(const Foam::volVectorField& U, double density, const Foam::volScalarField& nu,
        double interval);

    /// The air at the parcels after it has moved: velocity and pressure gradient [Pa/m] cell by
    /// cell, sampled by the adjoint of the deposit.
    std::vector<GasRecord> gasAtParcels(const Foam::volVectorField& U,
        const Foam::volVectorField& pressureGradient, double interval) const;

    /// Collective. Any five numbers of cells at the parcels, sampled by the adjoint of the deposit;
    /// `cells` is nCells long, used up.
    std::vector<Packed<5>> atParcels(Foam::List<Packed<5>>&& cells) const
    {
        return transfer_.sample(std::move(cells));
    }

    /// These three of the open volumes of cells (SolidsOnMesh).
    const Foam::volScalarField& voidFraction() const { return voidFraction_; }
    const Foam::volScalarField& dragCoefficient() const { return drag_; } ///< sum b/V [kg/m3/s]
    /// Sum of b v/V, and of what the powder still has to give [N/m3].
    const Foam::volVectorField& dragSource() const { return dragSource_; }

    const Report& report() const { return report_; }

private:
    void hide();
    double parcelDrag(const ParcelRecord& parcel, const Packed<4>& air, double density,
        double viscosity) const;
    double dragOfShares(int parcel, const Foam::List<Packed<4>>& air, double density,
        double viscosity);

    const Foam::fvMesh& mesh_;
    Settings settings_;
    std::unique_ptr<DragLaw> law_;
    bool rarefied_ = false;
    CoarseGraining grains_;
    PeriodicBox box_;
    CellHalo halo_;
    CellLocator locator_;
    Smoothing smoothing_;
    VoidFractionFloor floor_;
    ParticleMeshTransfer transfer_;

    std::vector<ParcelRecord> parcels_;
    std::vector<int> cells_;
    std::vector<double> coefficients_; // b of each parcel [kg/s]
    std::vector<double> effective_; // what the interval makes of it: b_eff/b of each parcel
    std::vector<double> dragShares_; // of b in each of the parcel's cells [kg/s]

    Foam::volScalarField voidFraction_;
    Foam::volScalarField drag_;
    Foam::volVectorField dragSource_;
    Report report_;
};

} // namespace interstice
