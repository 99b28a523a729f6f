# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid that the air sees sweeps over grains, as where a wall is thicker for the air than for the
powder: grains that it swallows must not be blown about, however long the step.

The air in a covered cell can hardly move. A grain deposited there makes it move all the same, at
pressures that grow as the wall's resistance: grains at rest were thrown out at 80 m/s, six hundred
times the wall's speed. Nothing here moves faster than the wall, so nothing may push a grain beyond
its speed by much; a grain that is inside feels and does nothing.
"""
import math

from H15MovingShoe import SPEED, Run, main

GRAIN = 3e-4  # diameter of a parcel [m]
BLOCK = [(x, y, z) for x in range(-22, 30, 4) for y in (-4, 0, 4) for z in range(3, 42, 4)]


def putPowder(folder):
    """Parcels at rest in front of the shoe's wall, in it and behind it; nothing holds them, and some
    rise with the air that makes way."""
    atoms = "\n".join(f"create_atoms 1 single {1e-4*x:g} {1e-4*y:g} {1e-4*z:g} units box"
                      for x, y, z in BLOCK)
    script = folder/"shoe.in"
    text = script.read_text().replace("mesh n_meshes 1 meshes shoe", "primitive type 1 zplane 0")
    text = text.replace("neighbor ", f"{atoms}\nset group all diameter {GRAIN} density 7360\n"
                        "neighbor ", 1)
    text = text.replace("thermo  ", """
variable pace atom sqrt(vx*vx+vy*vy+vz*vz)
compute  fast all reduce max v_pace
fix      fastest all ave/time 1 1 20 c_fast file ${case}/fastest
thermo  """, 1)
    script.write_text(text.replace("-5e-3 8e-3 units box", "-5e-3 20e-3 units box"))
    control = folder/"system/controlDict"
    control.write_text(control.read_text().replace(
        "functions\n{", "functions\n{\n    powderBalance { type powderBalance; }", 1))
    properties = folder/"constant/couplingProperties"
    properties.write_text(properties.read_text().replace(
        'script "shoe.in";', 'script "shoe.in"; coarseGraining 10;'))


def verify(bench):
    for deltaT in (1e-4, 2.5e-5):
        run = Run(bench, deltaT, putPowder)
        speeds = [float(line.split()[1]) for line in (run.folder/"fastest").read_text().splitlines()
                  if not line.startswith("#")]
        bench.atMost(run, "fastest grain, of the wall's speed", 5, max(speeds)/SPEED)
        rows = run.table("powderBalance")
        bench.equal(run, "parcels lost", 0, rows[-1][8], 0)
        bench.atLeast(run, "volume inside the solid, of all, at most once", 0.1,
                      max(row[17] for row in rows)/(len(BLOCK)*GRAIN**3*math.pi/6))


if __name__ == "__main__":
    main(verify)
