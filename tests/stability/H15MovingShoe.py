# SPDX-License-Identifier: GPL-3.0-or-later
"""An empty shoe, ramped to 0.15 m/s, crosses a die in still air: the penalised walls must not pump
air, must not leak, and must not make noise, however short the time step.

A wall that covers cells all at once stops their air within one step: its pressure pulses grow like
1/dt. With a ramp whose resistance is counted in 1/dt they still grew by 1.25, 1.30 and 1.35 as the
step was halved from 200 us to 25; with the law of SolidsOnMesh.hpp by 1.10, 1.06, 1.10, to 0.09 Pa,
and by 1.05, 1.05 from 40 us to 10.
"""
import math
import pathlib
import re
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent/"verification"))

from harness.bench import main  # noqa: E402
from harness.case import execute, value  # noqa: E402

SPEED = 0.15  # [m/s]
RAMP = 0.01  # [s]
DENSITY = 1.2  # of the air [kg/m3]
CELL = 0.6e-3  # [m]
FRONT = 1.2e-3*6e-3  # area that the shoe's wall sweeps [m2]
NU = 1.5e-5  # of the air [m2/s]
GRIP = 1e11  # of the walls [1/s], SolidsOnMesh.cpp


class Run:
    """The moving shoe with a time step, on some ranks; what Bench prints of it. `edit` may change
    the case's folder before it runs."""

    def __init__(self, bench, deltaT, edit=lambda folder: None):
        self.name = f"moving shoe, dt {1e6*deltaT:g} us"
        self.case = self
        self.folder = bench.work/f"dt{1e6*deltaT:g}"
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(HERE/"movingShoe", self.folder)
        control = self.folder/"system/controlDict"
        control.write_text(re.sub(r"deltaT .*;", f"deltaT {deltaT};", control.read_text()))
        cut = self.folder/"system/decomposeParDict"
        cut.write_text(cut.read_text().replace("2;", f"{bench.ranks};")
                       .replace("(2 ", f"({bench.ranks} "))
        edit(self.folder)
        execute(self.folder, ["blockMesh"], "log.blockMesh")
        command = [bench.solver]
        if bench.ranks > 1:
            execute(self.folder, ["decomposePar"], "log.decomposePar")
            command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(bench.ranks),
                       bench.solver, "-parallel"]
        log = execute(self.folder, command, "log.demPimpleFoam")
        self.seconds = float(re.findall(r"wall time\s+(\S+)", log)[-1])
        if bench.ranks > 1:
            execute(self.folder, ["reconstructPar"], "log.reconstructPar")

    def table(self, name):
        path, = (self.folder/"postProcessing").glob(f"{name}/0/*")
        return [list(map(float, line.split())) for line in path.read_text().splitlines()
                if not line.startswith("#")]

    def outflow(self):
        """Largest net flux through the open boundary, over what the shoe's wall sweeps."""
        return max(abs(row[1]) for row in self.table("outflow"))/(SPEED*FRONT)

    def noise(self):
        """Largest change of pressure from one step to the next, away from the shoe [Pa]."""
        rows = [row for row in self.table("away") if row[0] > 1.05*RAMP]
        return max(DENSITY*abs(b - a) for old, new in zip(rows, rows[1:])
                   for a, b in zip(old[1:], new[1:]))

    def peak(self):
        """Largest pressure anywhere after the ramp [Pa]."""
        return max(DENSITY*abs(p) for row in self.table("peak") if row[0] > 1.05*RAMP
                   for p in row[1:])

    def field(self, time, name):
        text = (self.folder/time/name).read_text()
        listed = re.search(r"internalField\s+nonuniform\s+List<\w+>\s+\d+\s*\((.*?)\n?\)\s*;", text,
                           re.S)
        return [value(line) for line in listed.group(1).strip().splitlines()]

    def walls(self):
        """Over all states on disk after the ramp: the largest speed of air through cells that are
        quite covered, over the shoe's speed; the largest force along x on the shoe [N]."""
        leak, force = 0.0, 0.0
        for time in ("0.02", "0.03", "0.04", "0.05", "0.06", "0.07"):
            push = 0.0
            for u, covered in zip(self.field(time, "U"), self.field(time, "solid")):
                slip = (u[0] - SPEED, u[1], u[2])
                if covered > 0.999:
                    leak = max(leak, math.hypot(*slip)/SPEED)
                push += DENSITY*held(covered)*slip[0]*CELL**3
            force = max(force, abs(push)) if math.isfinite(push) else push
        return leak, force


def held(covered):
    """How hard the air of a cell is held [1/s], see SolidsOnMesh.hpp."""
    shear = (1/max(0.5 - covered, 0.01) - 1)*max(0.5/max(1 - covered, 1e-6), 1)**2
    return min(NU*shear/CELL**2, GRIP) if covered else 0


def verify(bench):
    peaks = []
    for deltaT in (1e-4, 5e-5):
        run = Run(bench, deltaT)
        bench.atMost(run, "net outflow, of U A", 1e-6, run.outflow())
        bench.atMost(run, "pressure from step to step, away [Pa]", 0.1, run.noise())
        leak, force = run.walls()
        bench.atMost(run, "flux through covered cells, of U A", 1e-3, leak)
        # Stagnation pressure and friction of both walls, generously: ten times rho U^2 A.
        bench.atMost(run, "force on the shoe, of rho U^2 A", 100, force/(DENSITY*SPEED**2*FRONT))
        peaks.append(run.peak())
    bench.atMost(run, "peak pressure, of that at twice the step", 1.1, peaks[1]/peaks[0])


if __name__ == "__main__":
    main(verify)
