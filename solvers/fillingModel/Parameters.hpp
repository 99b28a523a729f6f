// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/Laws.hpp"

#include <optional>

namespace interstice
{

/// A quantity that a user gives: column of a table, option of a command, key of a model file.
struct Parameter
{
    const char* name;
    const char* unit;
    const char* meaning;
    double DieFilling::*value;
    std::optional<double> usual; ///< Taken where an option is not given.
};

/// All of them. Gravity is not among them: the model does not depend on it.
constexpr Parameter parameters[]{
    {"particleDiameter", "m", "d_p, of the grains", &DieFilling::particleDiameter, {}},
    {"particleDensity", "kg/m3", "rho_p", &DieFilling::particleDensity, {}},
    {"shoeSpeed", "m/s", "v", &DieFilling::shoeSpeed, {}},
    {"dieLength", "m", "L_D, along the motion of the shoe", &DieFilling::dieLength, {}},
    {"dieDepth", "m", "h_D", &DieFilling::dieDepth, {}},
    {"airDensity", "kg/m3", "rho_g", &DieFilling::gasDensity, 1.225},
    {"airViscosity", "Pa s", "mu_g, dynamic", &DieFilling::gasViscosity, 1.7894e-5},
};

} // namespace interstice
