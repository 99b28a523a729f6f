# SPDX-License-Identifier: GPL-3.0-or-later
"""Air rises through a bed of grains tied into one body: where does it begin to lift them?

Drag and pressure force carry the bed at the superficial velocity U_mf of its void fraction. A code
that forgets the pressure force would lift it at U_mf/alpha, so these numbers tell the two apart.
The bed is so long that what its two ends look like to the mesh does not count.
"""
import math

from harness.bench import main
from harness.case import Box, Case, lattice
from harness.laws import Air, Powder

ONSET = 5e-3
LAYERS = 300

# name: powder, void fraction, U_mf [m/s]; U_mf/alpha would be 0.03217 and 0.011475
BEDS = {
    "Ergun test": (Powder(1e-3, 2000.0, Air(10.0, 1.5e-3)), 0.451335, 0.014517),
    "die filling": (Powder(), 0.40, 0.0045902)}


def bed(name, share):
    powder, voidFraction, onset = BEDS[name]
    cell = (math.pi/6/(1 - voidFraction))**(1/3)*powder.diameter
    box = Box((cell, cell, (LAYERS + 40)*cell), (1, 1, LAYERS + 40),
              ("periodic", "periodic", ("inlet", "outlet")))
    response = onset/powder.gravity
    pull = (0, 0, -powder.gravity)
    return Case(f"{name}, {share:g} U_mf", box, powder, motion="tied", gravity=pull,
                airGravity=pull, U=(0, 0, share*onset), deltaT=0.1*response, subSteps=5,
                endTime=4*response, positions=lattice(box, 1, (20, 20 + LAYERS)))


def verify(bench):
    for name, (powder, voidFraction, onset) in BEDS.items():
        assert abs(powder.minimumFluidisation(voidFraction)/onset - 1) < 1e-4
        speeds = {}
        for share in (0.98, 1.02):
            case = bed(name, share)
            mass = len(case.positions)*math.pi/6*case.diameter**3*powder.density
            run = bench.run(case, impulse=1.1*mass*powder.gravity*case.deltaT)
            speeds[share] = run.budget()[-1][2][2]/mass
        bench.atMost(run, "velocity of the bed below U_mf [m/s]", 0, speeds[0.98])
        bench.atLeast(run, "velocity of the bed above U_mf [m/s]", 0, speeds[1.02])
        measured = 0.98 - 0.04*speeds[0.98]/(speeds[1.02] - speeds[0.98])
        bench.near(run, "onset of fluidisation [m/s]", onset, measured*onset, ONSET)


if __name__ == "__main__":
    main(verify)
