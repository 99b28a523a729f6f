// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/Interstice.hpp"

#include "PhaseIncompressibleTurbulenceModel.H"
#include "fvMatrices.H"
#include "pimpleControl.H"
#include "singlePhaseTransportModel.H"

namespace interstice
{

/// The air: its fields and one PIMPLE step. The two equations stand in momentumEquation.cpp and
/// pressureEquation.cpp.
///
/// Inertia and convection use the void fraction and flux of the step before, a pair that satisfies
/// continuity exactly; and the pressure equation takes what convection and viscosity bring from the
/// predicted velocity. So momentum is conserved to round-off, and a uniform velocity stays uniform,
/// with one corrector and without outer iterations. Drag, pressure and continuity use the new void fraction.
class AirFlow
{
public:
    struct Report
    {
        double courant = 0;
        double maxSpeed = 0; ///< [m/s]
        double continuityError = 0; ///< largest |d(alpha)/dt + div(alpha U)| dt
        double spreadSource = 0; ///< volume source spread over a closed box [m3/s]
        int pressureIterations = 0; ///< in this step
    };

    /// Reads U, p, bodyForce [m/s2] if there is one, and constant/transportProperties (nu, rho,
    /// gravity; compressibility: none, or isothermal with pressure [Pa], absolute, where p is zero).
    AirFlow(Foam::fvMesh& mesh, StageClock& clock);

    double density() const { return density_; } ///< [kg/m3]
    const Foam::volScalarField& nu() const { return nu_; }
    const Foam::volVectorField& U() const { return U_; }
    /// Collective. Whether anything but the powder may move the air: it moves at the start, a boundary, a difference
    /// of pressure between boundaries, or a bodyForce does.
    bool driven() const;

    /// Collective. Takes the air as it is given, for one that is not solved.
    void hold();

    double courant() const { return report_.courant; }
    const Report& report() const { return report_; }

    /// Void fraction to start from. Collective, once.
    void start(const PowderOnMesh& powder, const SolidsOnMesh& solids);

    /// Instead of start(): goes on with the fields of the start time. Throws InputError if one is
    /// missing. Collective, once.
    void resume();

    /// Collective. Moves the air over the time step, with the powder as it lies on the mesh.
    /// `viscousForce`: the powder feels its share of the viscous stresses.
    /// Throws RunFailure, on all ranks, if U or p is no number in some cell, which it names; fields
    /// and clock are then those of the step before.
    void solve(const PowderOnMesh& powder, const SolidsOnMesh& solids, bool viscousForce);

    /// Of the last step, grad(p), or grad(p) - div(tau) with viscousForce [Pa/m]: what the particles feel.
    Foam::tmp<Foam::volVectorField> stressGradient() const;

private:
    using Turbulence = Foam::PhaseIncompressibleTurbulenceModel<Foam::singlePhaseTransportModel>;

    void begin(const PowderOnMesh& powder, const SolidsOnMesh& solids);
    Foam::fvVectorMatrix inertia();
    Foam::tmp<Foam::fvVectorMatrix> viscosity();
    void predictVelocity(Foam::fvVectorMatrix& UEqn);
    Foam::tmp<Foam::volVectorField> carried(const Foam::fvVectorMatrix& UEqn) const;
    void correctPressure(const Foam::volVectorField& carried, const SolidsOnMesh& solids);
    void solvePressure(const Foam::surfaceScalarField& D, const Foam::surfaceScalarField& predicted);
    Foam::tmp<Foam::surfaceScalarField> memoryOfFlux() const;
    bool compressible() const { return compressibility_.value() > 0; }
    Foam::tmp<Foam::volScalarField> storage() const;
    void finish();
    std::string badCell() const;
    void stepBack();

    Foam::fvMesh& mesh_;
    StageClock& clock_;
    Foam::pimpleControl pimple_;

    Foam::volVectorField U_; ///< interstitial
    Foam::volScalarField p_; ///< over density
    Foam::volScalarField alpha_; ///< void fraction
    Foam::volScalarField ddtAlpha_; ///< of this step, -div(alphaPhi); its old value belongs to alphaPhi's
    Foam::surfaceScalarField alphaPhi_; ///< flux of alpha U
    Foam::surfaceScalarField phi_; ///< flux of U
    Foam::volVectorField push_; ///< all forces of the last step: drag, pressure, gravity [m/s2]
    Foam::volVectorField gradP_; ///< pressure gradient that corrects U and moves particles
    std::unique_ptr<Foam::volVectorField> divTau_; ///< over density [m/s2]; only if the powder feels it
    Foam::volScalarField resistance_; ///< drag and solids, (K/rho + sigma) [1/s]
    Foam::volVectorField source_; ///< (K U_s + carry)/rho + sigma U_wall + alpha g [m/s2]
    Foam::volScalarField bedResistance_; ///< of the bed alone, to its superficial flow, K/(rho a^2) [1/s]
    Foam::volVectorField bedSource_; ///< (K U_s + carry)/(rho a) [m/s2]
    Foam::volScalarField friction_; ///< by solids [1/s]
    Foam::surfaceScalarField fixedFlux_; ///< 1 where a boundary gives the flux
    Foam::surfaceScalarField whole_; ///< 1

    double density_;
    Foam::singlePhaseTransportModel transport_;
    Foam::volScalarField nu_;
    Foam::dimensionedScalar compressibility_; ///< rho/p0 of isothermal air, else zero [s2/m2]
    Foam::dimensionedVector gravity_; ///< of the air; zero unless asked for
    Foam::volVectorField bodyForce_; ///< besides gravity; zero unless the case has such a field
    std::unique_ptr<Turbulence> turbulence_;
    Foam::label pRefCell_ = 0;
    Foam::scalar pRefValue_ = 0;
    Report report_;
};

} // namespace interstice
