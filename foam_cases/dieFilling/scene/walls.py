# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls as the powder meets them (sheets) and as the air does (closed bodies), or the user's own."""
import math

import numpy as np

import stl
from wrong import refuse

ON_TABLE = 1e-6     # how far a surface may be from where it should be: a twentieth of the shoe's gap [m]


def quad(a, b, c, e):
    return [(a, b, c), (a, c, e)]


def box(low, high):
    """Closed, normals outwards."""
    (x, y, z), (u, v, w) = low, high
    return (quad((x, y, z), (x, v, z), (u, v, z), (u, y, z))
            + quad((x, y, w), (u, y, w), (u, v, w), (x, v, w))
            + quad((x, y, z), (u, y, z), (u, y, w), (x, y, w))
            + quad((x, v, z), (x, v, w), (u, v, w), (u, v, z))
            + quad((x, y, z), (x, y, w), (x, v, w), (x, v, z))
            + quad((u, y, z), (u, v, z), (u, v, w), (u, y, w)))


def rectangle(x, y, z):
    """Normal to the direction whose two ends coincide, split into pieces of a few millimetres:
    LIGGGHTS searches by triangle."""
    ends = [x, y, z]
    flat = next(i for i in range(3) if ends[i][0] == ends[i][1])
    i, j = [k for k in range(3) if k != flat]
    grids = [np.linspace(*ends[k], max(1, math.ceil((ends[k][1] - ends[k][0])/5e-3)) + 1)
             for k in (i, j)]
    triangles = []
    for a, b in zip(grids[0], grids[0][1:]):
        for c, e in zip(grids[1], grids[1][1:]):
            corners = []
            for u, v in ((a, c), (b, c), (b, e), (a, e)):
                point = [0, 0, 0]
                point[flat], point[i], point[j] = ends[flat][0], u, v
                corners.append(tuple(point))
            triangles += quad(*corners)
    return triangles


def dieWalls(p, d):
    """Table and cavity: sheets."""
    length, low = p["dieLength"], d["dieZLow"]
    y, across = (d["demYLow"], d["demYHigh"]), (d["dieYLow"], d["dieYHigh"])
    walls = (rectangle((d["demXLow"], 0), y, (0, 0))
             + rectangle((length, d["demXHigh"]), y, (0, 0))
             + rectangle((0, length), across, (low, low))
             + rectangle((0, 0), across, (low, 0)) + rectangle((length, length), across, (low, 0)))
    if d["rig"] == "full":
        for end, side in ((d["demYLow"], d["dieYLow"]), (d["demYHigh"], d["dieYHigh"])):
            walls += rectangle((0, length), tuple(sorted((end, side))), (0, 0))
            walls += rectangle((0, length), (side, side), (low, 0))
    return walls


def shoeWalls(p, d):
    """Inner and outer face of the walls, and their lower edge that slides over the powder."""
    low, wall = p["shoeGap"], p["shoeWallThickness"]
    x, y = (d["shoeXLow"], d["shoeXHigh"]), (d["shoeYLow"], d["shoeYHigh"])
    z = (low, p["shoeHeight"])
    outX, outY = (x[0] - wall, x[1] + wall), (y[0] - wall, y[1] + wall)
    full = d["rig"] == "full"
    walls = []
    for inner, outer in zip(x, outX):
        walls += rectangle((inner, inner), y, z)
        walls += rectangle((outer, outer), outY if full else y, z)
        walls += rectangle(tuple(sorted((inner, outer))), y, (low, low))
    for inner, outer in zip(y, outY) if full else ():
        walls += rectangle(x, (inner, inner), z) + rectangle(outX, (outer, outer), z)
        walls += rectangle(outX, tuple(sorted((inner, outer))), (low, low))
    return walls


def shoeSolid(p, d):
    """The walls as a closed body that stands on the table; in a slice they go on beyond its ends."""
    x0, x1, y1 = d["shoeXLow"], d["shoeXHigh"], d["shoeYHigh"]
    wall, top = p["shoeWallThickness"], max(p["shoeHeight"], d["zHigh"] + 2*p["cellSize"])
    if d["rig"] == "slice":
        y = 3*y1
        return box((x0 - wall, -y, 0), (x0, y, top)) + box((x1, -y, 0), (x1 + wall, y, top))
    corners = lambda e, z: [(x0 - e, -y1 - e, z), (x1 + e, -y1 - e, z),
                            (x1 + e, y1 + e, z), (x0 - e, y1 + e, z)]
    inLow, inHigh, outLow, outHigh = corners(0, 0), corners(0, top), corners(wall, 0), \
        corners(wall, top)
    solid = []
    for i in range(4):
        j = (i + 1) % 4
        solid += quad(outLow[i], outLow[j], outHigh[j], outHigh[i])
        solid += quad(inLow[j], inLow[i], inHigh[i], inHigh[j])
        solid += quad(inLow[i], inLow[j], outLow[j], outLow[i])
        solid += quad(inHigh[j], inHigh[i], outHigh[i], outHigh[j])
    return solid


def given(case, p, name):
    """Triangles of the user's surface for "die" or "shoe"; none if there is no such surface."""
    surface = p[name + "Surface"]
    if surface == "none":
        return np.empty((0, 3, 3))
    if not (case/surface).is_file():
        refuse(f"{name}Surface in system/caseParameters must be an STL file in {case}.",
               f"{surface}, which is no file there", "an STL file",
               "Correct the path, or write none to have the surface made.")
    triangles = stl.read(case/surface)
    if not len(triangles):
        refuse(f"{name}Surface must be an STL file.", f"no whole triangles in {surface}",
               "STL, as text or binary", "Write the file again.")
    closed(name, surface, triangles)
    return triangles


def closed(name, surface, triangles):
    edges = stl.openEdges(triangles)
    if len(edges):
        place = "({:.4g} {:.4g} {:.4g})".format(*edges[0].mean(axis=0))
        refuse(f"{name}Surface must be closed: each edge shared by two triangles that agree on where outside is.",
               f"{len(edges)} others in {surface}, one at {place} m", "none",
               "Close the surface (surfaceCheck shows where it is open).")
    if stl.volume(triangles) <= 0:
        refuse(f"{name}Surface must have its normals outwards.", f"normals inwards in {surface}",
               "normals outwards", "Turn them (surfaceOrient).")


def meetsTable(p, d, die):
    """The user's die must have its rim on the table, and its cavity in the box that says how large it is."""
    top = die[:, :, 2].max()
    if abs(top) > ON_TABLE:
        refuse("dieSurface does not meet the table: its rim, the highest point, must be at z = 0.",
               f"{top:.6g} m in {p['dieSurface']}", f"0, to {ON_TABLE:g} m",
               "Move the surface; lengths are in metres.")
    ground = die[(stl.plan(die) > 0) & (die[:, :, 2].min(axis=1) < -ON_TABLE)].reshape(-1, 3)
    wanted = [(0, p["dieLength"]), (-0.5*p["dieWidth"], 0.5*p["dieWidth"]), (-p["dieDepth"], 0)]
    keys = "dieLength", "dieWidth", "dieDepth"
    if not len(ground):
        refuse("dieSurface must have a cavity that is open upwards.", f"none in {p['dieSurface']}",
               "ground below z = 0 that faces up", "Correct the surface.")
    for axis in (0, 1, 2) if d["rig"] == "full" else (0, 2):
        low, high = ground[:, axis].min(), ground[:, axis].max()
        if low < wanted[axis][0] - ON_TABLE or high > wanted[axis][1] + ON_TABLE:
            refuse(f"dieSurface does not meet the table: its cavity lies outside the box of the die in {'xyz'[axis]}.",
                   f"{low:.6g} to {high:.6g} m in {p['dieSurface']}",
                   "{:.6g} to {:.6g} m".format(*wanted[axis]),
                   f"Correct {keys[axis]} in system/caseParameters, or move the surface.")


def write(case, p, d, given):
    """die.stl, shoe.stl for the powder; dieSolid.stl, shoeSolid.stl for the air."""
    folder = case/"constant/triSurface"
    made = {"die": (dieWalls, None), "shoe": (shoeWalls, shoeSolid)}
    for name, (walls, solid) in made.items():
        triangles = [tuple(map(tuple, t)) for t in given[name]]
        if not triangles:
            stl.write(folder/f"{name}.stl", walls(p, d))
            if solid:
                stl.write(folder/f"{name}Solid.stl", solid(p, d))
        else:
            stl.write(folder/f"{name}Solid.stl", triangles)
            if d["rig"] == "slice":
                triangles = stl.cut(triangles, d["demYLow"], d["demYHigh"])
            stl.write(folder/f"{name}.stl", stl.split(triangles, 5e-3))
