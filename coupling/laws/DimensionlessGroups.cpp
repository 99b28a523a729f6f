// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DimensionlessGroups.hpp"

#include <limits>
#include <sstream>

namespace interstice
{

namespace
{

struct Range
{
    const char* name;
    const char* unit;
    double DieFilling::*value;
    double low;
    double high;
};

// The air is one of the fixed parameters of the study, like the die; the width given to those
// allows for rounding only.
constexpr Range rangesOfFillingModel[]{
    {"particle diameter", "m", &DieFilling::particleDiameter, 20e-6, 60e-6},
    {"particle density", "kg/m3", &DieFilling::particleDensity, 3360, 11360},
    {"gas density", "kg/m3", &DieFilling::gasDensity, 1.225, 1.225},
    {"gas viscosity", "Pa s", &DieFilling::gasViscosity, 1.7894e-5, 1.7894e-5},
    {"shoe speed", "m/s", &DieFilling::shoeSpeed, 0.1, 0.2},
    {"die length", "m", &DieFilling::dieLength, 8e-3, 8e-3},
    {"die depth", "m", &DieFilling::dieDepth, 5e-3, 5e-3},
};

} // namespace

double airSensitivity(const DieFilling& filling)
{
    const double d = filling.particleDiameter;
    const double excess = filling.particleDensity - filling.gasDensity;
    const double archimedes = filling.gasDensity * excess * filling.gravity * d * d * d
                              / (filling.gasViscosity * filling.gasViscosity);
    return archimedes * densityRatio(filling);
}

double sizeRatio(const DieFilling& filling)
{
    return filling.particleDiameter / filling.dieDepth;
}

double densityRatio(const DieFilling& filling)
{
    return filling.particleDensity / filling.gasDensity;
}

double shoeReynolds(const DieFilling& filling)
{
    return filling.shoeSpeed * filling.gasDensity * filling.dieLength / filling.gasViscosity;
}

double forceNumber(double weight, double drag)
{
    return drag == 0 ? std::numeric_limits<double>::infinity() : weight / drag;
}

double sizeRatioFor90Percent(const DieFilling& filling)
{
    return 0.00256 + 1.77202e-4 * shoeReynolds(filling) - 1.05607e-6 * densityRatio(filling);
}

std::vector<std::string> outsideFillingModel(const DieFilling& filling)
{
    constexpr double rounding = 1e-3;

    std::vector<std::string> outside;
    for (const Range& range : rangesOfFillingModel)
    {
        const double value = filling.*range.value;
        if (value < range.low * (1 - rounding) || value > range.high * (1 + rounding))
        {
            std::ostringstream line;
            line << range.name << ' ' << value << ' ' << range.unit << ", fitted for " << range.low;
            if (range.high > range.low)
            {
                line << " to " << range.high;
            }
            outside.push_back(line.str());
        }
    }
    return outside;
}

} // namespace interstice
