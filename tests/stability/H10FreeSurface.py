# SPDX-License-Identifier: GPL-3.0-or-later
"""Air flows through a frozen bed whose void fraction falls from 1 to 0.4, and rises again, over one
face: the free surface of a bed at its sharpest. Drag is nothing on one side and everything on the other.

Interpolating drag, mobility and pressure gradient to that face one by one gives the cells at the surface
a pressure gradient that is not theirs: half a cell of drag is lost at each surface, or the velocity there
is thrown far above that in the bed. Ours must be exact in the bed up to its last layer, and nowhere more
than 2 % above it. The pressure must fall from layer to layer of the bed, and rise nowhere by more than
what the air loses and gains at its surfaces, rho times the squared velocity in the bed. The solvers with
such naive choices must be seen to miss it.
"""
import math

from hardCase import main

from A02bLatticeBed import BED, EXACT, SPEED, bed

VOID = 0.40
TOLERANCE = 0.02


def surface(name, steps, count):
    case = bed(name, VOID, 2, steps, deposit="centre")
    case.endTime = count*case.deltaT
    return case


def overshoot(run):
    """Of the velocity, above that in the bed."""
    return max(run.layers("U"))*VOID/SPEED - 1


def drop(run):
    """Of the pressure, of that of the drag law."""
    p = run.pressureLayers()
    height = run.case.box.cell[2]*(BED[1] - BED[0])
    return (p[0] - p[-1])/(run.case.powder.slope(VOID, SPEED)*height)


def rises(p):
    return [b - a for a, b in zip(p, p[1:])]


def verify(bench):
    for steps, count in ((0.02, 1000), (0.98, 100)):
        case = surface(f"surface, dt {steps:g} tau", steps, count)
        run = bench.run(case, impulse=math.inf)
        void = run.layers("voidFraction")
        bench.near(run, "void fraction in the bed's first layer", VOID, void[BED[0]], 1e-9)
        bench.equal(run, "void fraction before the bed", 1, void[BED[0] - 1], 1e-12)

        bench.atMost(run, "overshoot of the velocity", TOLERANCE, overshoot(run))
        inBed = run.layers("U")[slice(*BED)]
        bench.atMost(run, "velocity in the bed, off U/alpha", TOLERANCE,
                     max(abs(u*VOID/SPEED - 1) for u in inBed))

        p = run.pressureLayers()
        bench.atMost(run, "rise of pressure in the bed [Pa]", 0, max(rises(p[BED[0] - 1:BED[1] + 1])))
        bench.atMost(run, "rise of pressure anywhere, of rho u^2", 1,
                     max(rises(p))/(case.powder.air.density*(SPEED/VOID)**2))
        bench.near(run, "pressure drop, of the drag law's", 1, drop(run), EXACT)

    for choice, quantity, measure in (
            ("facesOneByOne", "must miss: pressure drop", lambda run: abs(drop(run) - 1)),
            ("plainPressureGradient", "must fail: overshoot of the velocity", overshoot)):
        naive = bench.runNaively(surface(choice, 0.02, 100), choice)
        bench.atLeast(naive, quantity, 2*TOLERANCE, measure(naive))


if __name__ == "__main__":
    main(verify)
