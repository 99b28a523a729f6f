// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interstice
{

/// How much an effect is worth beside those that are always there: a number for each, and the limit
/// below which it may be left out. All take grains, never parcels. The sensitivity to air as a whole is
/// airSensitivity() (DimensionlessGroups.hpp).

/// Speed of the air over that of sound. Below 0.1 density follows pressure to less than 1 %.
double machNumber(double speed, double soundSpeed);
constexpr double largestIncompressibleMach = 0.1;

/// Share of the pore air that the weight of a bed squeezes out, rho_b g H/p0: error of the filled depth
/// if trapped air is incompressible.
///
/// @param bulkDensity rho_b [kg/m3]
/// @param height      H of the bed [m]
/// @param pressure    p0, absolute [Pa]
double squeezedAirShare(double bulkDensity, double height, double gravity, double pressure);
constexpr double largestSqueezedAirShare = 0.05;

/// A plug of powder closes a cavity. C = h/(p0 k^2 m): time in which trapped air leaks through the plug
/// over the time in which it would bounce on that air, squared. Well below 1, air leaves before it
/// springs.
///
/// @param cavityDepth  h, of the air below [m]
/// @param pressure     p0, absolute [Pa]
/// @param permeability k, superficial velocity over pressure drop of the plug [m/s/Pa]
/// @param massPerArea  m = alpha_p rho_p H [kg/m2]
double trappedAirNumber(
    double cavityDepth, double pressure, double permeability, double massPerArea);
constexpr double largestStiffTrappedAirNumber = 0.1;

/// Mass of the air that goes with a sphere, C_m = 1/2 of what it displaces, over its own.
///
/// M.R. Maxey & J.J. Riley, Phys. Fluids 26 (1983) 883-889.
double virtualMassShare(double particleDensity, double gasDensity);
constexpr double largestVirtualMassShare = 0.01;

/// History (Basset) force over Stokes' drag, a time after slip began at once: d/(2 sqrt(pi nu t)).
///
/// @param kinematicViscosity nu [m2/s]
/// @param time               t [s]; rho_p d^2/(18 mu) by default of those who ask
double historyShare(double diameter, double kinematicViscosity, double time);
constexpr double largestHistoryShare = 0.1;

/// Lift in a shear flow over Stokes' drag, 1.615 sqrt(rho G d^2/mu)/(3 pi).
///
/// P.G. Saffman, J. Fluid Mech. 22 (1965) 385-400, and 31 (1968) 624.
///
/// @param shearRate G [1/s]
double saffmanShare(double diameter, double gasDensity, double gasViscosity, double shearRate);
constexpr double largestLiftShare = 0.1;

/// Lift of a sphere that spins over Stokes' drag, rho d^2 w/(24 mu).
///
/// S.I. Rubinow & J.B. Keller, J. Fluid Mech. 11 (1961) 447-459.
///
/// @param spin w, relative to the air's [rad/s]
double magnusShare(double diameter, double gasDensity, double gasViscosity, double spin);

/// Force of viscous stresses on the powder over its weight, mu u/L^2/(rho_p g), with a velocity of the
/// air that changes by u over L.
double viscousForceShare(
    double gasViscosity, double speed, double length, double particleDensity, double gravity);
constexpr double largestViscousForceShare = 0.01;

/// Slip of rarefied air on a sphere: 2.52 lambda/d less drag (Cunningham, first term).
///
/// @param meanFreePath lambda [m]
double rarefiedShare(double diameter, double meanFreePath);
constexpr double largestRarefiedShare = 0.05;

/// Mean free path of an ideal gas' molecules, mu sqrt(pi/(2 p rho)) [m].
///
/// S.G. Jennings, J. Aerosol Sci. 19 (1988) 159-166, with mu = rho c lambda/2, c the mean speed of a molecule.
///
/// @param pressure p, absolute [Pa]
double meanFreePath(double gasDensity, double gasViscosity, double pressure);

/// Stokes' drag at a slip over a grain's weight, 18 mu v/(rho_p g d^2): of air that a wall takes along, or of turbulence.
///
/// @param speed v [m/s]
double stokesDragShare(
    double speed, double diameter, double gasViscosity, double particleDensity, double gravity);
constexpr double largestUnseenWallShare = 0.01;
constexpr double largestDispersionShare = 0.1;

/// Van der Waals force of an asperity over a grain's weight, A r/(6 z0^2)/(m g).
///
/// H.C. Hamaker, Physica 4 (1937) 1058-1072.
///
/// @param hamaker        A [J]
/// @param asperityRadius r [m]
/// @param gap            z0 of contact [m]
double bondNumber(double hamaker, double asperityRadius, double gap, double diameter,
    double particleDensity, double gravity);
constexpr double largestBondNumber = 1;

/// A flow is laminar below this Reynolds number.
constexpr double largestLaminarReynolds = 2000;

} // namespace interstice
