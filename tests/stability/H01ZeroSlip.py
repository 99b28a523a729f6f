# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains that move with the air, or rest in air at rest: Reynolds number, slip and drag are zero, and
so is the number of grains in most cells. No value may turn into no number. At rest nothing may change.
On the move the mesh sees the grain pass from cell to cell, which stirs the air by at most the grain's
share of a cell; the momentum of both together stays."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent/"verification"))

from harness.bench import main  # noqa: E402
from harness.case import Box, Case  # noqa: E402
from harness.laws import Powder  # noqa: E402

SPEED = 0.1  # [m/s]
SOLVED = 1e-10  # how closely pressure is
powder = Powder()


def verify(bench):
    # One grain, in a corner: on several ranks all but one have neither a grain nor a cell with one.
    box = Box((0.0008, 0.0008, 0.0032), (2, 2, 8))
    for speed in (0.0, SPEED):
        for law in ("GidaspowHuilin", "ErgunWenYu", "DiFelice", "KochHill", "SchillerNaumann",
                    "Stokes"):
            case = Case(f"{law}, {speed:g} m/s", box, powder, positions=[(2e-4, 2e-4, 2e-4)],
                        velocity=(0, 0, speed), U=(0, 0, speed), lawName=law, deltaT=1e-4,
                        endTime=5e-4)
            mass = math.pi/6*case.diameter**3*powder.density
            share = mass/powder.density/math.prod(box.cell)
            run = bench.run(case, impulse=share*mass*SPEED)
            totals = [sum(part[2] for part in row[1:]) for row in run.budget()]
            bench.equal(run, "momentum of both [N s]", totals[0], totals[-1],
                        SOLVED*abs(totals[0]))
            bench.equal(run, "velocity of the grain [m/s]", speed, run.budget()[-1][2][2]/mass,
                        share*speed)
            off = max(abs(u[2] - speed) for u in run.field("U"))
            bench.atMost(run, "change of the air's velocity [m/s]", share*speed, off)


if __name__ == "__main__":
    main(verify)
