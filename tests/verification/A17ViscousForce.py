# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscous stresses of the air on the volume of a grain, V div(tau), and the air that then keeps alpha div(tau).

a  Plane Poiseuille flow that a body force f of the fluid drives has mu u'' = -rho f and no pressure gradient. A grain
   in it lags behind the fluid by rho f d^2/(18 mu); without the force it goes with the fluid. In Couette flow it does
   that with the force as well.
b  Grains in a wave of shear that dies out: what they get, the air loses, whichever of the two forms it has, and with all
   other effects as well.
c  `auto` takes it where rho nu |laplacian(u)|/(rho_p g) exceeds 0.01, and leaves it out where it does not.
"""
import math
import re

from harness.bench import main
from harness.case import Box, Case, fill
from harness.laws import Air, GRAVITY, Powder, stokes

OIL = Air(1000.0, 0.1)
GRAIN = Powder(400e-6, 2000.0, OIL, stokes)
WIDTH = 0.01
PUSH = 1.0  # [m/s2]
LAG = 1e-2
CONSERVED = 1e-10
ALONE = "viscousForce on; shearLift off; spinLift off; virtualMass off;"
OFF = ALONE.replace("viscousForce on", "viscousForce off")


class Channel(Case):
    """Flow along z between plates across x, at x = 0 and WIDTH: u_z(x), driven by `push`, or by the plates."""

    def __init__(self, name, effects, speed, push, **options):
        super().__init__(name, Box((WIDTH, 0.02, 0.02), (20, 1, 1), ("noSlip", "periodic", "periodic")), GRAIN,
                         lawName="Stokes", effects=effects, **options)
        self.speed, self.push = speed, push

    def write(self, folder, ranks):
        super().write(folder, ranks)
        path = folder/"0/U"
        force = path.read_text().replace("object U", "object bodyForce").replace("[0 1 -1 0", "[0 1 -2 0")
        (folder/"0/bodyForce").write_text(force)
        fill(folder/"0/bodyForce", "vector", [f"(0 0 {self.push:.15g})"]*20)
        fill(path, "vector", [f"(0 0 {self.speed(x):.15g})" for x in self.middles()])
        for patch, x in (("west", 0), ("east", WIDTH)):
            wall = f"type fixedValue; value uniform (0 0 {self.speed(x):.15g});"
            path.write_text(re.sub(patch + r" \{ type noSlip; \}", f"{patch} {{ {wall} }}", path.read_text()))

    def middles(self):
        return [(i + 0.5)*self.box.cell[0] for i in range(20)]


def poiseuille(x):
    """Of the scheme: 1/8 of a cell squared more than of the equation, from the half cells at the plates."""
    h = WIDTH/20
    return PUSH*OIL.density/(2*OIL.viscosity)*(x*(WIDTH - x) + (0.25*h*h if 0 < x < WIDTH else 0))


def couette(x):
    return 0.5*x/WIDTH


def settled(bench, name, effects, flow, push):
    """Velocity along z of a grain in the middle of a cell, after ten of its response times."""
    response = GRAIN.density*GRAIN.diameter**2/(18*OIL.viscosity)
    start = flow(0.3*WIDTH)
    run = bench.run(Channel(name, effects, flow, push, positions=[(0.3*WIDTH, 0.01, 0.01)], velocity=(0, 0, start),
                            deltaT=response/4, subSteps=4, endTime=10*response), impulse=math.inf)
    return run, run.budget()[-1][2][2]/(math.pi/6*GRAIN.diameter**3*GRAIN.density)


def judgeLag(bench):
    lag = OIL.density*PUSH*GRAIN.diameter**2/(18*OIL.viscosity)
    for name, flow, push, expected in (("Poiseuille", poiseuille, PUSH, lag), ("Couette", couette, 0, 0)):
        _, without = settled(bench, f"{name}, off", OFF, flow, push)
        run, withForce = settled(bench, name, ALONE, flow, push)
        bench.equal(run, "lag by the force, of Poiseuille's", expected/lag, (without - withForce)/lag, LAG)


def judgeMomentum(bench):
    edge = 8e-3

    class Wave(Case):
        def write(self, folder, ranks):
            super().write(folder, ranks)
            fill(folder/"0/U", "vector", [f"(0 0 {0.1*math.sin(2*math.pi*(i % 8 + 0.5)/8):.15g})" for i in range(512)])

    places = [(edge*(0.02 + 0.06*i), edge*(j + 0.5)/8, edge*(k + 0.5)/8)
              for i in range(8) for j in range(8) for k in range(8)]
    for name, effects in (("on", ALONE), ("off", OFF), ("all effects", ALONE.replace(" off;", " on;"))):
        run = bench.run(Wave(f"momentum, {name}", Box((edge,)*3, (8,)*3), GRAIN, lawName="Stokes",
                             positions=places, effects=effects, deltaT=5e-5, subSteps=4, endTime=1e-3),
                        impulse=math.inf)
        first, last = run.budget()[0], run.budget()[-1]
        total = [air[2] + grains[2] - owed[2] for _, air, grains, owed in (first, last)]
        bench.equal(run, "momentum gained, of the grains'", 0, (total[1] - total[0])/abs(last[2][2]), CONSERVED)


def judgeChoice(bench):
    for name, share in (("auto, less", 0.9), ("auto, more", 1.1)):
        push = share*0.01*GRAIN.density*GRAVITY/OIL.density
        run = bench.run(Channel(name, "", lambda x: push/PUSH*poiseuille(x), push, positions=[(0.3*WIDTH, 0.01, 0.01)],
                                gravity=(0, 0, -GRAVITY), deltaT=1e-5, endTime=3e-5), impulse=math.inf)
        bench.equal(run, "told to be simulated", share > 1, "viscousForce is simulated" in run.log, 0)


def verify(bench):
    judgeMomentum(bench)
    if bench.ranks == 1:
        judgeLag(bench)
    judgeChoice(bench)


if __name__ == "__main__":
    main(verify)
