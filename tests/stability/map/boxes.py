# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels with contacts fall in a box of air that is closed on all sides and settle on its floor. What
the powder displaces must flow back through it; the pressure has no level of its own.

No parcel falls faster than freely through the height of the box.
"""
import math

import plugs
from hardCase import GRAVITY, Air, Box, Case, Powder, change
from H05ClosedBox import CONTACTS, WALL

K = 10
DIAMETER = K*plugs.DIAMETER
GAP = 0.05  # between parcels, in diameters
ACROSS = 3  # parcels, at least
STEPS = 24
DEM_STEP = 1.5e-5  # [s]


def box(name, stiffness=plugs.CHOSEN, density=6000, ratio=1, chosen=False, lifted=False):
    """ratio: parcel size over cell size. The step is counted in response times of the powder as it
    starts; as it settles they grow shorter."""
    air = Air()
    powder = Powder(plugs.DIAMETER, density*air.density, air)
    spacing = (1 + GAP)*DIAMETER
    cell = DIAMETER/ratio
    n = max(4, math.ceil(ACROSS*spacing/cell))
    count = int(n*cell/spacing)
    tau = plugs.response(powder, 1 - count**2*(count//2)*math.pi/6*DIAMETER**3/(
        n**2*cell**3*math.ceil((count//2)*spacing/cell)))
    dt = stiffness*tau
    substeps = math.ceil(dt/DEM_STEP)
    size = (n*cell,)*3
    case = Case(name, Box(size, (n,)*3, ("noSlip",)*3), powder, k=K, effects="", gravity=(0, 0, -GRAVITY),
                airGravity=(0, 0, -GRAVITY), minimum=plugs.FLOOR, adjustTimeStep=chosen, deltaT=dt,
                subSteps=substeps, endTime=STEPS*dt)
    case.positions = [tuple((i + 0.5)*spacing for i in site) for site in (
        (i, j, k) for k in range(count//2) for j in range(count) for i in range(count))]
    walls = "".join(WALL.format(axis, side, side*length)
                    for axis, length in zip("xyz", size) for side in (0, 1))
    change(case, "powder.in", "neigh_modify    delay 0 exclude group all all",
           "neigh_modify    delay 0\n" + CONTACTS + walls)
    if lifted:
        case.timeStep = "stabilityLimit 1e9;"
    plugs.watchFastest(case)
    case.mass = len(case.positions)*math.pi/6*DIAMETER**3*powder.density
    case.limit = min(GRAVITY*case.endTime, math.sqrt(2*GRAVITY*size[2]))
    case.airLimit = case.limit/plugs.FLOOR
    case.scale = case.limit
    return case
