# SPDX-License-Identifier: GPL-3.0-or-later
"""A shoe with powder passes over a die at 0.2 m/s. Its walls are solids in a mesh that stands still: a
wall is where its resistance is, and takes in one layer of cells after the other while it lets go of
another. Powder falls into the die and drives the air out; what the air will not do at these pressures
is go through a wall instead.

What passes a wall, relative to it, must be less than a thousandth of the air that leaves the die. (Air
must come into a cell that is being covered while powder is pushed out of it. If that goes on when its
wall is closed already, it comes through the wall.) No cell, those that a wall takes in among them, may
have a void fraction below the floor, and no powder may be lost. With a shoe that the air does not see,
and with walls that hold the air for a millisecond only, the leak must be seen.
"""
import collections
import math
import pathlib
import re
import types

from H15MovingShoe import CELL, RAMP, Run, main
from hardCase import listed, numbers

SPEED = 0.2  # [m/s]
STEP, END = 1e-4, 0.06  # [s]
WALLS = ((-6.42e-3, -5.1e-3), (-1.5e-3, -0.18e-3))  # of the shoe, from where to where at the start
DIE, DEPTH = (0.0, 4.8e-3), 3e-3
BLOCKS = ((-9.6e-3, 0.0, 16, 10), (0.0, 0.0, 8, 10), (4.8e-3, 0.0, 12, 10), (0.0, -3e-3, 8, 5))
DIAMETER, GRAINS = 0.32e-3, 8  # of a parcel; of a parcel over a grain
FLOOR = 0.3
LEAK = 1e-3

PARCELS = [(-4.9e-3 + 0.33e-3*i, -0.4e-3 + 0.4e-3*j, 0.2e-3 + 0.33e-3*k)
           for k in range(15) for j in range(3) for i in range(10)]


def centres():
    """Of the cells, in the mesh's order."""
    return [tuple(low + (n + 0.5)*CELL for low, n in zip((x, -CELL, z), (i, j, k)))
            for x, z, columns, layers in BLOCKS
            for k in range(layers) for j in range(2) for i in range(columns)]


CENTRES = centres()


def surface(name, rectangles):
    """STL of upright and level rectangles across the slice: (x, z) of two of their edges."""
    facets = []
    for (x0, z0), (x1, z1) in rectangles:
        corners = [(x0, -CELL, z0), (x1, -CELL, z1), (x1, CELL, z1), (x0, CELL, z0)]
        for three in ((0, 1, 2), (0, 2, 3)):
            vertices = "".join("  vertex {:.9g} {:.9g} {:.9g}\n".format(*corners[n]) for n in three)
            facets.append(f"facet normal 0 0 1\n outer loop\n{vertices} endloop\nendfacet\n")
    return f"solid {name}\n{''.join(facets)}endsolid {name}\n"


def table():
    """The table and the die in it."""
    left, right = (-11.9e-3, 0.0), (13.9e-3, 0.0)
    edges = [(DIE[0], 0.0), (DIE[0], -DEPTH), (DIE[1], -DEPTH), (DIE[1], 0.0)]
    path = [left] + edges + [right]
    return surface("die", [piece for ends in zip(path, path[1:]) for piece in pieces(*ends)])


def pieces(start, end):
    """LIGGGHTS' search for neighbours fails for triangles much longer than wide."""
    count = math.ceil(math.dist(start, end)/(3*CELL))
    points = [tuple(a + n/count*(b - a) for a, b in zip(start, end)) for n in range(count + 1)]
    return zip(points, points[1:])


def fill(folder, seen="on"):
    """Table, die and powder for the case of H15."""
    (folder/"die.stl").write_text(table())
    replace(folder/"shoe.in",
            ("neighbor ", "".join(f"create_atoms 1 single {x:g} {y:g} {z:g} units box\n"
                                  for x, y, z in PARCELS)
             + f"set group all diameter {DIAMETER} density 7360\nneighbor "),
            ("fix             walls all", "fix die all mesh/surface file ${case}/die.stl type 1\n"
             "fix weight all gravity 9.81 vector 0 0 -1\nfix             walls all"),
            ("n_meshes 1 meshes shoe", "n_meshes 2 meshes shoe die"),
            ("speed equal 0.075", f"speed equal {SPEED/2}"))
    replace(folder/"constant/couplingProperties",
            ('script "shoe.in";', f'script "shoe.in"; coarseGraining {GRAINS};'),
            ('surface "shoeSolid.stl";', f'surface "shoeSolid.stl"; seenByAir {seen};'),
            ("timeStep ",
             f"voidFraction {{ smoothingWidth {2*DIAMETER}; minimum {FLOOR}; }}\ntimeStep "))
    replace(folder/"system/controlDict",
            ("endTime             0.07", f"endTime             {END}"),
            ("writeInterval       0.01", "writeInterval       0.002"),
            ("functions\n{", "functions\n{\n    powderBalance { type powderBalance; }"))


def replace(path, *changes):
    text = path.read_text()
    for old, new in changes:
        assert old in text, f"no '{old}' in {path}"
        text = text.replace(old, new, 1)
    path.write_text(text)


class State:
    """What a run has on disk of an instant."""

    def __init__(self, run, name):
        self.travel = SPEED*(float(name) - RAMP/2)
        mesh = run.folder/"constant/polyMesh"
        text = (run.folder/name/"alphaPhi").read_text().split("boundaryField")[0]
        fluxes = numbers(re.search(r"\(([^()]*)\)\s*;", text).group(1))
        self.faces = list(zip(listed(mesh/"owner"), listed(mesh/"neighbour"), fluxes))
        self.field = lambda field: run.field(name, field)

    def acrossPlanes(self, axis):
        """Fluxes along an axis by the cell centres' places on both sides of a face."""
        for one, other, flux in self.faces:
            a, b = CENTRES[one], CENTRES[other]
            if a[axis] - b[axis] > 0.5*CELL:
                yield b, a, -flux
            elif b[axis] - a[axis] > 0.5*CELL:
                yield a, b, flux

    def mouth(self):
        """Air that leaves the die through its mouth [m3/s]; other air comes in."""
        return sum(max(flux, 0) for a, b, flux in self.acrossPlanes(2) if a[2] < 0 < b[2])

    def through(self, low, high):
        """Net flux that goes all through a wall, relative to it: the least through either side of
        any column of cells that it covers quite [m3/s]."""
        first, last = (x + self.travel for x in (low + 0.5*CELL, high - 0.5*CELL))
        sides = collections.defaultdict(float)
        for a, b, flux in self.acrossPlanes(0):
            if a[2] > 0 and (first < a[0] < last or first < b[0] < last):
                sides[round(a[0], 6)] += flux - SPEED*CELL**2
        return min(sides.values(), key=abs)


def states(run):
    names = [p.name for p in run.folder.iterdir() if re.fullmatch(r"0\.\d+", p.name)]
    return [State(run, name) for name in sorted(names, key=float) if float(name) > 1.05*RAMP]


def mean(numbers):
    numbers = list(numbers)
    return math.fsum(numbers)/len(numbers)


def leak(found):
    """Of both walls, of the air that leaves the die: means over the states."""
    through = mean(max(abs(state.through(*wall)) for wall in WALLS) for state in found)
    return through/mean(state.mouth() for state in found)


def cross(bench, name, seen="on", solver=None):
    """A run of the shoe over the die, and its states."""
    place = types.SimpleNamespace(solver=solver or bench.solver, ranks=bench.ranks,
                                  work=bench.work/name.replace(" ", ""))
    run = Run(place, STEP, lambda folder: fill(folder, seen))
    run.name = name
    return run, states(run)


def verify(bench):
    run, found = cross(bench, "shoe over die")
    covered = {round(x, 6) for state in found for (x, _, z), share in
               zip(CENTRES, state.field("solid")) if z > 0 and share > 0.999}
    bench.atLeast(run, "columns of cells that were quite covered", 20, len(covered))
    bench.atMost(run, "air through walls, of that out of the die", LEAK, leak(found))
    void = [(alpha, share) for state in found for alpha, share in
            zip(state.field("voidFraction"), state.field("solid"))]
    bench.atLeast(run, "least void fraction", FLOOR, min(alpha for alpha, _ in void))
    bench.atLeast(run, "least in cells that are half covered", FLOOR,
                  min(alpha for alpha, share in void if share > 0.5))
    rows = run.table("powderBalance")
    bench.equal(run, "parcels lost", 0, rows[-1][8], 0)
    bench.atMost(run, "mass missing, of all", 1e-12, max(abs(row[5]) for row in rows)/rows[0][4])
    inDie = sum(1 - alpha for (_, _, z), alpha in zip(CENTRES, found[-1].field("voidFraction"))
                if z < 0)
    bench.atLeast(run, "powder in the die at the end, of all", 0.1,
                  inDie*CELL**3/(len(PARCELS)*math.pi/6*DIAMETER**3))

    run, found = cross(bench, "shoe not seen", seen="off")
    bench.atLeast(run, "must leak: through walls, of out of the die", 10*LEAK, leak(found))
    run, found = cross(bench, "weak walls", solver=pathlib.Path(bench.naiveFolder)/"weakWalls")
    bench.atLeast(run, "must leak: through walls, of out of the die", 10*LEAK, leak(found))


if __name__ == "__main__":
    main(verify)
