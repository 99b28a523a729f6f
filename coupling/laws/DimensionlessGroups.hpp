// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace interstice
{

/// What linear die filling depends on: powder, air, die and shoe.
///
/// Equation numbers in this file are those of *Modeling of Linear Die Filling Based on
/// Dimensional Analysis Using DEM-CFD Methods*, Materials 18(14) (2025) 3261.
struct DieFilling
{
    double particleDiameter; ///< Of the grains, not of the parcels [m].
    double particleDensity; ///< [kg/m3]
    double gasDensity; ///< [kg/m3]
    double gasViscosity; ///< Dynamic [Pa s].
    double gravity; ///< [m/s2]
    double shoeSpeed; ///< [m/s]
    double dieLength; ///< L_D, along the motion of the shoe [m].
    double dieDepth; ///< h_D [m].
};

/// Air sensitivity zeta = rho_a (rho_s - rho_a) g d^3/eta^2 rho_s/rho_a: Archimedes number times
/// density ratio (Eq 15).
double airSensitivity(const DieFilling& filling);

/// Powder hardly feels the air where zeta exceeds this.
///
/// Y. Guo, K.D. Kafui, C.-Y. Wu, C. Thornton & J.P.K. Seville, AIChE J. 55 (2009) 49-62.
constexpr double criticalAirSensitivity = 9.56e6;

/// The air may be left out where zeta exceeds this. In a die air takes some 1.8 points off a filling ratio of 96 % at the
/// number above, and less than one from here on (foam_cases/dieFilling/studies, airSensitivity).
constexpr double airlessSensitivity = 2*criticalAirSensitivity;

/// d_p/h_D.
double sizeRatio(const DieFilling& filling);

/// rho_p/rho_g.
double densityRatio(const DieFilling& filling);

/// Reynolds number of the shoe, v rho_g L_D/mu_g.
double shoeReynolds(const DieFilling& filling);

/// Force number G_p/F_drag (Eq 20): weight over drag of the powder, infinite without drag.
///
/// The drag is without the pressure force, which in a bed is another part of what the air does.
double forceNumber(double weight, double drag);

/// Smallest d_p/h_D that fills the die to 90 %, by the regression of Eq 21:
///
///     0.00256 + 1.77202e-4 v rho_g L_D/mu_g - 1.05607e-6 rho_p/rho_g
///
/// A fit to simulations with one die and air, valid where outsideFillingModel() is empty. It must
/// not be used to vary the die: through v rho_g L_D/mu_g it says that a longer die wants coarser
/// powder, and the same simulations say the opposite.
double sizeRatioFor90Percent(const DieFilling& filling);

/// The quantities that leave the range of Eq 21, one readable line each; empty if all are in it.
std::vector<std::string> outsideFillingModel(const DieFilling& filling);

} // namespace interstice
