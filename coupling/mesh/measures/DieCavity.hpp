// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Time.H"
#include "boundBox.H"
#include "dictionary.H"
#include "vector.H"

#include <memory>

namespace Foam
{
class triSurface;
class triSurfaceSearch;
} // namespace Foam

namespace interstice
{

/// Share of a sphere's volume that lies below a plane, `height` [m] above its centre.
///
/// A cap of height h = radius + height: V/V_sphere = h^2 (3 r - h)/(4 r^3).
double shareBelow(double height, double radius);

/// From where to where something reaches [m].
struct Extent
{
    double low;
    double high;
};

/// The extent of a box along a direction of unit length.
Extent extentAlong(const Foam::boundBox& box, const Foam::vector& direction);

/// The room of a die that powder fills; its mouth is the plane z = top(), z points up.
///
/// A particle is in the die if its centre is within walls and floor, but the mouth cuts it
/// exactly: a particle that sticks out counts with its part below the mouth, also when its centre
/// is above. So the mass in the die changes continuously when powder passes the mouth.
///
///     die { low (0 0 -0.005); high (0.008 0.008 0); }
///     die { surface "constant/triSurface/die.stl"; }
///
/// Property | Description                                         | Unit | Default
/// low      | corner of a box                                     | m    | required without surface
/// high     | opposite corner; its z is the mouth                 | m    | required without surface
/// surface  | closed surface, lid included; its top is the mouth  |      | none
class DieCavity
{
public:
    /// Reads the dictionary `die` and, on every rank, the surface. Throws InputError.
    DieCavity(const Foam::dictionary& dict, const Foam::Time& time);
    ~DieCavity();

    const Foam::boundBox& bounds() const { return bounds_; }
    double top() const { return bounds_.max().z(); } ///< [m]

    /// Whether a point [m] is within the cavity. Walls at the high end are outside.
    bool holds(const Foam::vector& point) const;

    /// Share of a particle's volume in the cavity [-].
    double share(const Foam::vector& centre, double radius) const;

private:
    Foam::boundBox bounds_;
    std::unique_ptr<Foam::triSurface> surface_;
    std::unique_ptr<Foam::triSurfaceSearch> search_;
};

} // namespace interstice
