# SPDX-License-Identifier: GPL-3.0-or-later
"""Effects that other files of a case choose, or that nobody can: who left one out that matters is told, once, with the
number.

pressureGradient always on; in a deep column of water at rest, its weight over that of the particles
movingWalls     drag at the speed of a plate that the air does not see, 18 mu v/(rho_p g d^2), above 0.01
turbulence      Reynolds number of the fastest air and the smallest extent of the mesh above 2000
compressibility pressure above 5 % of 101325 Pa
airGravity      density of the fluid above 1 % of the particles'
history         Basset's force over Stokes' drag after one response time, 1.197 sqrt(rho/rho_p), above 0.1
"""
import json
import math
import re

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, GRAVITY, Powder

WATER = Air(1000.0, 1e-3)
KEYS = ("pressureGradient", "movingWalls", "turbulence", "compressibility", "airGravity", "history")
PLATE_SPEED = 0.1  # [m/s]

# Moves along x, across the middle of the box.
PLATE = """solid plate
facet normal 1 0 0
outer loop
vertex 0.002 0.004 0.008
vertex 0.002 0.006 0.008
vertex 0.002 0.004 0.009
endloop
endfacet
endsolid plate
"""
SCRIPT = f"""
fix             plate all mesh/surface file ${{case}}/plate.stl type 1
fix             slide all move/mesh mesh plate linear {PLATE_SPEED} 0 0
"""


class WithPlate(Case):
    """The same with a plate that only the powder would meet."""

    def write(self, folder, ranks):
        super().write(folder, ranks)
        (folder/"plate.stl").write_text(PLATE)
        script = folder/"powder.in"
        script.write_text(script.read_text().replace("thermo ", SCRIPT + "thermo "))


def scene(name, powder, height=0.01, kind=Case, **options):
    edge = 0.01
    sides = ("periodic",)*3 if "U" in options else ("noSlip",)*3
    return kind(name, Box((edge, edge, height), (5, 5, 5), sides), powder, positions=[(edge/2, edge/2, height/2)],
                **{"gravity": (0, 0, -GRAVITY), "deltaT": 1e-6, "endTime": 5e-5, **options})


def verify(bench):
    down = {"airGravity": (0, 0, -GRAVITY)}
    bead = Powder(1e-3, 2500.0, WATER)
    usual = Powder()
    blown = 18*usual.air.viscosity*PLATE_SPEED/(usual.density*GRAVITY*usual.diameter**2)
    for case, wanted in (
            (scene("powder in air", Powder()), {}),
            (scene("plate", usual, kind=WithPlate), {"movingWalls": blown}),
            (scene("plate, too slow for lead", Powder(1e-3, 11340.0), kind=WithPlate), {}),
            (scene("bead in water", bead), {"airGravity": 0.4, "history": 1.197*math.sqrt(0.4)}),
            (scene("less than 2000", Powder(), U=(0, 0, 2.8)), {}),
            (scene("more than 2000", Powder(), U=(0, 0, 3.1)), {"turbulence": 3.1*0.01*1.225/1.7894e-5}),
            (scene("not deep", bead, 0.5, **down), {"history": 1.197*math.sqrt(0.4)}),
            (scene("deep", bead, 0.8, **down), {"history": 1.197*math.sqrt(0.4), "compressibility": 0.8*8.0*980.7/101325})):
        run = bench.run(case, impulse=math.inf)
        for key in KEYS:
            told = re.findall(rf"{key} is off, and would matter: .* is ([0-9.e+-]+), above", run.log)
            bench.equal(run, f"{key}: times told", 1 if key in wanted else 0, len(told), 0)
            if key in wanted and told:
                bench.near(run, f"{key}: number", wanted[key], float(told[0]), 5e-2)  # told in two digits
    effects = json.loads((run.folder/"postProcessing/time.json").read_text())["effects"]
    bench.near(run, "pressureGradient: number", WATER.density/bead.density, effects["pressureGradient"]["number"], 1e-3)


if __name__ == "__main__":
    main(verify)
