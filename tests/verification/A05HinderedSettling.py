# SPDX-License-Identifier: GPL-3.0-or-later
"""A suspension settles in a closed column: what falls must let as much air rise past it.

With drag and pressure force the velocity is alpha times the slip at which B slip = alpha (rho_p -
rho_f) g: a closed form of any drag law; with Wen and Yu's in the Stokes limit it is Richardson and
Zaki's power of 4.65. The grains are a lattice tied into one body, since a free suspension clusters
at once. Nothing fixes the pressure: all sides are closed.
"""
import math

from harness.bench import main
from harness.case import Box, Case, lattice
from harness.laws import Powder

UNIFORM = 2e-2
LAYERS = 100
powder = Powder(20e-6, 3360.0)
LONE = powder.settling(1.0)  # 0.04034 m/s

# Velocity over that of a lone grain, by the solids fraction; the drag law is the blend.
RATIOS = {0.01: 0.9548, 0.05: 0.7894, 0.10: 0.6148, 0.20: 0.3321, 0.30: 0.1396, 0.40: 0.0658,
          0.50: 0.0305}


def column(solids):
    cell = (math.pi/6/solids)**(1/3)*powder.diameter
    box = Box((cell, cell, 2*LAYERS*cell), (1, 1, 2*LAYERS),
              ("periodic", "periodic", "noSlip"))
    response = RATIOS[solids]*LONE/powder.gravity
    pull = (0, 0, -powder.gravity)
    return Case(f"solids {100*solids:g} %", box, powder, motion="tied", gravity=pull,
                airGravity=pull, deltaT=0.1*response, subSteps=5, endTime=8*response,
                positions=lattice(box, 1, (LAYERS//2, LAYERS//2 + LAYERS)))


def verify(bench):
    found = []
    for solids, ratio in RATIOS.items():
        if bench.ranks > 1 and solids not in (0.05, 0.30):
            continue
        assert abs(powder.settling(1 - solids)/LONE - ratio) < 1e-4
        case = column(solids)
        mass = len(case.positions)*math.pi/6*case.diameter**3*powder.density
        run = bench.run(case, impulse=1.1*mass*powder.gravity*case.deltaT)
        found.append((solids, -run.budget()[-1][2][2]/mass/LONE))
        bench.near(run, "velocity over that of a lone grain", ratio, found[-1][1], UNIFORM)
    bench.curve("hindered settling", "solids fraction", "velocity, of a lone grain's", [
        (0.005*i, powder.settling(1 - 0.005*i)/LONE) for i in range(1, 111)], found)


if __name__ == "__main__":
    main(verify)
