# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that keep their velocities close up over a sealed floor: the air must come out as continuity
alone says (case M3; no drag law, no contact and no pressure enters).

Each grain moves by z = z0 + v0(z0) t, so the solid fraction is known at all times,

    alpha_p(z, t) = alpha_p0/(1 + v0'(z0) t)

and the air that leaves makes room for the grains that come, alpha u = -alpha_p v. The solver takes
d(alpha)/dt over a step, so its flux is that of the middle of the step: first order in the time step
when compared at its end, as implicit Euler is, and second order in the cell size.

    affine       v0 = -c z0: alpha_p stays uniform
    bent         v0 = -c z0 (1 - z0/(2 L))
"""
import math

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, Powder

LENGTH = 10e-3  # [m]
RATE = 10.0  # c [1/s]
SOLIDS = 0.3  # alpha_p0
END = 0.03  # [s]
PER_CELL = 64  # grains along z in a cell, on one line: so many that their rows are not seen
SEEN = 0.45  # of the length, from the floor: clear of the top, where the grains end
ORDER = {"step": (1.0, 0.1), "cell": (2.0, 0.15)}  # expected, tolerance

MOTIONS = {  # velocity and its slope at z0
    "affine": (lambda z: -RATE*z, lambda z: -RATE),
    "bent": (lambda z: -RATE*z*(1 - z/(2*LENGTH)), lambda z: -RATE*(1 - z/LENGTH))}


def column(motion, cells, steps):
    cell = LENGTH/cells
    box = Box((cell, cell, LENGTH), (1, 1, cells),
              ("periodic", "periodic", ("noSlip", "outlet")))
    diameter = cell*(6*SOLIDS/math.pi/PER_CELL)**(1/3)
    row = cell/PER_CELL
    speed, _ = MOTIONS[motion]
    return Case(f"{motion}, {cells} cells, {steps} steps", box, Powder(diameter, 2000.0, Air()),
                positions=[(cell/2, cell/2, (i + 0.5)*row) for i in range(cells*PER_CELL)],
                velocity=lambda x: (0, 0, speed(x[2])),
                motion="prescribed", deltaT=END/steps, endTime=END,
                timeStep="stabilityLimit 1e9; parcelCourant 1e9;")


def start(motion, z, t):
    """Where a grain at z came from."""
    speed, slope = MOTIONS[motion]
    z0 = z
    for _ in range(50):
        z0 -= (z0 + speed(z0)*t - z)/(1 + slope(z0)*t)
    return z0


def flux(motion, z, t):
    """alpha u of the air."""
    speed, slope = MOTIONS[motion]
    z0 = start(motion, z, t)
    return -SOLIDS/(1 + slope(z0)*t)*speed(z0)


def error(run, motion, t):
    """Of the flux alpha u in the cells, against the exact one at a time: root mean square, relative."""
    height = run.case.box.cell[2]
    computed = [a*u for a, u in zip(run.layers("voidFraction"), run.layers("U"))]
    count = round(SEEN*len(computed))
    exact = [flux(motion, (i + 0.5)*height, t) for i in range(count)]
    squares = sum((c - e)**2 for c, e in zip(computed, exact))
    return math.sqrt(squares/sum(e*e for e in exact))


def order(bench, which, motion, cases, late):
    """Observed order between two cases, the second twice as fine."""
    errors = []
    for case in cases:
        run = bench.run(case, impulse=math.inf)
        errors.append(error(run, motion, END - late*case.deltaT))
        bench.report(run, f"relative error, L2, refined in {which}", 1.0, 1 + errors[-1])
    expected, tolerance = ORDER[which]
    bench.equal(run, f"order in {which}", expected, math.log2(errors[0]/errors[1]), tolerance)


def verify(bench):
    order(bench, "step", "affine", [column("affine", 20, n) for n in (25, 50)], late=0)
    order(bench, "cell", "bent", [column("bent", n, 200) for n in (20, 40)], late=0.5)
    run = bench.run(column("affine", 20, 100), impulse=math.inf)
    bench.equal(run, "error at the middle of the step", 0, error(run, "affine", END - 0.5*run.case.deltaT),
                1e-3)


if __name__ == "__main__":
    main(verify)
