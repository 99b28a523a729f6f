# SPDX-License-Identifier: GPL-3.0-or-later
"""Air blows through the densest bed of the finest grains, 20 um at a void fraction of 0.36: drag would
stop it within 60 ns, and the coupling step is up to 17 000 times as long.

Drag taken at the start of a step would throw the air back at as many times its speed. Taken at its end
but forgotten in the pressure equation, it leaves a flow that is no longer free of sources. What must
happen: the slip of free grains fades without a change of sign to the velocity that both have in common
by their momentum; and where grains held in disorder give the pressure work to do, it needs few
iterations, its flow has no sources, and the pressure drop is the same for any step.

Of a disordered bed of free grains, only steps up to the response of the powder are stable (H03): for
longer ones the pressure, not drag, would throw about the grains. They are refused.
"""
import math
import random

from hardCase import Box, Case, Powder, continuityError, lattice, main, mostIterations

VOID = 0.36
JOLT = 0.3  # of the spacing, either way
SPEED = 0.1  # of the air at the start, or superficial [m/s]
COUNT = 10  # steps
STEPS = (1e-5, 1e-4, 1e-3)  # [s]; 0.12, 1.2 and 12 response times
LIFTED = "stabilityLimit 1e9; parcelCourant 1e9;"
POWDER = Powder(20e-6, 7360.0)
EDGE = 2*(math.pi/6/(1 - VOID))**(1/3)*POWDER.diameter  # of a cell
# Beyond what a free grain would take, the drag of one that is held comes a step later, spread over its
# cells like its volume: not quite as drag is, where the void fraction differs between them.
ALIKE = 2e-2
# The pressure is solved to a share of the drag that it balances; what flows is less by orders.
TOLERANCE = 1e-14


def stiffness(deltaT):
    """Drag of a step over the inertia of the air."""
    return (1 - VOID)*POWDER.B(VOID, SPEED)*deltaT/(POWDER.air.density*VOID)


def jolted(box, places):
    chance = random.Random(2)
    return [tuple((x + JOLT*chance.uniform(-0.5, 0.5)*EDGE) % length
                  for x, length in zip(place, box.size)) for place in places]


def free(deltaT, disorder=False, timeStep=LIFTED):
    box = Box((4*EDGE, 4*EDGE, 8*EDGE), (4, 4, 8))
    grains = jolted(box, lattice(box, 2)) if disorder else lattice(box, 2)
    return Case(f"{'disorder' if disorder else 'lattice'}, dt {1e6*deltaT:g} us", box, POWDER,
                positions=grains, U=(0, 0, SPEED), deltaT=deltaT, subSteps=10,
                endTime=COUNT*deltaT, timeStep=timeStep,
                pressureTolerance=TOLERANCE)


def held(deltaT):
    """A bed in disorder that stays, with air below and above, and air blown through."""
    box = Box((4*EDGE, 4*EDGE, 16*EDGE), (4, 4, 16), ("periodic", "periodic", ("inlet", "outlet")))
    return Case(f"held, dt {1e6*deltaT:g} us", box, POWDER, motion="frozen",
                positions=jolted(box, lattice(box, 2, (4, 12))), U=(0, 0, SPEED), deltaT=deltaT,
                subSteps=max(10, round(1e6*deltaT)), endTime=COUNT*deltaT, timeStep=LIFTED,
                pressureTolerance=TOLERANCE)


def judgeSlip(bench, case):
    air = POWDER.air.density*VOID*case.box.volume
    powder = (1 - VOID)*POWDER.density*case.box.volume
    run = bench.run(case, impulse=air*SPEED)
    slip = [SPEED] + [a[2]/air - p[2]/powder for _, a, p, _ in run.budget()]
    growth = max(b - a for a, b in zip(slip, slip[1:]))
    bench.atMost(run, "growth of slip in a step, of the first", 1e-9, growth/SPEED)
    bench.atLeast(run, "least slip, of the first", -1e-9, min(slip)/SPEED)
    bench.near(run, "last velocity of the powder [m/s]", SPEED*air/(air + powder),
               run.budget()[-1][2][2]/powder, 1e-3)


def judgePressure(bench, run):
    bench.atMost(run, "iterations of the pressure", 99, mostIterations(run))
    bench.atMost(run, "continuity error, of the flux", 1e-8, continuityError(run))


def verify(bench):
    drops = []
    for deltaT in STEPS:
        judgeSlip(bench, free(deltaT))
        run = bench.run(held(deltaT), impulse=math.inf)
        bench.report(run, "drag of a step over inertia of the air", stiffness(deltaT),
                     stiffness(deltaT))
        judgePressure(bench, run)
        p = run.pressureLayers()
        drops.append(p[0] - p[-1])
    for drop in drops[1:]:
        bench.near(run, "pressure drop, as with the shortest step [Pa]", drops[0], drop, ALIKE)

    run = bench.run(free(STEPS[0], disorder=True), impulse=math.inf)
    judgePressure(bench, run)
    for deltaT in STEPS[1:]:
        bench.refused(free(deltaT, disorder=True, timeStep=""), f"deltaT {deltaT:g} s",
                      "response time", "adjustTimeStep")


if __name__ == "__main__":
    main(verify)
