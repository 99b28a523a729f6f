# SPDX-License-Identifier: GPL-3.0-or-later
"""Air that moves the powder and is not moved by it, no air, and who decides.

a  `oneWay`: grains in given air, with a velocity u and a pressure gradient G along z, fall as
   v = (u + T (-g - G/rho_p)) (1 - exp(-t/T)), T = rho_p d^2/(18 mu), whether they are one or many; the air stays as it
   was given, to the last digit.
b  `auto` leaves the air out where zeta = rho_a (rho_s - rho_a) g d^3/mu^2 rho_s/rho_a exceeds twice 9.56e6 [Y. Guo et al.,
   AIChE J. 55 (2009) 49-62] and nothing but powder could move it: grains then fall freely. Finer ones meet air, and
   those in air that flows through a boundary, and those that are to feel an effect of it. Asking for that and for no air
   is refused.
c  Finer grains that appear when the air is left out find none, and the user is told.
"""
import math
import re

from harness.bench import main
from harness.case import Box, Case, fill
from harness.laws import GRAVITY, Powder, stokes

CLOSE = 1e-9
SPEED, SLOPE = 0.3, 2e4  # of the air [m/s], [Pa/m]
GRAIN = Powder(60e-6, 2000.0, law=stokes)
EDGE = 0.01
LEFT_OUT = 2*9.56e6  # zeta


class Given(Case):
    """Air with a pressure that rises along z."""

    def write(self, folder, ranks):
        super().write(folder, ranks)
        nx, ny, nz = self.box.cells
        rows = [f"{SLOPE/self.powder.air.density*(i//(nx*ny) + 0.5)*self.box.cell[2]:.15g}" for i in range(nx*ny*nz)]
        fill(folder/"0/p", "scalar", rows)


def judgeGiven(bench):
    response = GRAIN.density*GRAIN.diameter**2/(18*GRAIN.air.viscosity)
    deltaT = response/10
    for name, each in (("one grain", 1), ("many", 512)):
        places = [(EDGE*(0.3 + 0.4*(i % 8)/8), EDGE*(0.3 + 0.4*(i//8 % 8)/8), EDGE*(2 + 0.05*(i//64)/8))
                  for i in range(each)]
        run = bench.run(Given(name, Box((EDGE, EDGE, 3*EDGE), (5, 5, 15), ("slip",)*3), GRAIN, positions=places, air="oneWay",
                              lawName="Stokes", U=(0, 0, SPEED), gravity=(0, 0, -GRAVITY), deltaT=deltaT, subSteps=4,
                              endTime=20*deltaT), impulse=math.inf)
        time, _, grains, _ = run.budget()[-1]
        final = SPEED - response*(GRAVITY + SLOPE/GRAIN.density)
        mass = each*math.pi/6*GRAIN.diameter**3*GRAIN.density
        bench.near(run, "velocity [m/s]", final*-math.expm1(-time/response), grains[2]/mass, CLOSE)
        bench.equal(run, "change of the air, largest [m/s]", 0, max(abs(u[2] - SPEED) for u in run.field("U")), 0)


def sensitivity(powder):
    air = powder.air
    return (powder.density*(powder.density - air.density)*GRAVITY*powder.diameter**3/air.viscosity**2)


def judgeChoice(bench):
    limit = (LEFT_OUT*GRAIN.air.viscosity**2/(7360*(7360 - 1.225)*GRAVITY))**(1/3)
    still, through = ("noSlip",)*3, ("noSlip", "noSlip", ("inlet", "outlet"))
    for name, size, sides, speed, effects, kept in (("fine", 0.99*limit, still, 0, "", True),
                                                    ("coarse", 1.01*limit, still, 0, "", False),
                                                    ("coarse, driven", 1.01*limit, through, 1.0, "", True),
                                                    ("coarse, wanted", 1.01*limit, still, 0, "virtualMass on;", True)):
        powder = Powder(size, 7360.0)
        deltaT = 1e-4
        run = bench.run(Case(name, Box((EDGE,)*3, (5,)*3, sides), powder, positions=[(EDGE/2,)*3], air="auto",
                             effects=effects, U=(0, 0, speed), gravity=(0, 0, -GRAVITY), deltaT=deltaT, subSteps=4, endTime=10*deltaT),
                        impulse=math.inf)
        bench.equal(run, "told to be left out", not kept, "The air is left out: zeta is" in run.log, 0)
        bench.equal(run, "steps with air", 10 if kept else 0, len(re.findall(r"p iterations", run.log)), 0)
        if not kept:
            time, _, grain, _ = run.budget()[-1]
            bench.near(run, "velocity [m/s]", -GRAVITY*time,
                       grain[2]/(math.pi/6*size**3*powder.density), CLOSE)


class Joined(Case):
    """Twenty finer grains appear in the middle of the run."""
    finer = 50e-6

    def write(self, folder, ranks):
        super().write(folder, ranks)
        edge = f"{0.2*EDGE:g} {0.8*EDGE:g}"
        script = folder/"powder.in"
        script.write_text(script.read_text().replace("thermo ", f"""
fix     kind all particletemplate/sphere 15485863 atom_type 1 volume_limit 1e-20 &
        density constant {self.powder.density} &
        radius constant {self.finer/2}
fix     mixture all particledistribution/discrete 32452843 1 kind 1.0
region  above block {edge} {edge} {0.7*EDGE:g} {0.9*EDGE:g} units box
fix     filling all insert/pack seed 49979687 distributiontemplate mixture insert_every once &
        start 40 overlapcheck yes all_in yes particles_in_region 20 region above
thermo """))


def judgeLate(bench):
    coarse = Powder(1e-3, 7360.0)
    run = bench.run(Joined("joined by finer ones", Box((EDGE,)*3, (5,)*3, ("noSlip",)*3), coarse, positions=[(EDGE/2,)*3],
                           air="auto", gravity=(0, 0, -GRAVITY), deltaT=1e-4, subSteps=4, endTime=60e-4), impulse=math.inf)
    told = re.findall(r"air is off, and would matter: .* is ([0-9.e+-]+), above 1", run.log)
    bench.equal(run, "told once that the air is missed", 1, len(told), 0)
    bench.near(run, "1.91e7/zeta", LEFT_OUT/(sensitivity(Powder(Joined.finer, 7360.0))), float(told[0]), 5e-2)


def judgeVacuum(bench):
    """Foam in a vacuum takes no air along."""
    run = bench.run(Case("foam without air", Box((EDGE,)*3, (5,)*3, ("noSlip",)*3), Powder(1e-3, 10.0), positions=[(EDGE/2,)*3],
                         air="none", effects="", gravity=(0, 0, -GRAVITY), subSteps=4), impulse=math.inf)
    bench.equal(run, "told to be simulated", 0, len(re.findall(r"(\w+) is simulated from", run.log)), 0)
    bench.refused(Case("virtual mass without air", Box((EDGE,)*3, (5,)*3, ("noSlip",)*3), Powder(1e-3, 10.0),
                       positions=[(EDGE/2,)*3], air="none", effects="virtualMass on;"),
                  "air none, virtualMass on", "key air;", "effects, key virtualMass")


def verify(bench):
    judgeVacuum(bench)
    judgeLate(bench)
    judgeGiven(bench)
    judgeChoice(bench)


if __name__ == "__main__":
    main(verify)
