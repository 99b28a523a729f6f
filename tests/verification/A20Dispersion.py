# SPDX-License-Identifier: GPL-3.0-or-later
"""Dispersion of lone grains by turbulence, in air whose k and dissipation are given.

a  Grains that follow the air spread as G.I. Taylor, Proc. London Math. Soc. 20 (1922) 196-212, found for an exponential
   memory: 2 s^2 T (t - T (1 - exp(-t/T))) a direction, whatever the time step.
b  Grains that fall through it at a speed v_t remember it for T/sqrt(1 + (v_t/s)^2), and move with the mean square
   s^2 T/(T + t_p) of C.-M. Tchen (1947) for that time.
c  Where k is uneven, grains that follow the air stay evenly spread (D.J. Thomson, J. Fluid Mech. 180 (1987) 529-556);
   heavy ones gather where it is calm: D dn/dx = -n t_p d<v^2>/dx with D = s^2 T and <v^2> = s^2 T/(T + t_p) (M.W. Reeks,
   J. Aerosol Sci. 14 (1983) 729-739), so that n s^m is even, m = 2 t_p/(T + t_p) = 2 (1 - <v^2>/s^2).
d  What the grains get, the air loses; any ranks give the same path; so does a run that was stopped in between.
e  `auto` turns it on by drag over weight; not in a bed; laminar air cannot have it.
"""
import itertools
import math
import random

import A13ShearLift as sheared
from harness import case as cases
from harness.bench import main
from harness.case import Box, Case, fill, goOn, lattice
from harness.laws import GRAVITY, Powder, stokes

ALONE = "dispersion on; shearLift off; spinLift off; virtualMass off; viscousForce off;"
GRAINS = 30  # along each edge
SCATTER = 4*math.sqrt(2/(3*GRAINS**3))  # of a mean square, four standard errors
MEMORY = 2.075  # k/e over the Lagrangian time


class Turbulent(Case):
    """Air with a k-epsilon model: at x, in lengths of the box, fluctuations rms(x) [m/s] that last for `memory` [s]."""

    def __init__(self, *words, rms, memory, **options):
        super().__init__(*words, **options)
        self.rms = rms if callable(rms) else lambda x: rms
        self.memory = memory

    def write(self, folder, ranks):
        super().write(folder, ranks)
        (folder/"constant/turbulenceProperties").write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n"
            "simulationType RAS;\nRAS { RASModel kEpsilon; turbulence on; printCoeffs off; }\n")
        solution = folder/"system/fvSolution"
        solution.write_text(solution.read_text().replace('"U.*"', '"(U|k|epsilon).*"'))
        nx, ny, nz = self.box.cells
        energies = [1.5*self.rms((i + 0.5)/nx)**2 for i in range(nx)]*(ny*nz)
        dissipations = [k/(MEMORY*self.memory) for k in energies]
        pressure = (folder/"0/p").read_text()
        for name, dimensions, values in (
                ("k", "[0 2 -2 0 0 0 0]", energies), ("epsilon", "[0 2 -3 0 0 0 0]", dissipations),
                ("nut", "[0 2 -1 0 0 0 0]", [0.09*k*k/e for k, e in zip(energies, dissipations)])):
            text = pressure.replace("object p;", f"object {name};").replace("[0 2 -2 0 0 0 0]", dimensions)
            (folder/"0"/name).write_text(text)
            fill(folder/"0"/name, "scalar", [format(v, ".15g") for v in values])


def cube(edge, cells=5):
    return Box((edge,)*3, (cells,)*3)


def still(name, box, powder, rms, memory, **options):
    """In a held air at rest."""
    each = GRAINS/box.cells[0]
    assert each == int(each)
    return Turbulent(name, box, powder, rms=rms, memory=memory, air="oneWay", lawName="Stokes", effects=ALONE,
                     positions=lattice(box, int(each)), **options)


def ends(case):
    """Options of a record of the first and the last moment."""
    return {"recordEvery": round(case["endTime"]/case["deltaT"])*case.get("subSteps", 1)}


def moves(first, last, box):
    """Displacements of all grains in a periodic box, by the nearest image, along each axis."""
    return [(b - a + 0.5*edge) % edge - 0.5*edge for i in first for a, b, edge in zip(first[i][0], last[i][0], box.size)]


def meanSquare(values):
    return sum(v*v for v in values)/len(values)


def judgeSpread(bench):
    rms, memory, end = 0.1, 0.01, 0.05
    expected = lambda t: 2*rms**2*memory*(t - memory*(1 - math.exp(-t/memory)))
    for name, deltaT in (("short steps", 1e-3), ("long steps", 2.5e-2)):
        run = bench.run(still(name, cube(0.1), Powder(2e-6, 1000.0, law=stokes), rms, memory, deltaT=deltaT, endTime=end,
                              recordEvery=max(1, round(2.5e-3/deltaT))), impulse=math.inf)
        record = run.record()
        found = [(t, meanSquare(moves(record[min(record)], grains, run.case.box))) for t, grains in record.items()]
        bench.near(run, "mean square of the moves [m2]", expected(end), found[-1][1], SCATTER)
        bench.curve(name, "t [s]", "mean square of the moves [m2]", [(x*end/60, expected(x*end/60)) for x in range(61)], found)


def judgeFall(bench):
    powder = Powder(40e-6, 7360.0, law=stokes)
    response = powder.density*powder.diameter**2/(18*powder.air.viscosity)
    fall = response*GRAVITY
    rms, memory = 0.1*fall, 0.1
    seen = memory/math.hypot(1, fall/rms)
    times = {"deltaT": seen/5, "endTime": 120*seen/5}
    run = bench.run(still("falling", cube(0.1), powder, rms, memory, gravity=(0, 0, -GRAVITY), velocity=(0, 0, -fall),
                          **times, **ends(times)), impulse=math.inf)
    record = run.record()
    velocities = [v for _, v in record[max(record)].values()]
    mean = sum(v[2] for v in velocities)/len(velocities)
    bench.near(run, "mean speed of the fall [m/s]", fall, -mean, 1e-3)
    bench.near(run, "mean square of the velocities [m2/s2]", rms**2*seen/(seen + response),
               meanSquare([x for v in velocities for x in (v[0], v[1], v[2] - mean)]), SCATTER + 1e-2)


MANY = 20000
WAVE = 4*math.sqrt(2/MANY)  # of a wave of density, four standard errors


def wavy(name, edge, powder, rms, density=lambda x: 1, **options):
    """Grains in a held air whose fluctuations are rms(x), with x in lengths of the box; as densely as density(x), 1 at most."""
    chance = random.Random(1)
    places = (tuple(chance.random() for _ in range(3)) for _ in itertools.count())
    chosen = itertools.islice((place for place in places if chance.random() < density(place[0])), MANY)
    return Turbulent(name, Box((edge,)*3, (30, 5, 5)), powder, rms=rms, air="oneWay", lawName="Stokes", effects=ALONE,
                     positions=[tuple(edge*x for x in place) for place in chosen], **options, **ends(options))


def sine(x):
    return math.sin(2*math.pi*x)


def inTheEnd(run):
    """Place in lengths of the box, and velocity, of each grain."""
    record = run.record()
    return [(x[0]/run.case.box.size[0], v) for x, v in record[max(record)].values()]


def judgeEvenness(bench):
    run = bench.run(wavy("uneven", 0.02, Powder(2e-6, 1000.0, law=stokes), lambda x: 0.1*(1 + 0.5*sine(x)),
                         memory=5e-3, deltaT=5e-4, endTime=0.2), impulse=math.inf)
    wave = 2*sum(sine(x) for x, _ in inTheEnd(run))/MANY
    bench.equal(run, "wave of the density, of its mean", 0, wave, WAVE)


def judgeGathering(bench):
    """Paths of a fortieth of the box; a time in which a wave of density fades to a tenth; the start is near the law."""
    powder = Powder(10e-6, 7360.0, law=stokes)
    response = powder.density*powder.diameter**2/(18*powder.air.viscosity)
    memory = response/4
    rms = lambda x: 1 + 0.3*sine(x)
    run = bench.run(wavy("gathering", 40*response/math.sqrt(5), powder, rms, lambda x: (0.7/rms(x))**1.7, memory=memory,
                         deltaT=memory/2, endTime=150*response), impulse=math.inf)
    grains = inTheEnd(run)
    share = sum(meanSquare(v)/rms(x)**2 for x, v in grains)/MANY
    middles = [(i + 0.5)/1000 for i in range(1000)]
    density = [rms(x)**(2*(share - 1)) for x in middles]
    expected = 2*sum(n*sine(x) for n, x in zip(density, middles))/sum(density)
    bench.equal(run, "wave of the density of heavy grains, of its mean", expected,
                2*sum(sine(x) for x, _ in grains)/MANY, WAVE)


class Gusty(Turbulent, sheared.Sheared):
    """A few grains across a shear that comes back on itself, in turbulence that lives on."""

    def __init__(self, name, **options):
        edge = 8e-3
        Turbulent.__init__(self, name, Box((edge,)*3, (8,)*3), Powder(40e-6, 7360.0, law=stokes),
                           lambda x: math.sin(2*math.pi*x/edge), memory=2e-3,
                           **{"rms": 0.3, "effects": ALONE, "gravity": (0, 0, -GRAVITY), "deltaT": 1e-4, "subSteps": 4, "endTime": 2e-3,
                              "positions": [(edge/2 + 0.3e-3*i, edge/2, edge/2 + 1e-3*i) for i in range(3)], **options})


def grainsMomentum(run):
    return run.budget()[-1][2]


def judgeMomentum(bench):
    run = bench.run(Gusty("momentum"), impulse=math.inf)
    first, last = run.budget()[0], run.budget()[-1]
    size = math.hypot(*last[2])
    for d, axis in enumerate("xy"):
        total = [air[d] + grains[d] - owed[d] for _, air, grains, owed in (first, last)]
        bench.equal(run, f"momentum gained along {axis}, of the grains'", 0, (total[1] - total[0])/size, sheared.CONSERVED)
        bench.atLeast(run, f"momentum of the grains along {axis}, of all", 1e-3, abs(last[2][d])/size)
    if bench.ranks > 1:
        alone = cases.run(Gusty("one rank"), bench.folder(Gusty("one rank")), 1, bench.solver)
        bench.equal(run, "momentum of the grains beside that on one rank", 0,
                    math.dist(grainsMomentum(run), grainsMomentum(alone))/size, 1e-6)


def judgeRestart(bench):
    run = bench.run(Gusty("stopped", writeInterval=1e-3), impulse=math.inf)
    again = goOn(run, run.times()[0], bench.solver)
    one, same = grainsMomentum(run), grainsMomentum(again)
    bench.equal(again, "momentum of the grains beside that without a stop", 0, math.dist(one, same)/math.hypot(*one), 1e-9)


def judgeChoice(bench):
    powder = Powder()
    limit = 0.1*powder.density*GRAVITY*powder.diameter**2/(18*powder.air.viscosity)
    for name, rms in (("auto, weak", 0.9*limit), ("auto, strong", 1.1*limit)):
        run = bench.run(Gusty(name, rms=rms, effects="", endTime=2e-4), impulse=math.inf)
        bench.equal(run, "told to be simulated", rms > limit, "dispersion is simulated" in run.log, 0)
    box = cube(4e-3, 4)
    for name, void, blown in (("bed", 0.88, False), ("sparse", 0.92, True)):
        grain = Powder(((1 - void)*1e-9/8*6/math.pi)**(1/3), 20.0, law=stokes)
        run = bench.run(Turbulent(name, box, grain, rms=1.0, memory=2e-3, effects="", positions=lattice(box, 2),
                                  deltaT=1e-5, endTime=1e-4), impulse=math.inf)
        bench.equal(run, "told to be simulated", blown, "dispersion is simulated" in run.log, 0)
    bench.refused(Case("laminar", cube(0.01), positions=[(5e-3,)*3], effects="dispersion on;"),
                  "dispersion on, laminar air", "effects, key dispersion", "turbulenceProperties, key simulationType")


def verify(bench):
    if bench.ranks == 1:
        judgeSpread(bench)
        judgeFall(bench)
        judgeEvenness(bench)
        judgeGathering(bench)
        judgeRestart(bench)
    judgeMomentum(bench)
    judgeChoice(bench)


if __name__ == "__main__":
    main(verify)
