# SPDX-License-Identifier: GPL-3.0-or-later
"""Air and grains in a closed periodic box, with steps of 10, 100 and 1000 times the time in which their
slip decays (A.4). What drag does in such a step it must not do twice over.

    slip' = -slip/tau      1/tau = beta/(alpha rho_f) + beta/(alpha_p rho_p)

Where grains are evenly spread, slip may never change its sign or grow, and must decay at least as fast
as by implicit Euler steps of this, to (1 + dt/tau)^-n after n steps. In a cloud, where they stand dense
the common velocity is another than where they are sparse; so slip is that of the grains to the air
around them, and as a mean over cells it can tell no more than a thousandth. Momentum is kept to 1e-10
in a step and 1e-6 over the run in both.

Air gives way to the grains, by a factor of 667; in water both do. The one asks for air that moves
implicitly, the other for grains whose drag follows their velocity in the DEM's sub-steps. Without
either the slip must be seen to turn, and by as much as theory says.
"""
import copy
import math
import random

from hardCase import Air, Box, Case, Powder, lattice, main

from H17Polydisperse import K, KINDS, SIZES, Mixture

SOLIDS = 0.1
CELLS = 6
FLUIDS = {"air": (Powder(), 1e-4), "water": (Powder(1e-3, 2600.0, Air(998.0, 1e-3)), 1e-7)}
LAWS = ("DiFelice", "KochHill", "Beetstra", "SchillerNaumann", "Stokes")  # and the blend
COUNT = 6  # steps of a run
STIFF = (10, 100, 1000)
ROUND_OFF = 1e-9  # of the first slip
COVARIANCE = 1e-3  # of drag and velocity of the air within the reach of a grain, of the first slip
STEP, WHOLE_RUN = 1e-10, 1e-6


def decayTime(powder):
    beta = SOLIDS*powder.B(1 - SOLIDS, 0.0)
    return 1/(beta/((1 - SOLIDS)*powder.air.density) + beta/(SOLIDS*powder.density))


def stiffBox(name, fluid, steps, cloud=False, k=1, law="GidaspowHuilin"):
    """`steps`: coupling step over the time of decay. `cloud`: grains at random."""
    powder, speed = FLUIDS[fluid]
    cell = 2*(math.pi/6/SOLIDS)**(1/3)*k*powder.diameter
    box = Box((CELLS*cell,)*3, (CELLS,)*3)
    grains = lattice(box, 2)
    if cloud:
        chance = random.Random(4)
        grains = [tuple(chance.uniform(0, CELLS*cell) for _ in range(3)) for _ in grains]
    dt = steps*decayTime(powder)
    return Case(name, box, powder, k=k, lawName=law, positions=grains, velocity=(0, 0, speed),
                deltaT=dt, subSteps=10, endTime=COUNT*dt, writeInterval=dt,
                timeStep="stabilityLimit 1e9; parcelCourant 1e9;")


def mixedSizes(name, steps):
    """Grains of 20, 40 and 60 um at random, all as quick at the start."""
    case = stiffBox(name, "air", steps, cloud=True, k=K)
    case.__class__ = Mixture
    case.kinds = [i % len(SIZES) for i in range(len(case.positions))]
    return case


def masses(case):
    """Of all grains and of the air, by the box and what stands in it [kg]."""
    sizes = [case.diameter]*len(case.positions)
    if isinstance(case, Mixture):
        sizes = [case.k*KINDS[kind].diameter for kind in case.kinds]
    volume = math.fsum(math.pi/6*size**3 for size in sizes)
    return volume*case.powder.density, (case.box.volume - volume)*case.powder.air.density


def slips(run):
    """Mean velocity of the grains less that of the air after each step, of the first."""
    powder, air = masses(run.case)
    speed = run.case.velocity[2]
    return [1.0] + [(p[2]/powder - a[2]/air)/speed for _, a, p, _ in run.budget()]


def slipsAtGrains(run):
    """The same with the air where the grains are: cells count as much as they hold of them."""
    found = [1.0]
    for time, (_, _, powder, _) in zip(run.times(), run.budget()):
        solids = [1 - alpha for alpha in run.field("voidFraction", time)]
        around = math.fsum(s*u[2] for s, u in zip(solids, run.field("U", time)))/math.fsum(solids)
        found.append((powder[2]/masses(run.case)[0] - around)/run.case.velocity[2])
    return found


def judgeMomentum(bench, run):
    start = masses(run.case)[0]*run.case.velocity[2]
    totals = [(0.0, 0.0, start)]
    totals += [tuple(a + p - r for a, p, r in zip(*row[1:])) for row in run.budget()]
    drift = max(math.dist(a, b) for a, b in zip(totals, totals[1:]))
    bench.equal(run, "momentum gained in a step, of all", 0, drift/start, STEP)
    bench.equal(run, "momentum gained in the run, of all", 0,
                math.dist(totals[0], totals[-1])/start, WHOLE_RUN)


def decays(bench, case, measure, tolerance):
    run = bench.run(case, impulse=masses(case)[0]*case.velocity[2])
    judgeMomentum(bench, run)
    slip = measure(run)
    bench.equal(run, "steps on record", COUNT, len(slip) - 1, 0)
    bench.atLeast(run, "least slip, of the first", -tolerance, min(slip))
    bench.atMost(run, "slip gained in a step, of the first", tolerance,
                 max(b - a for a, b in zip(slip, slip[1:])))
    return run, slip


def judge(bench, case, steps):
    run, slip = decays(bench, case, slips, ROUND_OFF)
    bench.atMost(run, "left after a step, of 1/(1 + dt/tau)", 1, slip[1]*(1 + steps))
    bench.atMost(run, "left after two, of its square", 1, (slip[2] - ROUND_OFF)*(1 + steps)**2)


def judgeCloud(bench, case, steps):
    run, slip = decays(bench, case, slipsAtGrains, COVARIANCE)
    bench.atMost(run, "left after a step, of 1/(1 + dt/tau)", 1, slip[1]*(1 + steps))


def mustTurn(bench, case, choice, expected, tolerance):
    """Slip after one step, by the solver with a naive choice."""
    twin = copy.copy(case)
    twin.name = choice
    twin.endTime = twin.deltaT
    run = bench.runNaively(twin, choice)
    bench.near(run, "must turn: slip after a step, of the first", expected, slips(run)[1], tolerance)


def verify(bench):
    for fluid in FLUIDS:
        for steps in STIFF:
            judge(bench, stiffBox(f"{fluid}, lattice, {steps} tau", fluid, steps), steps)
            judgeCloud(bench, stiffBox(f"{fluid}, cloud, {steps} tau", fluid, steps, cloud=True), steps)
    stiffest = STIFF[-1]
    judge(bench, stiffBox("air, lattice, k = 10", "air", stiffest, k=10), stiffest)
    judgeCloud(bench, stiffBox("air, cloud, k = 10", "air", stiffest, cloud=True, k=10), stiffest)
    # Three times of decay: there is no formula for the mean slip.
    decays(bench, mixedSizes("air, cloud, 20 to 60 um", stiffest), slipsAtGrains, COVARIANCE)
    for law in LAWS:
        for fluid in FLUIDS:
            decays(bench, stiffBox(f"{fluid}, {law}", fluid, stiffest, law=law), slips, ROUND_OFF)
    if bench.ranks == 1:
        judgeNaive(bench)


def judgeNaive(bench):
    """Explicit drag throws the air by dt over its own time of response. With drag that is frozen over
    the sub-steps the air is at the common velocity; what is left of the slip throws the grains by dt
    over theirs."""
    for fluid in FLUIDS:
        case = stiffBox(f"{fluid}, lattice, {STIFF[-1]} tau", fluid, STIFF[-1])
        grains, air = masses(case)
        ofGrains = case.deltaT*case.powder.B(1 - SOLIDS, 0.0)/case.powder.density
        ofAir = ofGrains*grains/air
        mustTurn(bench, case, "explicitDrag", math.exp(-ofGrains) - ofAir, 1e-2)
    mustTurn(bench, case, "frozenDrag", air/(air + grains)*(1 - ofGrains), 1e-2)


if __name__ == "__main__":
    main(verify)
