# SPDX-License-Identifier: GPL-3.0-or-later
"""Air flows through a frozen bed whose void fraction falls from 1 to 0.4, and rises again, over one
face: the free surface of a bed at its sharpest. Drag is nothing on one side and everything on the other.

Interpolating drag, mobility and pressure gradient to that face one by one gives the cells at the surface
a pressure gradient that is not theirs: half a cell of drag is lost at each surface, or the velocity there
is thrown far above that in the bed. Ours must be exact in the bed up to its last layer, and nowhere more
than 2 % above it. Before and behind the bed the velocity of the cells must be that of the flux, though
convection throws the air from 1 to 2.5 of it within a cell. (With the kernel it is. Where deposit by
centres has the void fraction jump over one face it strays from cell to cell by 12 %, which is shown: the
cells' velocity is drawn to the flux only as hard as moving walls bear, H15.) The pressure must fall from
layer to layer of the bed, and rise nowhere by more than what the air loses and gains at its surfaces,
rho times the squared velocity in the bed. The solvers with such naive choices must be seen to miss it.
"""
import math

from hardCase import main

from A02bLatticeBed import BED, EXACT, SPEED, bed

VOID = 0.40
TOLERANCE = 0.02


def surface(name, steps, count, deposit="centre"):
    case = bed(name, VOID, 2, steps, deposit=deposit)
    case.endTime = count*case.deltaT
    return case


def overshoot(run):
    """Of the velocity, above that in the bed."""
    return max(run.layers("U"))*VOID/SPEED - 1


def strayed(run):
    """Velocity of the air times void fraction, off the flux that is the same everywhere."""
    return max(abs(a*u/SPEED - 1) for a, u in zip(run.layers("voidFraction"), run.layers("U")))


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

        bench.report(run, "1 + alpha u anywhere, off the flux", 1, 1 + strayed(run))

        p = run.pressureLayers()
        bench.atMost(run, "rise of pressure in the bed [Pa]", 0, max(rises(p[BED[0] - 1:BED[1] + 1])))
        bench.atMost(run, "rise of pressure anywhere, of rho u^2", 1,
                     max(rises(p))/(case.powder.air.density*(SPEED/VOID)**2))
        bench.near(run, "pressure drop, of the drag law's", 1, drop(run), EXACT)

    run = bench.run(surface("surface, kernel", 0.98, 100, "kernel"), impulse=math.inf)
    bench.atMost(run, "alpha u anywhere, off the flux", TOLERANCE, strayed(run))

    for choice, quantity, measure in (
            ("facesOneByOne", "must miss: pressure drop", lambda run: abs(drop(run) - 1)),
            ("plainPressureGradient", "must fail: overshoot of the velocity", overshoot)):
        naive = bench.runNaively(surface(choice, 0.02, 100), choice)
        bench.atLeast(naive, quantity, 2*TOLERANCE, measure(naive))


if __name__ == "__main__":
    main(verify)
