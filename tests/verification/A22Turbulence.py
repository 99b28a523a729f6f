# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulence of the air, by OpenFOAM's k-epsilon model in the equations of the coupled solver.

a  Where nothing feeds it, in air alone or between grains at rest, turbulence decays as the model has it for uniform k
   (S.B. Pope, Turbulent Flows (2000), eq. 10.56-10.57): k = k_0 tau^-n, e = e_0 tau^-(n + 1) with
   tau = 1 + (C_2 - 1) e_0 t/k_0, n = 1/(C_2 - 1), C_2 = 1.92.
b  Its viscosity 0.09 k^2/e = nu_t0 tau^(1 - n) wears down a wave of shear that is too weak to feed it, in both forms that
   the momentum equation has (with the effect viscousForce and without):
   exp(-K^2 (nu t + nu_t0 (k_0/e_0)/(C_2 - 1) (tau^(2 - n) - 1)/(2 - n))), with K^2 = (2 sin(pi/N)/dx)^2 of N cells a wave.
"""
import math

import A20Dispersion as turbulent
from harness.bench import main
from harness.case import Box, fill, lattice
from harness.laws import Powder

C2 = 1.92
N = 1/(C2 - 1)
RMS, MEMORY = 1.0, 1e-2  # of the fluctuations [m/s], Lagrangian time [s]
LASTS = turbulent.MEMORY*MEMORY  # k_0/e_0 [s]
EDGE, CELLS = 0.05, 24
SHEAR = 1e-4  # [m/s]
STEPS = 1000
CLOSE = 2e-3  # first order in time: 1e-3 of k_0/e_0 a step


class Decaying(turbulent.Turbulent):
    """Turbulence and a wave of shear that are left to themselves for k_0/e_0."""

    def __init__(self, name, powder=None, edge=EDGE, cells=(CELLS, 1, 1), shear=SHEAR, **options):
        deltaT = LASTS/STEPS
        self.shear = shear
        super().__init__(name, Box((edge, edge*cells[1]/cells[0], edge*cells[2]/cells[0]), cells), powder, rms=RMS,
                         memory=MEMORY, deltaT=deltaT, endTime=LASTS, **options)

    def write(self, folder, ranks):
        super().write(folder, ranks)
        nx, ny, nz = self.box.cells
        fill(folder/"0/U", "vector", [f"(0 {self.shear*math.sin(2*math.pi*(i + 0.5)/nx):.15g} 0)"
                                      for i in range(nx)]*(ny*nz))


def course(bench, run):
    """k in time."""
    first = 1.5*RMS**2
    bench.curve(run.case.name, "t e_0/k_0", "k/k_0", [(x/50, (1 + (C2 - 1)*x/50)**-N) for x in range(51)],
                [(0, 1), *((float(t)/LASTS, max(run.field("k", t))/first) for t in run.times())])


def judgeEnergy(bench, run):
    tau = C2  # after k_0/e_0
    for name, first, power in (("k", 1.5*RMS**2, N), ("epsilon", 1.5*RMS**2/LASTS, N + 1)):
        for which in (min, max):
            bench.near(run, f"{name}, {which.__name__}, of that at the start", tau**-power, which(run.field(name))/first, CLOSE)


def judgeShear(bench, run):
    start = 0.09*1.5*RMS**2*LASTS
    diffused = run.case.powder.air.viscosity/run.case.powder.air.density*LASTS
    diffused += start*LASTS/(C2 - 1)*(C2**(2 - N) - 1)/(2 - N)
    waves = (2*math.sin(math.pi/CELLS)*CELLS/EDGE)**2
    wave = 2/CELLS*sum(u[1]*math.sin(2*math.pi*(i + 0.5)/CELLS) for i, u in enumerate(run.field("U")))
    bench.near(run, "wave of shear, of that at the start", math.exp(-waves*diffused), wave/SHEAR, CLOSE)


def verify(bench):
    run = bench.run(Decaying("air alone", slices="x", writeInterval=LASTS/10), impulse=0)
    judgeEnergy(bench, run)
    course(bench, run)
    judgeShear(bench, run)
    judgeShear(bench, bench.run(Decaying("viscous force on", slices="x", effects="viscousForce on;"), impulse=0))
    edge, cells = 4e-3, (4, 4, 4)
    powder = Powder(6e-4, 2500.0)
    bed = Decaying("between grains", powder, edge, cells, 0, motion="frozen", positions=lattice(Box((edge,)*3, cells), 1))
    judgeEnergy(bench, bench.run(bed, impulse=0))


if __name__ == "__main__":
    main(verify)
