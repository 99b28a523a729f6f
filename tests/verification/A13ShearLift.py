# SPDX-License-Identifier: GPL-3.0-or-later
"""Lift of a grain in sheared air (Saffman with Mei's correction), by key and by itself.

a  A grain falls along z through air whose upward velocity rises with x. It lags behind the air, and so
   drifts to where that is faster, at 1.615 mu d s sqrt(Re_G) f/(3 pi mu d) in Stokes' drag, s its slip. One
   cell along y and z, so that the shear cannot break up.
b  `auto` turns it on where 0.171 sqrt(rho G d^2/mu) exceeds 0.1, and leaves it out elsewhere.
c  In a bed, of a void fraction below 0.9, grains feel no lift, neither by shear nor by spin, and call for none.
d  Grains across a shear that comes back on itself: what lift gives them the air loses.
"""
import math
import re

from harness.bench import main
from harness.case import Box, Case, fill, lattice
from harness.laws import Air, GRAVITY, Powder, stokes

DRIFT = 1e-2
CONSERVED = 1e-10
LIMIT = 0.1


def mei(reynolds, shear):
    """R. Mei, Int. J. Multiphase Flow 18 (1992) 145-147."""
    if reynolds > 40:
        return 0.0524*math.sqrt(shear*reynolds)
    rest = 0.3314*math.sqrt(shear)
    return (1 - rest)*math.exp(-reynolds/10) + rest


def drift(powder, rate):
    """Sideways, of a grain that has settled [m/s]: v = c s and s = t (g + G v) - c v, with t the response
    time, s the slip along z, G v the acceleration of the air that the grain meets, and c lift over drag."""
    air, d = powder.air, powder.diameter
    response = powder.density*d*d/(18*air.viscosity)
    v, slip = 0.0, response*GRAVITY
    for _ in range(100):
        speed = math.hypot(v, slip)
        c = 1.615/(3*math.pi)*math.sqrt(air.density*rate*d*d/air.viscosity)*mei(
            air.reynolds(speed, d), 0.5*d*rate/speed)
        v, slip = c*slip, response*(GRAVITY + rate*v) - c*v
    return v


class Sheared(Case):
    """Air that moves along z with speed(x)."""

    def __init__(self, name, box, powder, speed, **options):
        super().__init__(name, box, powder, lawName="Stokes", **options)
        self.speed = speed

    def write(self, folder, ranks):
        super().write(folder, ranks)
        nx, ny, nz = self.box.cells
        row = [f"(0 0 {self.speed((i + 0.5)*self.box.cell[0]):.15g})" for i in range(nx)]
        fill(folder/"0/U", "vector", row*(ny*nz))
        path = folder/"0/U"
        for patch, x in (("west", 0), ("east", self.box.size[0])):
            wall = f"type fixedValue; value uniform (0 0 {self.speed(x):.15g});"
            path.write_text(re.sub(patch + r" \{ type noSlip; \}", f"{patch} {{ {wall} }}", path.read_text()))


def falling(name, powder, rate, effects, **options):
    length, edge = 0.05, 0.01
    response = powder.density*powder.diameter**2/(18*powder.air.viscosity)
    deltaT = response/20
    return Sheared(name, Box((length, edge, edge), (5, 1, 1), ("noSlip", "periodic", "periodic")),
                   powder, lambda x: rate*(x - length/2), positions=[(length/2, edge/2, edge/2)],
                   gravity=(0, 0, -GRAVITY), effects=effects,
                   **{"deltaT": deltaT, "subSteps": 4, "endTime": 200*deltaT, **options})


def sideways(run):
    """Velocity of the grain along x."""
    mass = math.pi/6*run.case.diameter**3*run.case.powder.density
    return run.budget()[-1][2][0]/mass


def judgeDrift(bench):
    for name, powder, rate in (
            ("Saffman", Powder(10e-6, 1000.0, law=stokes), 1000.0),
            ("Mei", Powder(100e-6, 1000.0, law=stokes), 50.0)):
        run = bench.run(falling(name, powder, rate, "shearLift on;"), impulse=math.inf)
        bench.near(run, "drift [m/s]", drift(powder, rate), sideways(run), DRIFT)


def judgeChoice(bench):
    air = Air()
    for name, size, rate in (("auto, fine", 20e-6, 500.0), ("auto, coarse", 90e-6, 1200.0)):
        powder = Powder(size, 20.0, air, stokes)
        share = 0.171*math.sqrt(air.density*rate/air.viscosity)*size
        run = bench.run(falling(name, powder, rate, ""), impulse=math.inf)
        expected = drift(powder, rate) if share > LIMIT else 0
        if expected:
            bench.near(run, "drift [m/s]", expected, sideways(run), DRIFT)
        else:
            bench.equal(run, "drift [m/s]", 0, sideways(run), 1e-12)
        bench.equal(run, "told to be simulated", share > LIMIT, "shearLift is simulated" in run.log, 0)


def judgeBed(bench):
    box, rate, each = Box((5e-3, 1e-3, 1e-3), (5, 1, 1), ("noSlip", "periodic", "periodic")), 1200.0, 8
    for name, void, lifted in (("bed", 0.88, False), ("sparse", 0.92, True)):
        powder = Powder(((1 - void)*1e-9/each*6/math.pi)**(1/3), 20.0, law=stokes)
        deltaT = powder.density*powder.diameter**2/(18*powder.air.viscosity)/20
        for choice, effects in (("auto", ""), ("on", "shearLift on; spinLift on; virtualMass off; viscousForce off;")):
            run = bench.run(Sheared(f"{name}, {choice}", box, powder, lambda x: rate*(x - box.size[0]/2), effects=effects,
                                    positions=lattice(box, 2), gravity=(0, 0, -GRAVITY), deltaT=deltaT, subSteps=4,
                                    endTime=5*deltaT), impulse=math.inf)
            momentum = run.budget()[-1][2]
            if choice == "auto":
                bench.equal(run, "told to be simulated", lifted, "shearLift is simulated" in run.log, 0)
            bench.equal(run, "lifted", lifted, abs(momentum[0]) > 1e-9*abs(momentum[2]), 0)


def judgeMomentum(bench, effects, **options):
    """Of a periodic box, along x, in which no other force has a part."""
    edge = 8e-3
    powder = Powder(40e-6, 7360.0, law=stokes)
    wave = Sheared("momentum", Box((edge, edge, edge), (8, 8, 8)), powder,
                   lambda x: math.sin(2*math.pi*x/edge), gravity=(0, 0, -GRAVITY), effects=effects, **options,
                   positions=[(edge/2 + 0.3e-3*i, edge/2, edge/2 + 1e-3*i) for i in range(3)],
                   deltaT=1e-4, subSteps=4, endTime=2e-3)
    run = bench.run(wave, impulse=math.inf)
    first, last = run.budget()[0], run.budget()[-1]
    total = [air[0] + grains[0] - owed[0] for _, air, grains, owed in (first, last)]
    bench.equal(run, "momentum gained, of the grains'", 0, (total[1] - total[0])/abs(last[2][0]), CONSERVED)


def verify(bench):
    if bench.ranks == 1:
        judgeDrift(bench)
    judgeChoice(bench)
    judgeBed(bench)
    judgeMomentum(bench, "shearLift on;")


if __name__ == "__main__":
    main(verify)
