// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interstice
{

/// Of a sphere, by its diameter [m3].
constexpr double sphereVolume(double diameter)
{
    constexpr double pi = 3.14159265358979323846;
    return pi/6*diameter*diameter*diameter;
}

} // namespace interstice
