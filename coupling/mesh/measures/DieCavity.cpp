// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/measures/DieCavity.hpp"

#include "coupling/laws/InputError.hpp"
#include "coupling/mesh/Parameters.hpp"

#include "OSspecific.H"
#include "triSurface.H"
#include "triSurfaceSearch.H"

#include <algorithm>

namespace interstice
{

using namespace Foam;

namespace
{

boundBox readBox(const Parameters& p)
{
    const boundBox box(p.direction("low", "m"), p.direction("high", "m"));
    if (!(cmptMin(box.span()) > 0))
    {
        throw InputError({"The corners of a die must span a volume.",
            "low and high differ by " + std::to_string(box.span().x()) + ", "
                + std::to_string(box.span().y()) + ", " + std::to_string(box.span().z()) + " m",
            "more than zero in each direction", p.where("high"), "Correct low or high."});
    }
    return box;
}

} // namespace

double shareBelow(double height, double radius)
{
    const double s = std::clamp(height/radius, -1.0, 1.0);
    return 0.25*(1 + s)*(1 + s)*(2 - s);
}

Extent extentAlong(const boundBox& box, const vector& direction)
{
    const double centre = box.midpoint() & direction;
    const double half = 0.5*(box.span() & cmptMag(direction));
    return {centre - half, centre + half};
}

DieCavity::DieCavity(const dictionary& dict, const Time& time)
{
    const Parameters p(dict);
    if (!p.has("surface"))
    {
        bounds_ = readBox(p);
        p.allKnown();
        return;
    }
    const fileName file = time.globalPath()/p.text("surface");
    p.allKnown();
    if (!isFile(file))
    {
        throw InputError({"The surface of the die cannot be read.", "no file " + file, "",
            p.where("surface"), "Correct the path, which starts at the case's folder."});
    }
    surface_ = std::make_unique<triSurface>(file);
    search_ = std::make_unique<triSurfaceSearch>(*surface_);
    // Without other ranks: every rank holds the whole surface.
    bounds_ = boundBox(surface_->points(), false);
}

DieCavity::~DieCavity() = default;

bool DieCavity::holds(const vector& point) const
{
    for (direction d = 0; d < 3; ++d)
    {
        if (!(point[d] >= bounds_.min()[d] && point[d] < bounds_.max()[d]))
        {
            return false;
        }
    }
    return !search_ || search_->tree().getVolumeType(point) == volumeType::INSIDE;
}

double DieCavity::share(const vector& centre, double radius) const
{
    const double below = shareBelow(top() - centre.z(), radius);
    if (below <= 0)
    {
        return 0;
    }
    // What sticks out upwards stands in the mouth if it does so just below it.
    const double justBelow = top() - 1e-6*(top() - bounds_.min().z());
    const vector foot(centre.x(), centre.y(), min(centre.z(), justBelow));
    return holds(foot) ? below : 0;
}

} // namespace interstice
