# SPDX-License-Identifier: GPL-3.0-or-later
"""The small shoe of H15, empty or filled, ramped to its speed and pushed over a die.

An empty one moves air as fast as itself, and as much flows back past it. Powder in it has the speed of
the shoe and what falling into the die adds. The step is counted in cells that the shoe crosses in it.
"""
import math
import pathlib
import re
import shutil

import plugs
from hardCase import GRAVITY

TEMPLATE = pathlib.Path(__file__).resolve().parent.parent/"movingShoe"
RAMP, TRAVEL = 1.5e-3, 9.75e-3  # [m], at constant speed
# A filled one ends two parcels before its rear wall is over the die's far edge: whether a parcel is caught between these
# two edges, and leaves them several times as fast as the shoe, is chance, at 11 of 24 speeds about 5 m/s.
TRAVEL_FILLED = 8.55e-3  # [m]
LONGEST = 0.01  # [s] of a filled shoe, however slow
BLOCKS = ((9.6, 6.0), (4.8, 6.0), (7.2, 6.0), (4.8, 3.0))  # length and height of the mesh's [mm]
WIDTH = 1.2  # [mm]
GRAIN, K, DENSITY = 30e-6, 10, 7360.0
INSIDE = (-5.1e-3, -1.5e-3)  # of the shoe [m]
FILLED = 3.7e-3  # height of the powder [m]
# Inside the powder's box, or LIGGGHTS has no bin for the corners.
TABLE = ((-11, 0, 0, 0), (0, 0, 0, -3), (0, -3, 4.8, -3), (4.8, -3, 4.8, 0), (4.8, 0, 13, 0))  # [mm]


class Shoe:
    """cell in mm; step in cells that the shoe crosses, or chosen by the solver."""
    motion = "shoe"

    def __init__(self, name, speed, cell=0.6, step=0.1, chosen=False, filled=False, lifted=False):
        self.name, self.speed, self.cell = name, speed, cell
        self.chosen, self.lifted = chosen, lifted
        self.ramp = min(RAMP/speed, LONGEST/2 if filled else math.inf)
        self.endTime = min((RAMP + (TRAVEL_FILLED if filled else TRAVEL))/speed,
                           LONGEST if filled else math.inf)
        self.deltaT = step*1e-3*cell/speed
        self.endTime = math.ceil(self.endTime/self.deltaT)*self.deltaT
        self.positions = parcels() if filled else []
        drop = math.sqrt(2*GRAVITY*(FILLED + 3e-3)) if filled else 0
        self.limit = speed + drop
        self.airLimit = self.limit/plugs.FLOOR if filled else 2*speed

    def write(self, folder, ranks):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(TEMPLATE, folder)
        edit(folder/"system/blockMeshDict", self.mesh)
        edit(folder/"system/controlDict", lambda text: re.sub(
            "writeInterval .*;", f"writeInterval {self.endTime:.12g};", re.sub(
                "endTime  .*;", f"endTime {self.endTime:.12g};", re.sub(
                    "deltaT .*;", f"deltaT {self.deltaT:.12g};", text))).replace(
                        "adjustTimeStep      off", f"adjustTimeStep {'on' if self.chosen else 'off'}"))
        edit(folder/"system/decomposeParDict", lambda text: text.replace(
            "2;", f"{ranks};").replace("(2 ", f"({ranks} "))
        edit(folder/"constant/couplingProperties", self.coupling)
        edit(folder/"shoe.in", self.script)
        (folder/"table.stl").write_text(table())

    def mesh(self, text):
        sizes = iter(BLOCKS)

        def counted(found):
            length, height = next(sizes)
            n = [max(1, round(x/self.cell)) for x in (length, WIDTH, height)]
            return f"{found[1]}({n[0]} {n[1]} {n[2]})"
        return re.sub(r"(hex \([^)]*\) )\([^)]*\)", counted, text)

    def coupling(self, text):
        step = "" if self.positions else f"demStep {self.deltaT/20:.12g};"
        limit = "stabilityLimit 1e9;" if self.lifted else ""
        return text.replace("demStep 5e-6;", step + limit).replace(
            'script "shoe.in";', f'script "shoe.in"; coarseGraining {K};')

    def script(self, text):
        text = text.replace("time<0.01", f"time<{self.ramp:.12g}").replace(
            "time/0.01", f"time/{self.ramp:.12g}").replace(
            "time>=0.01", f"time>={self.ramp:.12g}").replace("0.075*", f"{self.speed/2:.12g}*")
        if not self.positions:
            return text
        atoms = "".join(f"create_atoms 1 single {x:.9g} {y:.9g} {z:.9g} units box\n"
                        for x, y, z in self.positions)
        text = text.replace("neighbor ", f"{atoms}set group all diameter {K*GRAIN} density "
                            f"{DENSITY}\nneighbor ", 1)
        # A faster shoe would squeeze the parcels by more than their contacts are made for.
        stiffness = 5e6*max(1, self.speed/0.5)**2
        text = text.replace("peratomtype 5e6", f"peratomtype {stiffness:g}")
        # Room for what is thrown up, above the mesh and beyond.
        text = text.replace("-12e-3 14e-3", "-12e-3 30e-3").replace("-5e-3 8e-3", "-5e-3 30e-3")
        text = text.replace("n_meshes 1 meshes shoe", "n_meshes 2 meshes shoe table")
        text = text.replace("fix             walls", "fix             table all mesh/surface file "
                            "${case}/table.stl type 1\nfix             pull all gravity 9.81 "
                            "vector 0 0 -1\nfix             walls")
        return text.replace("thermo  ", plugs.WATCH.format(10) + "thermo  ")


def edit(path, change):
    path.write_text(change(path.read_text()))


def parcels():
    d = K*GRAIN
    step = 1.02*d
    across, along = int(WIDTH*1e-3/step), int((INSIDE[1] - INSIDE[0])/step)
    return [(INSIDE[0] + (i + 0.5)*step, -0.5e-3*WIDTH + (j + 0.5)*step, (k + 0.55)*step)
            for k in range(int(FILLED/step)) for j in range(across) for i in range(along)]


def table():
    """The table with its die: strips between two lines across, as triangles."""
    text, y = "solid table\n", 0.5*WIDTH
    for x1, z1, x2, z2 in TABLE:
        corners = ((x1, -y, z1), (x2, -y, z2), (x2, y, z2), (x1, y, z1))
        for three in ((0, 1, 2), (0, 2, 3)):
            text += "facet normal 0 0 0\n outer loop\n" + "".join(
                "  vertex {:g} {:g} {:g}\n".format(*(1e-3*x for x in corners[i]))
                for i in three) + " endloop\nendfacet\n"
    return text + "endsolid table\n"
