# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains are thrown up through the top of the mesh, fly above it and fall back, each at its time. Powder
splashes like that, and a hopper may stand above the air that is computed.

A particle without a cell must not be lost, feel the air of the last cell it was in, or be looked up with
no cell at all. It is counted; the air leaves it alone, so that it flies as in vacuum to round-off; and
back in the mesh it has its drag again. Where it should be is known from the record of the grains: a
particle is outside if it is both at the step's start and where it is predicted for its end.

In a box that is closed to air the momentum across is known: what all weigh in that direction, times the
time. Grains that fly outside or come back may not change it.
"""
import math

from hardCase import (GRAVITY, Box, Case, Powder, change, main, measured, steps, table)

CELL = 1e-3  # [m]
CELLS = (4, 4, 4)
TOP = CELLS[2]*CELL
CEILING = 2*TOP  # of the powder's box
SLOPE = 3.0  # of gravity, along x [m/s2]
SPEED = 0.25  # upwards, at the start [m/s]
STEP, COUNT = 2e-4, 240
MARGIN = 0.05*CELL  # predicted so close to the mesh a particle is in it
POWDER = Powder()
STARTS = [TOP - (0.3 + 0.6*i)*CELL for i in range(5)]


def throw(name, top):
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("periodic", "periodic", ("slip", top)))
    positions = [((0.3 + 0.8*i)*CELL, (3.6 - 0.7*i)*CELL, z) for i, z in enumerate(STARTS)]
    case = Case(name, box, POWDER, positions=positions, velocity=(0, 0, SPEED),
                gravity=(SLOPE, 0, -GRAVITY), deltaT=STEP, subSteps=4, endTime=COUNT*STEP,
                recordEvery=4)
    change(case, "powder.data", f"0 {TOP:.15g} zlo zhi", f"0 {CEILING:.15g} zlo zhi")
    return measured(case, "    powderBalance { type powderBalance; }")


def isOutside(grain):
    (_, _, z), (_, _, speed) = grain
    return z > TOP and z + speed*STEP > TOP + MARGIN


def isInside(grain):
    (_, _, z), (_, _, speed) = grain
    return max(z, z + speed*STEP) < TOP


def forces(run):
    """Of each grain and step, above its weight over its mass: (grain at the start, acceleration)."""
    frames = [grains for _, grains in sorted(run.record().items())]
    for old, new in zip(frames, frames[1:]):
        for grain, (_, velocity) in new.items():
            gained = [(b - a)/STEP for a, b in zip(old[grain][1], velocity)]
            yield old[grain], (gained[0] - SLOPE, gained[1], gained[2] + GRAVITY)


def judgeCounts(bench, run):
    frames = [grains for _, grains in sorted(run.record().items())]
    outside = [sum(map(isOutside, grains.values())) for grains in frames[:-1]]
    rows = table(run, "powderBalance")
    bench.equal(run, "steps on record", COUNT, len(rows), 0)
    bench.atLeast(run, "most grains outside at once, at least", 3, max(outside))
    bench.equal(run, "outside, of them when all are back", 0, outside[-1], 0)
    wrong = sum(row[7] != count for row, count in zip(rows, outside))
    bench.equal(run, "steps with another number outside", 0, wrong, 0)
    bench.equal(run, "steps whose line says another number", 0,
                sum(step.outside != row[7] for step, row in zip(steps(run), rows)), 0)
    bench.equal(run, "steps with another number of grains", 0,
                sum(row[6] != len(STARTS) for row in rows), 0)


def judgeForces(bench, run):
    free = max(math.hypot(*a) for grain, a in forces(run) if isOutside(grain))
    bench.atMost(run, "force outside, of the weight", 1e-9, free/GRAVITY)
    back = [(grain, a) for grain, a in forces(run) if isInside(grain) and grain[1][2] < -0.15]
    bench.atLeast(run, "steps of grains that are back", 10, len(back))
    drag = [a[2]/(POWDER.B(1.0, v[2])*-v[2]/POWDER.density) for (_, v), a in back]
    bench.near(run, "drag of those, of that in air at rest", 1, sum(drag)/len(drag), 0.15)


def judgeMomentum(bench, run):
    mass = len(STARTS)*math.pi/6*POWDER.diameter**3*POWDER.density
    gained = [air[0] + powder[0] - remainder[0] - mass*SLOPE*t
              for t, air, powder, remainder in run.budget()]
    drift = max(abs(b - a) for a, b in zip([0.0] + gained, gained))
    bench.equal(run, "momentum gained in a step, of its weight", 0, drift/(mass*SLOPE*STEP), 1e-6)


def verify(bench):
    for name, top in (("open above", "outlet"), ("closed above", "slip")):
        run = bench.run(throw(name, top), impulse=math.inf)
        judgeCounts(bench, run)
        judgeForces(bench, run)
        if top == "slip":
            judgeMomentum(bench, run)


if __name__ == "__main__":
    main(verify)
