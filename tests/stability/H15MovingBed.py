# SPDX-License-Identifier: GPL-3.0-or-later
"""A wall, the bed on it and all the air move through the cells at one speed: nothing slips, so that
no pressure is needed anywhere, however short the time step and wherever the wall is in a cell.

What is left comes from how the mesh sees the bed, whose surface and whose layer at the wall it smears, and
from the step that covers the last of a cell. As long as cells alone were shared, and what was left of one
held the flux out of it to the wall's speed, the pressure of a cell that closed was 9600 slips, and that
in the bed 1.2.
"""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent/"verification"))

from A23SolidSurface import block  # noqa: E402
from harness.bench import main  # noqa: E402
from harness.case import Box, Case  # noqa: E402
from harness.laws import Air, Powder, gidaspowHuilin  # noqa: E402

CELL = 0.6e-3  # [m]
ACROSS, ALONG = 2, 20  # cells
THICK, BED = 2.5, 6  # cells, of the wall and of the bed on it
FLOOR = 3.3  # of the wall at the start, in cells: its surfaces are in different places of theirs
PER_CELL = 4  # parcels
SPEED = 0.15  # [m/s]
VOID_FRACTION = 0.45
POWDER = Powder(40e-6, 7360.0, Air(1.2, 1.8e-5), law=gidaspowHuilin)
TRAVEL = 2.0  # cells


class Lift(Case):
    def __init__(self, steps):
        box = Box((ACROSS*CELL, ACROSS*CELL, ALONG*CELL), (ACROSS, ACROSS, ALONG),
                  ("periodic", "periodic", ("outlet", "outlet")))
        spacing = CELL/PER_CELL
        deltaT = TRAVEL*CELL/SPEED/steps
        super().__init__(
            f"{steps/TRAVEL:g} steps a cell", box, POWDER, U=(0, 0, SPEED), velocity=(0, 0, SPEED),
            k=spacing*(6/math.pi*(1 - VOID_FRACTION))**(1/3)/POWDER.diameter, motion="prescribed",
            deltaT=deltaT, endTime=steps*deltaT, writeInterval=deltaT, smoothingWidth=1.5*CELL,
            timeStep="stabilityLimit 1000; parcelCourant 1000;")
        self.top = (FLOOR + THICK)*CELL
        self.positions = [((i + 0.5)*spacing, (j + 0.5)*spacing, self.top + (n + 0.5)*spacing)
                          for n in range(BED*PER_CELL)
                          for j in range(ACROSS*PER_CELL) for i in range(ACROSS*PER_CELL)]

    def write(self, folder, ranks):
        super().write(folder, ranks)
        x, y, _ = self.box.size
        beyond = 3*CELL
        (folder/"wall.stl").write_text(
            block((-beyond, -beyond, FLOOR*CELL), (x + beyond, y + beyond, self.top)))
        # LIGGGHTS moves a plate of it alone, which must lie in its box.
        (folder/"plate.stl").write_text(block((0.4*x, 0.4*y, FLOOR*CELL), (0.6*x, 0.6*y, self.top)))
        script = folder/"powder.in"
        script.write_text(script.read_text().replace(
            "thermo ", "fix wall all mesh/surface file ${case}/plate.stl type 1\n"
            f"fix lift all move/mesh mesh wall linear 0. 0. {SPEED}\nthermo ", 1))
        with open(folder/"constant/couplingProperties", "a") as properties:
            properties.write('solids { wall { surface "wall.stl"; } }\n')


def verify(bench):
    slip = POWDER.slope(VOID_FRACTION, VOID_FRACTION*SPEED)*CELL  # what a cell of bed would resist with [Pa]
    for steps in (20, 80):
        case = Lift(steps)
        run = bench.run(case, impulse=math.inf)
        everywhere, inBed = 0.0, 0.0
        for time in run.times()[2:]:
            top = case.top + SPEED*float(time)
            layers = zip(run.pressureLayers(time), run.layers("solid", time))
            for n, (pressure, covered) in enumerate(layers):
                everywhere = max(everywhere, abs(pressure)/slip)
                if covered < 0.5 and (n + 1)*CELL > top:
                    inBed = max(inBed, abs(pressure)/slip)
        bench.atMost(run, "pressure anywhere, of a slip's over a cell", 1, everywhere)
        bench.atMost(run, "pressure in the bed, of a slip's over a cell", 0.1, inBed)


if __name__ == "__main__":
    main(verify)
