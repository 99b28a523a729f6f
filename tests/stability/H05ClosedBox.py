# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand parcels settle in a box of air that is closed on all sides. Pressure has no level of its
own there, and there is a solution only if all the void that opens in a step is closed elsewhere in it.

What does not cancel has nowhere to go: it becomes a jet through the cell whose pressure is held. So
the sum of V d(alpha)/dt must be zero to round-off, the pressure must converge, the air in the reference
cell must be as quick as around it, and which cell it is must not matter. The cell is once the corner on
the floor where the powder arrives, once in the middle of the box.
"""
import math
import random

from hardCase import (GRAVITY, Box, Case, Powder, change, continuityError, grainVolume, main,
                      mostIterations, spaced, volumeError)

CELL = 0.5e-3  # [m]
CELLS = (8, 8, 16)
COUNT = 1000
STEP = 1e-4  # [s]
EARLY, FALLING, SETTLED = 0.01, 0.05, 0.12  # [s]
POWDER = Powder()
MIDDLE = (4, 4, 8)
CONTACTS = """
fix young all property/global youngsModulus peratomtype 5e6
fix poisson all property/global poissonsRatio peratomtype 0.3
fix rebound all property/global coefficientRestitution peratomtypepair 1 0.5
fix coulomb all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
"""
WALL = "fix {0}{1} all wall/gran model hertz tangential history primitive type 1 {0}plane {2:.15g}\n"


def index(cell):
    return cell[0] + CELLS[0]*(cell[1] + CELLS[1]*cell[2])


def places(diameter):
    """Apart from each other, above the floor."""
    chance = random.Random(5)
    step = 1.02*diameter
    counts = [int(n*CELL/step) for n in CELLS]
    sites = [tuple((i + 0.5)*step for i in site) for site in
             ((i, j, k) for k in range(2, counts[2]) for j in range(counts[1])
              for i in range(counts[0]))]
    return chance.sample(sites, COUNT)


def settling(name, cell, endTime):
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("noSlip", "noSlip", "noSlip"))
    case = Case(name, box, POWDER, k=10, gravity=(0, 0, -GRAVITY), deltaT=STEP, subSteps=20,
                endTime=endTime, writeInterval=EARLY, smoothingWidth=2*CELL)
    case.positions = places(case.diameter)
    walls = "".join(WALL.format(axis, side, side*length)
                    for axis, length in zip("xyz", box.size) for side in (0, 1))
    change(case, "powder.in", "neigh_modify    delay 0 exclude group all all",
           "neigh_modify    delay 0\n" + CONTACTS + walls)
    return change(case, "system/fvSolution", "pRefCell            0;",
                  f"pRefPoint ({spaced((n + 0.5)*CELL for n in cell)});")


def imbalance(run, time):
    """Void that opens in the box in a step, of the volume of powder."""
    opened = math.fsum(run.field("ddtVoidFraction", time))*CELL**3*STEP
    return abs(opened)/grainVolume(run.case)


def jet(run, time, cell):
    """Speed in a cell, of the mean of its neighbours."""
    U = run.field("U", time)
    around = []
    for axis in range(3):
        for step in (-1, 1):
            other = list(cell)
            other[axis] += step
            if 0 <= other[axis] < CELLS[axis]:
                around.append(math.hypot(*U[index(other)]))
    return math.hypot(*U[index(cell)])*len(around)/sum(around)


def verify(bench):
    velocities = []
    for name, cell, endTime in (("reference on the floor", (0, 0, 0), SETTLED),
                                ("reference in the middle", MIDDLE, FALLING)):
        run = bench.run(settling(name, cell, endTime), impulse=math.inf)
        times = run.times()
        bench.atMost(run, "void gained in a step, of the powder", 1e-14,
                     max(imbalance(run, time) for time in times))
        bench.atMost(run, "iterations of the pressure", 99, mostIterations(run))
        bench.atMost(run, "continuity error, of the flux", 1e-8, continuityError(run))
        bench.atMost(run, "speed in the reference cell, of around", 3,
                     max(jet(run, time, cell) for time in times))
        bench.atMost(run, "powder on the mesh less of all", 1e-12, abs(volumeError(run)))
        velocities.append(run.field("U", times[0]))
    fastest = max(math.hypot(*u) for u in velocities[0])
    difference = max(math.dist(a, b) for a, b in zip(*velocities))
    bench.atMost(run, "air as with the other cell, of the fastest", 1e-6, difference/fastest)


if __name__ == "__main__":
    main(verify)
