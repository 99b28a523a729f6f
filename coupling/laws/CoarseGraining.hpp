// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Parcels: spheres k times as large as the grains they stand for.
///
/// A parcel of diameter k d holds k^3 grains of diameter d and feels what they feel together:
///
///     drag force = k^3 V_grain B(d) (u - v) = V_parcel B(d_parcel/k) (u - v)
///
/// so that drag over mass, and with it every time scale of the exchange with the air, is that of
/// the grains (M. Sakai & S. Koshizuka, Chem. Eng. Sci. 64 (2009) 533-539). Weight and pressure
/// force need no scaling: they go with the parcel's own volume.
class CoarseGraining
{
public:
    /// @param k     diameter of a parcel over that of a grain; 1 means no coarse graining
    /// @param where file and key that k was read from, for the message
    /// @throws InputError for k below one or not finite
    explicit CoarseGraining(double k = 1, const std::string& where = {});

    double factor() const noexcept { return k_; }

    /// Grains in a parcel, k^3.
    double grainsPerParcel() const noexcept { return k_ * k_ * k_; }

    /// Diameter of the grains in a parcel [m].
    double originalDiameter(double parcelDiameter) const noexcept { return parcelDiameter / k_; }

    /// Drag coefficient b [kg/s] of a parcel, for which its drag force is b (u - v).
    ///
    /// @param air the air around the parcel; its diameter is the parcel's
    double parcelDragCoefficient(const DragLaw& law, LocalFlow air) const
    {
        const double volume = pi_ / 6 * air.diameter * air.diameter * air.diameter;
        air.diameter = originalDiameter(air.diameter);
        return volume * law.coefficientPerVolume(air);
    }

private:
    static constexpr double pi_ = 3.14159265358979323846;

    double k_;
};

} // namespace interstice
