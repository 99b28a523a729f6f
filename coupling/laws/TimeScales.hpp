// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interstice
{

/// Time for a surface wave to travel over half a particle [s]; a DEM step takes a fifth of it or
/// less.
///
///     pi R sqrt(rho/G)/(0.1631 nu + 0.8766),   G = E/(2 + 2 nu)
///
/// In a mixed powder the smallest, heaviest and softest particle decides.
///
/// Y. Li, Y. Xu & C. Thornton, Powder Technol. 160 (2005) 219-228.
///
/// @param radius        R [m]
/// @param density       of the particle [kg/m3]
/// @param youngsModulus E [Pa]
/// @param poissonRatio  nu
double rayleighTime(double radius, double density, double youngsModulus, double poissonRatio);

/// Duration of an elastic Hertz impact [s]; a DEM step takes a tenth to a fifth of it.
///
///     2.87 [m*^2/(R* Y*^2 v)]^(1/5)
///
/// K.L. Johnson, Contact Mechanics, Cambridge (1985), section 11.4.
///
/// @param effectiveMass    m* = m1 m2/(m1 + m2) [kg]; m for a wall
/// @param effectiveRadius  R* = R1 R2/(R1 + R2) [m]; R for a wall
/// @param effectiveModulus 1/Y* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa]
/// @param speed            of approach, above 0 [m/s]
double hertzTime(
    double effectiveMass, double effectiveRadius, double effectiveModulus, double speed);

/// Time scales of the exchange between powder and air where they share a volume.
///
/// Independent of coarse graining, because drag and mass of a parcel grow alike.
struct ExchangeScales
{
    double voidFraction; ///< alpha_f, in (0, 1).
    double particleDensity; ///< [kg/m3]
    double gasDensity; ///< [kg/m3]
    double coefficientPerVolume; ///< B of the drag law [kg/m3/s], above 0.

    /// tau_p = rho_p/B [s]: a particle takes on the velocity of air that does not yield.
    double particleTime() const noexcept;

    /// tau_f = alpha_f rho_f/beta [s]: air takes on the velocity of particles that do not yield.
    double gasTime() const noexcept;

    /// [1/tau_f + B/rho_p]^-1 [s]: the slip decays when both yield and nothing holds them.
    double mutualTime() const noexcept;

    /// tau_eff = alpha_f^2 tau_p [s]: a bed over a closed volume takes on its sinking velocity.
    /// The air has to pass it through the pores, which makes the drag felt by the bed
    /// 1/alpha_f^2 times as stiff: the time scale that a coupling step has to respect.
    double sealedBedTime() const noexcept;

    /// Longest stable coupling step with drag and pressure gradient frozen over it [s]:
    /// 2 tau_eff. A scalar model of a sealed bed, f = -beta v/alpha_f^2.
    double explicitLimit() const noexcept;

    /// Longest stable coupling step with drag at the current velocity of the particle and the
    /// pressure gradient frozen [s]: 2 tau_eff/(1 - 2 alpha_f^2), infinite from
    /// alpha_f = sqrt(1/2) = 0.707 on.
    double implicitDragLimit() const noexcept;

    /// Longest coupling step recommended for accuracy [s]: tau_eff/5.
    double recommendedStep() const noexcept;
};

/// Longest DEM step [s] with which the tangential dashpot of an impact does not make slip grow, in
/// LIGGGHTS' contact model `tangential history`, which applies it explicitly:
///
///     2 m*/(7/2 gamma_t),  gamma_t = 2 sqrt(5/6) b sqrt(8 G* sqrt(R* d) m*),
///     b = -ln e/sqrt(ln^2 e + pi^2)
///
/// with the factor 7/2 of a sphere that slips and turns, at the largest overlap d of an elastic impact,
/// d = (15 m* v^2/(16 Y* sqrt(R*)))^(2/5). A particle in a corner has two such dashpots.
///
/// @param effectiveMass, effectiveRadius, effectiveModulus, speed   as in hertzTime
/// @param shearModulus  1/G* = (2 - nu1)/G1 + (2 - nu2)/G2 [Pa]
/// @param restitution   e, in (0, 1]; infinite time at 1
double tangentialDampingTime(double effectiveMass, double effectiveRadius, double effectiveModulus,
    double shearModulus, double restitution, double speed);

/// M = (rho_f/rho_p) alpha_p/alpha_f: mass of the air that has to go back as powder goes ahead, times
/// its detour, over that of the powder.
double displacedMassNumber(double voidFraction, double particleDensity, double gasDensity);

/// Frequency [Hz] at which a plug of powder bounces on the air it has trapped, if the air is
/// compressible and slow to leave:
///
///     sqrt[p0/(h alpha_p rho_p H)]/(2 pi)
///
/// A step that follows it is at most a twentieth of its period.
///
/// @param pressure        p0, absolute [Pa]
/// @param cavityDepth     h, of the air below the plug [m]
/// @param solidFraction   alpha_p of the plug
/// @param particleDensity rho_p [kg/m3]
/// @param plugHeight      H [m]
double trappedAirFrequency(double pressure, double cavityDepth, double solidFraction,
    double particleDensity, double plugHeight);

} // namespace interstice
