# SPDX-License-Identifier: GPL-3.0-or-later
"""Dies of other shapes than a box: a closed body of table and die, and how their plan is divided.

A die is a stack of plans, each a loop of points around the middle of the die, counter-clockwise, all of them seen
from the middle. So rays from the middle cut the table around it into sound triangles, and all of them meet.
"""
import math

import numpy as np

TEETH = 8
ROOT = 0.75     # of a gear's teeth, to its outer radius
SHARP = math.radians(60)    # of two corners of a rhombus


def middle(p):
    return np.array([0.5*p["dieLength"], 0.0])


def halves(p):
    """Half the length and half the width of a shape: the largest that fits into the die's box."""
    a, b = 0.5*p["dieLength"], 0.5*p["dieWidth"]
    if p["dieShape"] == "rhombic":
        a = min(a, b/math.tan(0.5*SHARP))
        return a, a*math.tan(0.5*SHARP)
    if p["dieShape"] == "gear":
        return min(a, b), min(a, b)
    return a, b


def stepped(p, d):
    """Half as long from half the depth on. In a slice it goes on beyond its ends."""
    a, b = halves(p)
    b = b if d["rig"] == "full" else 3*d["dieYHigh"]
    upper = [(-a, -b), (-a/2, -b), (a/2, -b), (a, -b), (a, b), (a/2, b), (-a/2, b), (-a, b)]
    lower = [(-a/2, -b), (a/2, -b), (a/2, b), (-a/2, b)]
    ledges = [[(-a, -b), (-a/2, -b), (-a/2, b), (-a, b)], [(a/2, -b), (a, -b), (a, b), (a/2, b)]]
    return [upper, lower], ledges


def rhombic(p, d):
    """Its long diagonal lies along the shoe's way."""
    a, b = halves(p)
    return [[(a, 0), (0, b), (-a, 0), (0, -b)]], []


def gear(p, d):
    """A sixth of each pitch to a flank, a third to the tip and to the root; all straight."""
    radius = halves(p)[0]
    pitch = 2*math.pi/TEETH
    corners = [(i + at)*pitch for i in range(TEETH) for at in (-1/3, -1/6, 1/6, 1/3)]
    radii = [radius*r for _ in range(TEETH) for r in (ROOT, 1, 1, ROOT)]
    return [[(r*math.cos(angle), r*math.sin(angle)) for r, angle in zip(radii, corners)]], []


SHAPES = {"stepped": stepped, "rhombic": rhombic, "gear": gear}


def body(p, d):
    """Triangles of table and die, closed, normals outwards, below z = 0 and wider than both engines' boxes."""
    loops, ledges = SHAPES[p["dieShape"]](p, d)
    loops = [middle(p) + np.array(loop) for loop in loops]
    levels = np.linspace(0, d["dieZLow"], len(loops) + 1)
    low, high, bottom = extent(p, d)
    triangles, rim = table(loops[0], middle(p), low, high)
    for loop, top, foot in zip(loops, levels, levels[1:]):
        triangles += walls(loop, top, foot)
    for ledge in ledges:
        triangles += flat(middle(p) + np.array(ledge), levels[1])
    triangles += fan(loops[-1], middle(p), levels[-1])
    triangles += walls(rim[::-1], 0, bottom) + fan(rim[::-1], middle(p), bottom)
    return np.array(triangles)


def extent(p, d):
    """Two corners in plan, and the height of the lower side."""
    beyond = max(8e-3, d["shoeXLow"] - d["xLow"] + 1e-3)
    y = d["yHigh"] + beyond if d["rig"] == "full" else 4*d["dieYHigh"]
    return (np.array([d["shoeXLow"] - beyond, -y]),
            np.array([d["shoeXHigh"] + d["travel"] + beyond, y]), d["dieZLow"] - 3*p["cellSize"])


def at(point, z):
    return (*map(float, point), float(z))


def flat(points, z):
    """A convex polygon, from above counter-clockwise."""
    return [(at(points[0], z), at(a, z), at(b, z)) for a, b in zip(points[1:], points[2:])]


def fan(loop, centre, z):
    return [(at(centre, z), at(a, z), at(b, z)) for a, b in zip(loop, np.roll(loop, -1, axis=0))]


def walls(loop, top, foot):
    """Of a hole; of what stands around it if the loop is clockwise."""
    triangles = []
    for a, b in zip(loop, np.roll(loop, -1, axis=0)):
        triangles += [(at(a, top), at(b, top), at(b, foot)), (at(a, top), at(b, foot), at(a, foot))]
    return triangles


def table(loop, centre, low, high):
    """From the mouth to a rectangle, in rings that grow with the distance; and the rectangle's points."""
    rays = loop - centre
    with np.errstate(divide="ignore"):
        stretch = np.min(np.where(rays > 0, (high - centre)/rays, np.where(rays < 0, (low - centre)/rays,
                                                                           np.inf)), axis=1)[:, None]
    count = math.ceil(math.log(stretch.max())/math.log(1.6))
    rings = [centre + rays*stretch**(k/count) for k in range(count + 1)]
    triangles, rim = [], []
    for i in range(len(loop)):
        j = (i + 1) % len(loop)
        for inner, outer in zip(rings, rings[1:]):
            triangles += flat([inner[i], outer[i], outer[j], inner[j]], 0)
        side = [rings[-1][i], *cornersBetween(rings[-1][i], rings[-1][j], centre, low, high), rings[-1][j]]
        triangles += flat(side, 0)
        rim += side[:-1]
    return triangles, np.array(rim)


def cornersBetween(a, b, centre, low, high):
    """Corners of the rectangle on the way from one point of it to another, counter-clockwise."""
    angle = lambda q: math.atan2(*(q - centre)[::-1])
    way = (angle(b) - angle(a)) % (2*math.pi)
    corners = [np.array([x, y]) for x in (low[0], high[0]) for y in (low[1], high[1])]
    past = sorted(((angle(q) - angle(a)) % (2*math.pi), *q) for q in corners)
    return [np.array(q) for turn, *q in past if 1e-9 < turn < way - 1e-9]


def sectors(p, rig, x, y):
    """Number of the part of the plan in which each point lies: a grid of nine (three in a slice); of a rhombus its
    core and four corners, of a gear the core behind each tooth and the tooth."""
    u, v = x - middle(p)[0], y
    a, b = halves(p)
    if p["dieShape"] == "rhombic":
        turn = np.floor(np.arctan2(v/b, u/a)/(math.pi/2) + 0.5).astype(int) % 4
        return np.where(np.abs(u)/a + np.abs(v)/b < 0.5, 0, 1 + turn)
    if p["dieShape"] == "gear":
        turn = np.floor(np.arctan2(v, u)/(2*math.pi/TEETH) + 0.5).astype(int) % TEETH
        return turn + TEETH*(np.hypot(u, v) > ROOT*a)
    third = lambda w, half: np.clip(np.floor(1.5*(w/half + 1)), 0, 2).astype(int)
    return third(u, a) + (3*third(v, b) if rig == "full" else 0)
