# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains of 3 mm move at 0.3 m/s through a periodic box of cells of 10 mm. How fast does the void
fraction of 8 cells fall that they move into (case M2, the void fraction test of CFDEMcoupling)?

Grains follow each other in rows, at a distance of their diameter. While a row's first grain is inside a
block of 2 x 2 x 2 cells and its last one still before it, one grain enters in every time d/v, so that

    mean of d(alpha)/dt = -V_p (v/d)/(8 V_c) = -0.1767 1/s        over any time d/v,

however the deposit distributes a grain, as long as it gives away all of it, and to cells whose faces
are no more than half a cell away. Behind the last grain it is the same with the other sign, and in a
block that is passed in the middle of a row it is zero.

Between these moments a grain's share in the block rises over the width of one cell, linearly, so that 3
or 4 grains are entering at a time: in no step may the rate be above 4 d/(10 mm) = 1.2 of the mean or
below 0.9 of it. A deposit by the grain's centre has the same mean, and 10 times it in one step of ten.
"""
import math
import random

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Powder

CELLS = 10
CELL = 0.01  # [m]
BLOCK = 2*CELL
DIAMETER, SPEED = 3e-3, 0.3  # [m], [m/s]
STEP = 1e-3  # [s]
STEPS = round(DIAMETER/SPEED/STEP)  # in which a grain moves by its diameter
ROW = 20  # grains
FRONTS = (0.5*BLOCK, 1.5*BLOCK)  # of the two rows in a column of blocks, at the start
GRAIN = math.pi/6*DIAMETER**3
PASSING = GRAIN*SPEED/DIAMETER/BLOCK**3  # 0.1767 1/s
EXPECTED = {0: -1, 1: -1, 2: 1, 3: 1, 4: 0}  # in the blocks of a column, in order of x
ENTERED_ONCE = 1  # the other row is not there yet; block 0 is also passed by it


def rows(y, z):
    """Two in a column of blocks, so far inside that no share is outside, and clear of each other."""
    chance = random.Random(1000*y + z)
    for front, low in zip(FRONTS, (0.25, 0.60)):
        place = [BLOCK*(n + low + 0.15*chance.random()) for n in (y, z)]
        for i in range(ROW):
            yield ((front - i*DIAMETER) % (CELLS*CELL), *place)


def stream(name, **options):
    box = Box(3*(CELLS*CELL,), 3*(CELLS,))
    positions = [x for y in range(CELLS//2) for z in range(CELLS//2) for x in rows(y, z)]
    return Case(name, box, Powder(DIAMETER, 2500.0), positions=positions, motion="prescribed",
                velocity=(SPEED, 0, 0), deltaT=STEP, endTime=STEPS*STEP, writeInterval=STEP,
                timeStep="parcelCourant 1e9;", **options)


def blocks(field):
    """Mean of each block: {number along x: values}."""
    sums = {}
    for i, rate in enumerate(field):
        x, y, z = i % CELLS, i//CELLS % CELLS, i//CELLS**2
        block = (x//2, y//2, z//2)
        sums[block] = sums.get(block, 0.0) + rate/8
    return {x: [rate for block, rate in sorted(sums.items()) if block[0] == x]
            for x in range(CELLS//2)}


def rates(run):
    """Of blocks, one a step."""
    return [blocks(run.field("ddtVoidFraction", time)) for time in run.times()]


def mean(found, x):
    """Over the steps, of each block with this number along x, of the expected rate."""
    return [sum(step[x][i] for step in found)/len(found)/PASSING
            for i in range(len(found[0][x]))]


def extremes(found):
    """Largest and smallest rate of a step in the blocks that one row alone has reached, of the mean."""
    entered = [-rate/PASSING for step in found for rate in step[ENTERED_ONCE]]
    return max(entered), min(entered)


def judgeVolume(bench, run):
    all_, worst, opened = GRAIN*len(run.case.positions), 0.0, 0.0
    for time in run.times():
        onMesh = math.fsum(1 - alpha for alpha in run.field("voidFraction", time))*CELL**3
        worst = max(worst, abs(onMesh/all_ - 1))
        opened = max(opened, abs(math.fsum(run.field("ddtVoidFraction", time)))*CELL**3*STEP/all_)
    bench.atMost(run, "powder on the mesh less of all, any step", 1e-12, worst)
    bench.atMost(run, "void gained in a step, of the powder", 1e-13, opened)


def verify(bench):
    run = bench.run(stream("rows of grains"), impulse=math.inf)
    bench.equal(run, "grains", 1000, len(run.case.positions), 0)
    bench.equal(run, "steps", STEPS, len(run.times()), 0)
    judgeVolume(bench, run)
    found = rates(run)
    entered = [value for x, sign in EXPECTED.items() if sign < 0 for value in mean(found, x)]
    bench.near(run, "mean rate of blocks that are entered [1/s]", -PASSING,
               PASSING*sum(entered)/len(entered), 1e-9)
    for x, sign in sorted(EXPECTED.items()):
        off = max(abs(value - sign) for value in mean(found, x))
        bench.equal(run, f"block {x} of any column, off {sign} of that", 0, off, 1e-9)
    most, least = extremes(found)
    bench.equal(run, "largest rate of a step, of the mean", 4*DIAMETER/CELL, most, 1e-9)
    bench.equal(run, "smallest rate of a step, of the mean", 3*DIAMETER/CELL, least, 1e-9)

    # With the whole grain in the cell of its centre it is the same in the mean, and jumps.
    run = bench.run(stream("rows, by the centre", deposit="centre"), impulse=math.inf)
    judgeVolume(bench, run)
    bench.equal(run, "largest rate of a step, of the mean", STEPS, extremes(rates(run))[0], 1e-9)


if __name__ == "__main__":
    main(verify)
