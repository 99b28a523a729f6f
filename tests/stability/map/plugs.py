# SPDX-License-Identifier: GPL-3.0-or-later
"""A plug of powder over a closed cavity of air, as wide as a few cells, in any corner of the
parameters.

The air below must leave through the plug. With alpha its void fraction and beta the drag per volume
of bed and slip, a small disturbance of the plug dies away within

    tau_eff = alpha^2 alpha_p rho_p/beta

to which a coupling step is compared. The plug ends at v = g' tau_eff, with g' gravity less buoyancy;
free grains, of which some rain from it, never outrun their free fall. Air that they displace leaves
through the gaps: no faster than the powder over the least void fraction. Gravity is lowered where the
plug would leave its column before the run ends: it sets the speeds and nothing of what can swing.
"""
import math
import random

from hardCase import GRAVITY, Air, Box, Case, Powder, change
from harness.laws import root

FLOOR, DRAG_FLOOR = 0.3, 0.36  # of the void fraction on the mesh and in the drag law: the defaults
DIAMETER = 40e-6  # of a grain [m]
STEPS = 60  # of a run, at least
RESPONSES = 10  # of a run, at least
SUBSTEPS = 10
CHOSEN = 0.2  # share of the response time that the solver chooses
ROOM, ROOM_FREE = 6, 3  # cells that a plug may travel; of free grains some rain ahead of it
JITTER = 0.2  # of free grains, in lattice spacings
LAYERS, LAYERS_FREE = 24, 6  # cells of a plug, but at least three parcels
# The fastest grain's speed in a file, so many DEM steps apart.
WATCH = """
variable        pace atom sqrt(vx*vx+vy*vy+vz*vz)
compute         fast all reduce max v_pace
fix             fastest all ave/time 1 1 {} c_fast file ${{case}}/fastest.txt
"""


def response(powder, void):
    """tau_eff as the solver has it, which knows no void fraction below its floors [s]."""
    return max(void, FLOOR)**2*powder.density/powder.B(max(void, DRAG_FLOOR), 0)


class Lattice:
    """Where parcels of diameter d stand, to fill 1 - void of a column. d over the cell is what the
    lattice makes of the wish: a whole number of parcels on a cell's edge, or of cells between them.
    With no wish there are two on each edge, and all cells of a plug are alike."""

    def __init__(self, void, diameter, ratio, width, layers):
        self.spacing = (math.pi/6/(1 - void))**(1/3)*diameter
        wish = ratio*self.spacing/diameter if ratio else 0.5  # spacing in cells
        perCell, between = max(1, round(1/wish)), max(1, round(wish))
        self.cell = self.spacing*perCell/between
        self.ratio = diameter/self.cell
        self.across = max(1, width*perCell//between)  # parcels
        self.cells = self.across*between//perCell
        self.layers = max(3, layers*perCell//between)
        self.height = -(-self.layers*between//perCell)  # of the plug in cells

    def positions(self, bottom, jitter):
        chance = random.Random(11)

        def shifted(i):
            return (i + 0.5 + jitter*chance.uniform(-1, 1))*self.spacing
        edge = self.across*self.spacing
        return [(shifted(i) % edge, shifted(j) % edge, bottom + shifted(k))
                for k in range(self.layers) for j in range(self.across) for i in range(self.across)]


def plug(name, stiffness=CHOSEN, density=6000, void=0.4, k=4, ratio=None, width=1, tied=True,
         smoothing=0.0, chosen=False, lifted=False):
    """density is that of the powder over that of the air; stiffness the step in response times, fixed
    unless it is chosen; lifted: no step is refused."""
    air = Air()
    powder = Powder(DIAMETER, density*air.density, air)
    tau = response(powder, void)
    dt = stiffness*tau
    end = dt*max(STEPS, math.ceil(RESPONSES/stiffness))
    grid = Lattice(void, k*DIAMETER, ratio, width, LAYERS if tied else LAYERS_FREE)
    room = ROOM if tied else ROOM_FREE
    cavity = (1 if tied else 4)*room + 2*math.ceil(max(1, grid.ratio))
    cells = (grid.cells, grid.cells, cavity + grid.height + ROOM)
    pull = min(GRAVITY, room*grid.cell/(tau*end)/(1 - 1/density))
    box = Box(tuple(n*grid.cell for n in cells), cells,
              ("periodic", "periodic", ("noSlip", "outlet")))
    case = Case(name, box, powder, k=k, effects="virtualMass off;", motion="tied" if tied else "free", minimum=FLOOR,
                gravity=(0, 0, -pull), airGravity=(0, 0, -pull), adjustTimeStep=chosen, deltaT=dt,
                subSteps=SUBSTEPS, endTime=end, writeInterval=end,
                smoothingWidth=smoothing*k*DIAMETER,
                positions=grid.positions(cavity*grid.cell, 0 if tied else JITTER))
    if lifted:
        case.timeStep = "stabilityLimit 1e9;"
    watchFastest(case)
    case.mass = len(case.positions)*math.pi/6*case.diameter**3*powder.density
    pull *= 1 - 1/density
    case.scale = pull*tau
    case.limit = case.scale if tied else pull*end
    case.airLimit = case.limit/(max(void, FLOOR) if tied else FLOOR)
    if tied and void > FLOOR:
        case.expected = mappedSpeed
    return case


def watchFastest(case, every=1):
    return change(case, "powder.in", "thermo  ", WATCH.format(every) + "thermo  ")


def mappedSpeed(run):
    """Where drag through the layers of the mesh as they are carries the plug's weight [m/s]."""
    powder, height = run.case.powder, run.case.box.cell[2]
    voids = run.layers("voidFraction")
    pull = -run.case.gravity[2]
    weight = sum(1 - a for a in voids)*(powder.density - powder.air.density)*pull*height

    def drop(v):
        return sum((1 - a)*powder.B(max(a, DRAG_FLOOR), v/a)*v/a**2 for a in voids)*height
    return root(lambda v: drop(v) - weight, 0, 1e3)
