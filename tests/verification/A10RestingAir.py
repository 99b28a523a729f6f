# SPDX-License-Identifier: GPL-3.0-or-later
"""Heavy air at rest among grains that do not move (case M4): gravity on the air is held by the
pressure gradient, grad(p) = rho g, in every cell, whatever the void fraction; nothing flows.

A scheme that takes gravity and pressure gradient to the faces in different ways drives a current
wherever the void fraction jumps. Grains lie at random, so it jumps everywhere, from 0.4 to 1.
"""
import math
import random

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, Powder

GRAVITY = 9.81  # [m/s2]
HEAVY = Air(1.225e3, 1.7894e-2)  # a thousandfold: a current would be seen the better
IMMOVABLE = 1e12  # density of the grains [kg/m3]: held still not by contacts but by their mass
FASTEST = 1e-9  # [m/s]
CELL = 1e-3  # [m]
CELLS = (6, 6, 12)


def grainsAtRandom(box, count):
    """Thick below, none above; away from the walls so that no two sides differ."""
    chance = random.Random(7)
    return [(chance.uniform(0, box.size[0]), chance.uniform(0, box.size[1]),
             box.size[2]*0.7*chance.random()**2) for _ in range(count)]


def verify(bench):
    box = Box(tuple(CELL*n for n in CELLS), CELLS, ("noSlip", "noSlip", "noSlip"))
    powder = Powder(0.3e-3, IMMOVABLE, HEAVY)
    case = Case("closed box", box, powder, positions=grainsAtRandom(box, 6000), motion="frozen",
                airGravity=(0, 0, -GRAVITY), minimum=0.3, deltaT=1e-3, endTime=0.05)
    run = bench.run(case, impulse=math.inf)
    bench.atMost(run, "fastest air [m/s]", FASTEST,
                 max(math.hypot(*u) for u in run.field("U")))
    pressures = run.pressureLayers()
    slope = (pressures[-1] - pressures[0])/(CELL*(CELLS[2] - 1))
    bench.near(run, "pressure gradient over rho g", -1.0, slope/(HEAVY.density*GRAVITY), 1e-8)
    voids = run.field("voidFraction")
    bench.atMost(run, "lowest void fraction", 0.6, min(voids))
    bench.atLeast(run, "highest void fraction", 1.0, max(voids))


if __name__ == "__main__":
    main(verify)
