// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/MovingSolid.hpp"

#include "coupling/laws/InputError.hpp"

#include "OSspecific.H"
#include "triSurfaceMesh.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace interstice
{

using namespace Foam;

namespace
{

std::string metres(double length)
{
    std::ostringstream text;
    text << length << " m";
    return text.str();
}

triSurface readClosed(const fileName& path, const std::string& where)
{
    if (!isFile(path))
    {
        throw InputError({"The surface of a solid must be a readable file.", "no file " + path,
            "an STL or OBJ file", where, "Correct the path or create the file."});
    }
    return triSurface(path);
}

// Distance through the body from the middle of each triangle, straight inwards; the smallest.
scalar thinnest(const triSurfaceMesh& surface)
{
    const scalar span = mag(surface.bounds().span());
    pointField start(surface.size());
    pointField end(surface.size());
    forAll(start, i)
    {
        const vector inward = -surface.faceNormals()[i];
        start[i] = surface.faceCentres()[i] + 1e-6*span*inward;
        end[i] = surface.faceCentres()[i] + span*inward;
    }
    List<pointIndexHit> hits;
    surface.findLine(start, end, hits);
    scalar least = span;
    forAll(hits, i)
    {
        if (hits[i].hit())
        {
            least = min(least, mag(hits[i].hitPoint() - surface.faceCentres()[i]));
        }
    }
    return least;
}

constexpr scalar sharpest = 1e-3; // ramp of a surface, in cells

// From 1 inside to 0 outside. Distances in widths of the ramp.
scalar ramp(scalar distance)
{
    return min(max(0.5 - distance, scalar(0)), scalar(1));
}

// Integral of the ramp from the surface to a distance.
scalar integral(scalar distance)
{
    const scalar x = min(max(distance, scalar(-0.5)), scalar(0.5));
    return 0.5*x*(1 - x) + min(distance + 0.5, scalar(0));
}

// Mean of the ramp between two distances.
scalar meanRamp(scalar from, scalar to)
{
    const scalar way = to - from;
    return mag(way) > 1e-6 ? (integral(to) - integral(from))/way : ramp(from);
}

// Where no point is covered yet, how far off the surface is tells what the air's shear needs.
scalar besides(scalar covered, scalar depth)
{
    return covered > 0 ? covered : min(depth, scalar(0));
}

} // namespace

MovingSolid::MovingSolid(const fvMesh& mesh, const std::string& name, const fileName& surface,
    const std::string& where)
:
    mesh_(mesh),
    name_(name),
    width_(mesh.nCells()),
    extent_(mesh.nCells())
{
    forAll(mesh.V(), celli)
    {
        width_[celli] = std::cbrt(mesh.V()[celli]);
        extent_[celli] = boundBox(mesh.points(), mesh.cellPoints()[celli], false).span();
    }
    tabulate(surface, where);
}

void MovingSolid::tabulate(const fileName& path, const std::string& where)
{
    const triSurfaceMesh surface(
        IOobject(name_, mesh_.time().constant(), mesh_.time(), IOobject::NO_READ,
            IOobject::NO_WRITE, false),
        readClosed(path, where));
    if (!surface.hasVolumeType())
    {
        throw InputError({"A solid that the air sees must be closed, so that it has an inside.",
            "an open surface in " + path, "a watertight surface", where,
            "Close it (surfaceCheck shows the open edges)."});
    }
    const scalar coarsest =
        returnReduce(width_.empty() ? 0 : *std::max_element(width_.begin(), width_.end()),
            maxOp<scalar>());
    const scalar finest =
        returnReduce(width_.empty() ? GREAT : *std::min_element(width_.begin(), width_.end()),
            minOp<scalar>());
    thickness_ = thinnest(surface);
    if (leaksIn(finest))
    {
        throw InputError({"A solid must be at least two cells thick, or air leaks through it.",
            metres(thickness_) + " thick in " + path, "at least " + metres(2*finest), where,
            "Thicken it outwards, where there is only air, or refine the mesh."});
    }

    table_.spacing = finest/2;
    table_.low = surface.bounds().min() - vector::one*coarsest;
    const vector high = surface.bounds().max() + vector::one*coarsest;
    for (direction d = 0; d < 3; ++d)
    {
        table_.nodes[d] = 2 + static_cast<int>((high[d] - table_.low[d])/table_.spacing);
    }
    table_.tangents.reserve(std::size_t(table_.nodes[0])*table_.nodes[1]*table_.nodes[2]);
    // Layer by layer: the search needs thirty times the memory of what is kept.
    for (int k = 0; k < table_.nodes[2]; ++k)
    {
        tabulateLayer(surface, k);
    }
}

void MovingSolid::tabulateLayer(const triSurfaceMesh& surface, int k)
{
    pointField nodes(table_.nodes[0]*table_.nodes[1]);
    forAll(nodes, n)
    {
        const label i = n % table_.nodes[0];
        const label j = n/table_.nodes[0];
        nodes[n] = table_.low + table_.spacing*vector(i, j, k);
    }
    List<pointIndexHit> nearest;
    surface.findNearest(nodes, scalarField(nodes.size(), GREAT), nearest);
    List<volumeType> side;
    surface.getVolumeType(nodes, side);
    forAll(nodes, n)
    {
        const vector away = nodes[n] - nearest[n].hitPoint();
        const scalar distance = mag(away);
        const scalar sign = side[n] == volumeType::INSIDE ? -1 : 1;
        const vector slope = distance > 1e-6*table_.spacing
            ? sign/distance*away
            : surface.faceNormals()[nearest[n].index()];
        table_.tangents.push_back({static_cast<float>(sign*distance), static_cast<float>(slope.x()),
            static_cast<float>(slope.y()), static_cast<float>(slope.z())});
    }
}

scalar MovingSolid::DistanceTable::at(const vector& point) const
{
    int index[3];
    scalar f[3];
    for (direction d = 0; d < 3; ++d)
    {
        const scalar x = (point[d] - low[d])/spacing;
        if (x < 0 || x >= nodes[d] - 1)
        {
            return far;
        }
        index[d] = static_cast<int>(x);
        f[d] = x - index[d];
    }
    scalar sum = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
        const int i = corner & 1;
        const int j = (corner >> 1) & 1;
        const int k = corner >> 2;
        const auto& t = tangents[index[0] + i + nodes[0]*(index[1] + j + nodes[1]*(index[2] + k))];
        const scalar there = t[0] + spacing*(t[1]*(f[0] - i) + t[2]*(f[1] - j) + t[3]*(f[2] - k));
        sum += there*(i ? f[0] : 1 - f[0])*(j ? f[1] : 1 - f[1])*(k ? f[2] : 1 - f[2]);
    }
    return sum;
}

vector MovingSolid::DistanceTable::gradient(const vector& point) const
{
    vector slope;
    for (direction d = 0; d < 3; ++d)
    {
        vector step(Zero);
        step[d] = 0.5*spacing;
        slope[d] = (at(point + step) - at(point - step))/spacing;
    }
    return slope;
}

MovingSolid::Seen MovingSolid::outside(const RigidPose& pose, const vector& point) const
{
    const RigidPose::Vector there = pose.toReference({point.x(), point.y(), point.z()});
    const vector inBody(there[0], there[1], there[2]);
    const scalar distance = table_.at(inBody);
    if (distance >= 0)
    {
        return {point, 1};
    }
    const vector slope = table_.gradient(inBody);
    const vector onSurface = inBody - distance*slope/max(mag(slope), SMALL);
    const RigidPose::Vector here = pose.fromReference({onSurface.x(), onSurface.y(), onSurface.z()});
    const scalar halfCell = table_.spacing;
    return {vector(here[0], here[1], here[2]), max(1 + distance/halfCell, scalar(0))};
}

scalar MovingSolid::distance(const RigidPose& pose, const vector& point) const
{
    const RigidPose::Vector there = pose.toReference({point.x(), point.y(), point.z()});
    return table_.at(vector(there[0], there[1], there[2]));
}

// Eight points see an edge as it is, where the centre of the cell alone would round it.
scalar MovingSolid::share(const RigidPose& pose, label celli) const
{
    const vector& centre = mesh_.C()[celli];
    const scalar width = width_[celli];
    const scalar from = distance(pose, centre);
    const scalar depth = max(0.5 - from/width, scalar(-0.5));
    const scalar reach = cmptMax(extent_[celli]);
    if (mag(from) > reach)
    {
        return min(depth, scalar(1));
    }
    scalar distances[8];
    vector change(Zero); // of the distance, along x, y and z over four eighths
    for (int eighth = 0; eighth < 8; ++eighth)
    {
        const vector side(eighth & 1 ? 1 : -1, eighth & 2 ? 1 : -1, eighth & 4 ? 1 : -1);
        distances[eighth] = min(distance(pose, centre + 0.25*cmptMultiply(side, extent_[celli])), reach);
        change += 0.25*distances[eighth]*side;
    }
    const scalar across = max(mag(change), sharpest*width);
    scalar sum = 0;
    for (const scalar here : distances)
    {
        sum += ramp(here/across);
    }
    return besides(sum/8, depth);
}

// Each point stands for a quarter of the face, over which the distance changes as it does between the
// points: not at all if the surface comes along the face's normal.
scalar MovingSolid::coverOfFace(const RigidPose& before, const RigidPose& now, label facei) const
{
    const vector& centre = mesh_.faceCentres()[facei];
    const vector normal = normalised(mesh_.faceAreas()[facei]);
    const scalar width = std::sqrt(mag(mesh_.faceAreas()[facei]));
    const scalar from = distance(before, centre);
    const scalar to = distance(now, centre);
    const scalar depth = max(0.5 - 0.5*(from + to)/width, scalar(-0.5));
    if (min(from, to) > width || max(from, to) < -width)
    {
        return min(depth, scalar(1));
    }
    const vector first = normalised(normal ^ (mag(normal.x()) > 0.5 ? vector(0, 1, 0) : vector(1, 0, 0)));
    const vector second = normal ^ first;
    const scalar lengths[] = {extent(facei, first), extent(facei, second)};
    scalar was[4];
    scalar is[4];
    for (int quarter = 0; quarter < 4; ++quarter)
    {
        const vector aside = (quarter & 1 ? 1 : -1)*lengths[0]*first + (quarter & 2 ? 1 : -1)*lengths[1]*second;
        was[quarter] = min(distance(before, centre + 0.25*aside), 2*width);
        is[quarter] = min(distance(now, centre + 0.25*aside), 2*width);
    }
    const scalar across = max(
        0.5*std::hypot(is[1] - is[0] + is[3] - is[2], is[2] - is[0] + is[3] - is[1]), sharpest*width);
    scalar sum = 0;
    for (int quarter = 0; quarter < 4; ++quarter)
    {
        sum += meanRamp(was[quarter]/across, is[quarter]/across);
    }
    return besides(sum/4, depth);
}

scalar MovingSolid::extent(label facei, const vector& direction) const
{
    scalar low = GREAT;
    scalar high = -GREAT;
    for (const label pointi : mesh_.faces()[facei])
    {
        const scalar along = mesh_.points()[pointi] & direction;
        low = min(low, along);
        high = max(high, along);
    }
    return high - low;
}

scalar MovingSolid::cover(const RigidPose& pose, scalarField& covered,
    volVectorField& velocity) const
{
    scalar widest = 0;
    forAll(covered, celli)
    {
        const scalar here = share(pose, celli);
        if (here > 0 && here < 1)
        {
            widest = max(widest, width_[celli]);
        }
        if (here > covered[celli])
        {
            const vector& c = mesh_.C()[celli];
            const RigidPose::Vector v = pose.velocityAt({c.x(), c.y(), c.z()});
            covered[celli] = here;
            velocity[celli] = vector(v[0], v[1], v[2]);
        }
    }
    return widest;
}

} // namespace interstice
