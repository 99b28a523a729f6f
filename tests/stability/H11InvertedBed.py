# SPDX-License-Identifier: GPL-3.0-or-later
"""Heavy powder lies above air in a box that is closed on all sides, and falls. As a plug it would have
to let all the air through its pores and come down at U_mf; but an interface with the heavy above the
light is unstable (Rayleigh and Taylor): fingers of powder fall through, air rises between them as
bubbles, and it is down in less than half the time.

Parcels that cross faces one by one, air that has no outlet, and cells that turn from bed to bubble
within a few steps must not make jets: the air stays below 10 m/s, and the chosen step keeps the Courant
number below one. (With powder put in the cells of its centres, and not smoothed, the air is seen to be
quicker.) At rest contacts carry the bed, so the pressure drop across it is nothing of its weight per
area. All mass is there, and the bed is as dense as spheres are that fell: at least 0.5, at most 0.64.
"""
import math
import random
import re

from hardCase import (GRAVITY, Box, Case, Powder, change, grainVolume, main, measured,
                      mostIterations, run as runCase, steps, table, volumeError)

from H05ClosedBox import CONTACTS, WALL

CELL = 0.75e-3  # [m]
CELLS = (8, 8, 20)
SIZE = tuple(n*CELL for n in CELLS)
COUNT = 900
POWDER = Powder(60e-6)
K = 10
END = 0.3  # [s]
NOISY = 0.06  # of the run with noise [s]
AREA = SIZE[0]*SIZE[1]
RECORD = 500  # DEM steps


def places(diameter):
    """On a body-centred lattice under the ceiling, a little disordered."""
    chance = random.Random(3)
    rows = int((SIZE[0] - diameter)/(1.16*diameter) + 0.5)
    step = (SIZE[0] - diameter)/(rows - 0.5)
    sites = [(0.5*diameter + (i + half)*step, 0.5*diameter + (j + half)*step,
              SIZE[2] - 0.51*diameter - (k + half)*step)
             for k in range(2*COUNT//rows**2) for half in (0, 0.5)
             for j in range(rows) for i in range(rows)]
    return [(x, y, z - chance.uniform(0, 0.01*diameter)) for x, y, z in sites[:COUNT]]


def inverted(name, **options):
    box = Box(SIZE, CELLS, ("noSlip", "noSlip", "noSlip"))
    settings = dict(k=K, gravity=(0, 0, -GRAVITY), deltaT=1e-5, adjustTimeStep=True, endTime=END,
                    smoothingWidth=2*K*POWDER.diameter, recordEvery=RECORD,
                    positions=places(K*POWDER.diameter))
    settings.update(options)
    case = Case(name, box, POWDER, **settings)
    walls = "".join(WALL.format(axis, side, side*length)
                    for axis, length in zip("xyz", SIZE) for side in (0, 1))
    change(case, "powder.in", "neigh_modify    delay 0 exclude group all all",
           "neigh_modify    delay 0\n" + CONTACTS + walls)
    return measured(case, "    powderBalance { type powderBalance; }")


def heights(run):
    """Mean height of the parcels by time, from the floor."""
    return [(t, math.fsum(x[2] for x, _ in grains.values())/len(grains))
            for t, grains in sorted(run.record().items())]


def plugTime(run, fall):
    """That a plug would take to fall so far."""
    highest = max(z for _, _, z in run.case.positions)
    lowest = min(z for _, _, z in run.case.positions)
    height = highest - lowest + run.case.diameter
    void = 1 - grainVolume(run.case)/(AREA*height)
    return fall/POWDER.minimumFluidisation(void)


def judgeFall(bench, run):
    rows = heights(run)
    start, end = rows[0][1], rows[-1][1]
    half = next(t for t, z in rows if z < 0.5*(start + end))
    bench.atMost(run, "half the fall, of the time of a plug", 0.5,
                 half/plugTime(run, 0.5*(start - end)))
    bench.atMost(run, "fastest air [m/s]", 10, max(step.speed for step in steps(run)))
    courants = [float(x) for x in re.findall(r"m/s, Co (\S+), p iterations", run.log)]
    bench.atMost(run, "Courant number", 1, max(courants))
    bench.atMost(run, "iterations of the pressure", 99, mostIterations(run))


def judgeRest(bench, run):
    fastest = max(math.hypot(*v) for _, v in max(run.record().items())[1].values())
    bench.atMost(run, "fastest parcel at the end [m/s]", 1e-2, fastest)
    weight = grainVolume(run.case)*POWDER.density*GRAVITY/AREA
    pressure = run.pressureLayers()
    bench.atMost(run, "drop across the bed at rest, of its weight", 1e-2,
                 (max(pressure) - min(pressure))/weight)
    packing = grainVolume(run.case)/(AREA*2*heights(run)[-1][1])
    bench.atLeast(run, "solid fraction, loose spheres at least", 0.50, packing)
    bench.atMost(run, "solid fraction, dense spheres at most", 0.64, packing)


def judgeMass(bench, run):
    rows = table(run, "powderBalance")
    bench.atMost(run, "mass missing, of all", 1e-12, max(abs(row[5]) for row in rows)/rows[0][4])
    bench.equal(run, "parcels at the end", COUNT, rows[-1][6], 0)
    bench.atMost(run, "powder on the mesh less of all", 1e-12, abs(volumeError(run)))


def verify(bench):
    run = bench.run(inverted("inverted bed"), impulse=math.inf)
    judgeFall(bench, run)
    judgeRest(bench, run)
    judgeMass(bench, run)

    case = inverted("by centres", deposit="centre", smoothingWidth=0.0, endTime=NOISY)
    noisy = runCase(case, bench.folder(case), bench.ranks, bench.solver)
    bench.atLeast(noisy, "must be too quick: fastest air [m/s]", 10,
                  max(step.speed for step in steps(noisy)))


if __name__ == "__main__":
    main(verify)
