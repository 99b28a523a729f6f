# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the air sees the surface of a solid: the width of a slot between two solids that stand
anywhere among the cells, by what flows along it when the air is pulled.

Clear, the slot takes Poiseuille's g h^3/(12 nu) per depth, with an error of second order as between
walls of the mesh (A00); full of a frozen bed, of which the solids cut cells as they cut the
air, g h rho alpha^2/K by the drag law. From what flows follows a width; half of what it is too wide,
in cells, is how deep in a solid the air sees its surface. When a cell that was covered by a few per
cent was closed, the clear slot was seen off by -0.26 to 0.48 cells; one with a bed, whose powder had
no place in cut cells and lay closer, or looser, beside them, by -1.4 to 3.4.
"""
import math

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, Powder, gidaspowHuilin

CELL = 0.2e-3  # [m]
ALONG, ACROSS = 4, 10  # cells of the slot, where its solids reach the first and the last of them
BODY = 3  # cells of the mesh in each solid
COVERED = (0.0, 0.25, 0.5, 0.75)  # of the first and the last cell
PULL = 0.05  # on the air [m/s2]
VOID_FRACTION = 0.45
POWDER = Powder(40e-6, 7360.0, Air(1.2, 1.8e-5), law=gidaspowHuilin)
NU = POWDER.air.viscosity/POWDER.air.density


class Slot(Case):
    """Along x, between two solids that both cover a part of the outer cells of the slot."""

    def __init__(self, name, covered, across=ACROSS, **options):
        cells = (ALONG, ALONG, across + 2*BODY)
        box = Box([n*CELL for n in cells], cells, ("periodic", "periodic", ("slip", "slip")))
        super().__init__(name, box, POWDER, airGravity=(PULL, 0, 0), slices="x", **options)
        self.low, self.high = (BODY + covered)*CELL, (BODY + across - covered)*CELL

    @property
    def height(self):
        return self.high - self.low

    def write(self, folder, ranks):
        super().write(folder, ranks)
        beyond = 3*CELL
        x, y, z = self.box.size
        lines = []
        for name, low, high in (("floor", -beyond, self.low), ("roof", self.high, z + beyond)):
            (folder/f"{name}.stl").write_text(
                block((-beyond, -beyond, low), (x + beyond, y + beyond, high)))
            # LIGGGHTS moves a plate of it alone, which must lie in its box.
            (folder/f"{name}Plate.stl").write_text(
                block((0.4*x, 0.4*y, 0.4*z), (0.6*x, 0.6*y, 0.6*z)))
            lines.append(f"fix {name} all mesh/surface file ${{case}}/{name}Plate.stl type 1\n")
        script = folder/"powder.in"
        text = script.read_text()
        script.write_text(text.replace("thermo ", "".join(lines) + "thermo ", 1))
        with open(folder/"constant/couplingProperties", "a") as properties:
            properties.write("solids { floor { surface \"floor.stl\"; } roof { surface \"roof.stl\"; } }\n")

    def flow(self, run):
        """Superficial, along the slot and per depth [m2/s]."""
        return sum(alpha*u[0] for alpha, u in
                   zip(run.field("voidFraction"), run.field("U")))/ALONG**2*CELL


def block(low, high):
    """STL of a box."""
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    corner = [tuple((high if n >> axis & 1 else low)[axis] for axis in range(3)) for n in range(8)]
    facets = []
    for face in faces:
        for three in ((0, 1, 2), (0, 2, 3)):
            vertices = "".join("  vertex {:.12g} {:.12g} {:.12g}\n".format(*corner[face[n]]) for n in three)
            facets.append(f"facet normal 0 0 0\n outer loop\n{vertices} endloop\nendfacet\n")
    return f"solid block\n{''.join(facets)}endsolid block\n"


def clear(bench, covered, across=ACROSS):
    slot = Slot(f"clear, {covered:g} of {across} cut", covered, across, deltaT=5e-3,
                endTime=40e-4*across**2)
    run = bench.run(slot, impulse=0)
    seen = (slot.flow(run)*12*NU/PULL)**(1/3)
    bench.equal(run, "surface seen too deep by [cells]", 0, (seen - slot.height)/(2*CELL),
                0.4*CELL/slot.height)


def full(bench, covered, perCell, smoothing):
    """`perCell`: parcels along the edge of a cell. `smoothing`: width, in cells."""
    spacing = CELL/perCell
    k = spacing*(6/math.pi*(1 - VOID_FRACTION))**(1/3)/POWDER.diameter
    slot = Slot(f"bed, {covered:g} cut, smoothed {smoothing:g}", covered, k=k, motion="frozen",
                deltaT=1e-3, subSteps=4000, endTime=5e-3, timeStep="stabilityLimit 1000;",
                smoothingWidth=smoothing*CELL)
    slot.positions = [((i + 0.5)*spacing, (j + 0.5)*spacing, slot.low + (n + 0.5)*spacing)
                      for n in range(round(slot.height/spacing))
                      for j in range(ALONG*perCell) for i in range(ALONG*perCell)]
    pull = POWDER.air.density*PULL  # [Pa/m]
    run = bench.run(slot, impulse=pull*slot.box.volume*slot.deltaT)
    slow = 1e-6  # so that the law is linear [m/s]
    seen = slot.flow(run)*POWDER.slope(VOID_FRACTION, slow)/slow/pull
    bench.equal(run, "surface seen too deep by [cells]", 0, (seen - slot.height)/(2*CELL), 2e-3)


def verify(bench):
    for covered in COVERED:
        clear(bench, covered)
    clear(bench, 0.5, 2*ACROSS)
    for covered in COVERED:
        full(bench, covered, 4, 0)
        full(bench, covered, 2, 2)


if __name__ == "__main__":
    main(verify)
