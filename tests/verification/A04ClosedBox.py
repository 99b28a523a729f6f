# SPDX-License-Identifier: GPL-3.0-or-later
"""Air and grains in a periodic box that nothing pushes: momentum is kept, and slip decays.

With alpha uniform and slip so small that drag is linear,

    slip = slip_0 exp(-t/tau),     1/tau = beta/(alpha rho_f) + beta/(alpha_p rho_p)

Two ends of the range: grains in air, where the air gives way, and in water, where the grains do.
The air moves by implicit Euler steps, so with tau set by the air a step of tau/20 decays by
ln(1.05)/0.05, 2.4 % too slowly, whatever the coupling does; the error halves with the step.

Momentum is kept to round-off in every step, however stiff the drag, by the one corrector that all
cases have. (With OpenFOAM's usual H(U) in the pressure equation, whose neighbours lag, a random cloud
at 1000 tau gained 2 % of all momentum in a step until ten outer iterations had converged.)
"""
import math
import random

from harness.bench import main
from harness.case import Box, Case, lattice
from harness.laws import Air, Powder

SOLIDS = 0.1
FLUIDS = {  # grain, density, fluid; tau and (final over first velocity) as published
    "air": (Powder(40e-6, 7360.0, Air()), 1e-4, 4.151e-5, 0.998504),
    "water": (Powder(1e-3, 2600.0, Air(998.0, 1e-3)), 1e-7, 0.08494, 0.2245)}
STEP = 1e-10
WHOLE_RUN = 1e-6
RATE = 1e-2
COMMON = 1e-3


def closed(name, fluid, steps, count, disorder, **options):
    """steps: coupling step over tau. disorder: grains at random instead of on a lattice."""
    powder, speed, tau, _ = FLUIDS[fluid]
    cell = 2*(math.pi/6/SOLIDS)**(1/3)*powder.diameter
    box = Box((8*cell, 8*cell, 8*cell), (8, 8, 8))
    grains = lattice(box, 2)
    if disorder:
        chance = random.Random(4)
        grains = [tuple(chance.uniform(0, 8*cell) for _ in range(3)) for _ in grains]
    dt = steps*tau
    return Case(name, box, powder, positions=grains, velocity=(0, 0, speed), deltaT=dt,
                subSteps=10, endTime=count*dt,
                timeStep="stabilityLimit 1e9; parcelCourant 1e9;", **options)


def judgeMomentum(bench, case):
    """Runs it; returns the run and its slip by time."""
    powder, speed = case.powder, case.velocity[2]
    mass = len(case.positions)*math.pi/6*powder.diameter**3*powder.density
    air = powder.air.density*(1 - SOLIDS)*case.box.volume
    start = mass*speed
    run = bench.run(case, impulse=start)
    totals = [tuple(a + p - r for a, p, r in zip(*row[1:])) for row in run.budget()]
    totals.insert(0, (0.0, 0.0, start))
    drift = max(math.dist(a, b) for a, b in zip(totals, totals[1:]))
    bench.equal(run, "momentum gained in a step, of all", 0, drift/start, STEP)
    bench.equal(run, "momentum gained in the run, of all", 0,
                math.dist(totals[0], totals[-1])/start, WHOLE_RUN)
    slips = [(0.0, speed)]
    slips += [(t, p[2]/mass - a[2]/air) for t, a, p, _ in run.budget()]
    return run, slips


def decay(bench, fluid, steps, judged):
    _, speed, tau, final = FLUIDS[fluid]
    count = round(2/steps)
    case = closed(f"{fluid}, dt = tau/{1/steps:.0f}", fluid, steps, count, disorder=False)
    run, slips = judgeMomentum(bench, case)
    (early, first), (late, last) = slips[0], slips[-1]
    rate = math.log(first/last)/(late - early)
    (bench.near if judged else lambda *a: bench.report(*a[:-1]))(
        run, "rate of decay times tau", 1.0, rate*tau, RATE)


def verify(bench):
    decay(bench, "water", 1/20, judged=True)
    decay(bench, "air", 1/20, judged=False)
    if bench.ranks == 1:
        decay(bench, "air", 1/100, judged=True)
    for fluid in FLUIDS:
        keepsMomentum(bench, fluid, 1/20, disorder=True)
        keepsMomentum(bench, fluid, 1000, disorder=True)
        if bench.ranks == 1:
            run, slips = keepsMomentum(bench, fluid, 1000, disorder=False)
            bench.atLeast(run, "least slip, of the first", -1e-9,
                          min(s for _, s in slips)/slips[0][1])


def keepsMomentum(bench, fluid, steps, disorder, **options):
    powder, speed, _, final = FLUIDS[fluid]
    name = f"{fluid}, {'random' if disorder else 'lattice'}, {steps:g} tau"
    run, slips = judgeMomentum(bench, closed(name, fluid, steps, 10, disorder, **options))
    if steps > 1:
        # With drag this stiff, air and grains are at their common velocity after one step.
        _, _, ofPowder, _ = run.budget()[-1]
        mass = len(run.case.positions)*math.pi/6*powder.diameter**3*powder.density
        bench.near(run, "final over first velocity", final, ofPowder[2]/mass/speed, COMMON)
    return run, slips


if __name__ == "__main__":
    main(verify)
