# SPDX-License-Identifier: GPL-3.0-or-later
"""A plug of grains tied into one body falls onto sealed air, which must leave through the plug.

Without the inertia of the air (closed form), with alpha the void fraction of the plug:

    alpha_p rho_p dv/dt = alpha_p rho_p g - beta v/alpha^2
    v_end = U_mf        response = U_mf/g        pressure below = weight over area

The mesh sees the two ends of the plug smeared; where that matters (coarse parcels), U_mf is that
of the void fraction on the mesh, beta v/alpha^2 summed over its layers.
"""
import math

from harness.bench import main
from harness.case import Box, Case, lattice
from harness.laws import GRAVITY, Powder, root

VOID = 0.40
HEIGHT = 0.01  # of the plug [m]
RESPONSES = 8  # length of a run in response times
powder = Powder()
END_SPEED = powder.minimumFluidisation(VOID, buoyant=False)  # 4.59 mm/s
RESPONSE = END_SPEED/GRAVITY  # 0.468 ms

SHARP = 1e-2
MAPPED = 2e-2
RELAXATION = 5e-2


def plug(name, k=1, perCell=1, height=HEIGHT, **options):
    spacing = (math.pi/6/(1 - VOID))**(1/3)*k*powder.diameter
    cell = perCell*spacing
    layers = 2*round(height/cell/2)
    box = Box((cell, cell, 2*layers*cell), (1, 1, 2*layers),
              ("periodic", "periodic", ("noSlip", "outlet")))
    settings = dict(k=k, motion="tied", gravity=(0, 0, -GRAVITY), deltaT=0.1*RESPONSE,
                    subSteps=5, endTime=RESPONSES*RESPONSE,
                    positions=lattice(box, perCell, (layers//2, layers//2 + layers)))
    settings.update(options)
    return Case(name, box, powder, **settings)


def mass(case):
    return len(case.positions)*math.pi/6*case.diameter**3*powder.density


def fall(run):
    """Velocity of the plug by time, from its momentum."""
    return [(t, -ofPowder[2]/mass(run.case)) for t, _, ofPowder, _ in run.budget()]


def relaxation(run, end):
    """Response time, from when the plug has lost all but 1/e of the way to its end speed."""
    before = (0.0, 0.0)
    for t, v in fall(run):
        if v > end*(1 - 1/math.e):
            # Between two steps log(1 - v/end) is a straight line.
            low, high = (math.log(1 - x/end) for x in (before[1], v))
            return before[0] + (t - before[0])*(-1 - low)/(high - low)
        before = (t, v)
    return math.inf


def mappedSpeed(run):
    height = run.case.box.cell[2]
    voids = run.layers("voidFraction")
    weight = sum(1 - alpha for alpha in voids)*powder.density*GRAVITY*height
    return root(lambda v: sum(powder.slope(alpha, v) for alpha in voids)*height - weight, 0, 1)


def judge(bench, case, speedTolerance, expected=None):
    run = bench.run(case, impulse=mass(case)*GRAVITY*case.deltaT)
    expected = expected or mappedSpeed(run)
    area = case.box.size[0]*case.box.size[1]
    measured = fall(run)[-1][1]
    bench.near(run, "end speed [m/s]", expected, measured, speedTolerance)
    bench.near(run, "pressure below the plug [Pa]", mass(case)*GRAVITY/area,
               run.pressureLayers()[0], SHARP)
    bench.near(run, "response time [s]", expected/GRAVITY, relaxation(run, expected), RELAXATION)
    path = fall(run)
    bench.curve(case.name, "t [s]", "falling at [m/s]", [
        (t, -expected*math.expm1(-t*GRAVITY/expected)) for t in (path[-1][0]*i/60 for i in range(61))], path[::2])
    return run


def judgeEnd(bench, case):
    run = bench.run(case, impulse=mass(case)*GRAVITY*case.deltaT)
    bench.near(run, "end speed [m/s]", mappedSpeed(run), fall(run)[-1][1], SHARP)


def verify(bench):
    judge(bench, plug("plug, k = 1"), SHARP, END_SPEED)
    for k in (4, 10):
        judge(bench, plug(f"plug, k = {k}", k=k, perCell=2, smoothingWidth=2*k*powder.diameter),
              MAPPED)
    chosen = judge(bench, plug("plug, interval chosen", k=4, perCell=2, adjustTimeStep=True,
                               deltaT=0.05*RESPONSE), MAPPED)
    times = [row[0] for row in chosen.budget()]
    bench.near(chosen, "interval that was chosen [s]", 0.2*RESPONSE,
               max(b - a for a, b in zip(times, times[1:])), 0.1)

    # Close to the limit of stability the transient is wrong, the end is not.
    judgeEnd(bench, plug("plug, interval 0.9", k=4, perCell=2, deltaT=0.9*RESPONSE, subSteps=20,
                         endTime=36*RESPONSE))

    bench.refused(plug("plug, interval too long", k=10, deltaT=1.5*RESPONSE, subSteps=10),
                  "deltaT", "response time", "adjustTimeStep")
    crossing(bench)


def crossing(bench):
    """What depositing by centres does: no air at all, until grains cross a face. With the kernel
    nothing is seen of the crossing."""
    spikes = {}
    for deposit in ("kernel", "centre"):
        case = plug(f"plug, crossing, {deposit}", k=4, perCell=1, deposit=deposit)
        # All grains start a little above a face of the mesh.
        case.positions = [(x, y, z - 0.47*case.box.cell[2]) for x, y, z in case.positions]
        run = bench.run(case, impulse=math.inf)
        top = max(v for _, v in fall(run))
        spikes[deposit] = top/mappedSpeed(run)
        if deposit == "kernel":
            bench.near(run, "highest speed [m/s]", mappedSpeed(run), top, MAPPED)
        else:
            bench.atLeast(run, "must fail: highest over end speed", 2, spikes[deposit])


if __name__ == "__main__":
    main(verify)
