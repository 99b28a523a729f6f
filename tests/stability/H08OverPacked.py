# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that overlap twofold: two lattices in the same place fill their cells to 120 %. Hard contacts
prevent that; soft ones under impact, or a poor start of a bed, do not.

A void fraction of zero or less divides by zero or turns drag around. Clipped at a floor, powder
vanishes, and with it d(alpha)/dt is wrong. What is too much must go to the cells around: no void
fraction below the floor, and all powder on the mesh. The cluster stands in a wind; it falls, when every
step spreads another excess; and it lies in a corner, where there is room on three sides only.
"""
import math

from hardCase import (GRAVITY, Box, Case, Powder, lattice, main, measured, steps, table,
                      volumeError)

SOLIDS = 0.6  # of one lattice
FLOOR = 0.36
POWDER = Powder(40e-6, 7360.0)
SPEED = 0.05  # [m/s]
COUNT = 40
SPACING = (math.pi/6/SOLIDS)**(1/3)*POWDER.diameter
EDGE = 2*SPACING
CELLS = (10, 10, 16)


def cluster(name, low, sides, **options):
    """Four cells wide, its lowest corner at cell `low`, off the mesh by a quarter of a cell."""
    box = Box(tuple(n*EDGE for n in CELLS), CELLS, sides)
    one = lattice(Box((4*EDGE,)*3, (4, 4, 4)), 2)
    positions = [tuple(x + (first + shift)*EDGE for x, first in zip(place, low))
                 for shift in (0.2, 0.3) for place in one]
    case = Case(name, box, POWDER, positions=positions, minimum=FLOOR, deltaT=1e-4,
                subSteps=20, endTime=COUNT*1e-4, writeInterval=1e-3, **options)
    return measured(case, "    powderBalance { type powderBalance; }")


def judge(bench, case):
    run = bench.run(case, impulse=math.inf)
    rows = table(run, "powderBalance")
    bench.equal(run, "steps that went well", COUNT, len(steps(run)), 0)
    bench.atLeast(run, "powder handed on, of all, at least", 0.2,
                  min(row[16] for row in rows)/(len(case.positions)*math.pi/6*case.diameter**3))
    bench.atMost(run, "powder cut off [m3]", 0, max(row[15] for row in rows))
    bench.atLeast(run, "lowest void fraction", FLOOR - 1e-15,
                  min(alpha for t in run.times() for alpha in run.field("voidFraction", t)))
    bench.atMost(run, "powder on the mesh less of all", 1e-12,
                 max(abs(volumeError(run, t)) for t in run.times()))
    return run


def verify(bench):
    wind = ("periodic", "periodic", ("inlet", "outlet"))
    run = judge(bench, cluster("in a wind", (3, 3, 6), wind, motion="frozen", U=(0, 0, SPEED)))
    bench.atMost(run, "fastest air, of the wind", 3, steps(run)[-1].speed/SPEED)

    run = judge(bench, cluster("falling", (3, 3, 9), ("noSlip",)*3, gravity=(0, 0, -GRAVITY)))
    mass = len(run.case.positions)*math.pi/6*run.case.diameter**3*POWDER.density
    fallen = -run.budget()[-1][2][2]/mass
    bench.atMost(run, "speed of the powder, of free fall", 1, fallen/(GRAVITY*COUNT*1e-4))
    bench.atMost(run, "fastest air, of the powder", 3,
                 max(step.speed for step in steps(run))/fallen)

    judge(bench, cluster("in a corner", (0, 0, 0), ("noSlip",)*3, motion="frozen"))


if __name__ == "__main__":
    main(verify)
