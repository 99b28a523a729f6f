# SPDX-License-Identifier: GPL-3.0-or-later
"""The friction of walls in die filling, by LIGGGHTS with the scripts of the case: a parcel that slides on table or
shoe slows down by wallFriction times gravity, and one that grazes another is pushed by the parcels' own friction."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT/"foam_cases/common"), str(ROOT/"foam_cases/dieFilling/scene")]

import numpy as np

import stl
import walls

# Two plates as table and as shoe, a parcel on each; far above, one that flies past another in the middle of a hit.
SCENE = """
include         ${scripts}/powder.in
region          box block -2e-3 12e-3 -6e-3 6e-3 -1e-3 9e-3 units box
create_box      2 box
include         ${scripts}/contacts.in
include         ${scripts}/dieFillingRig.in
create_atoms    1 single 0 -2e-3 2e-4 units box
create_atoms    1 single 0 2e-3 2e-4 units box
create_atoms    1 single 5e-3 -2.001e-4 7e-3 units box
create_atoms    1 single 4.9964e-3 2.001e-4 7e-3 units box
set             group all diameter 4e-4 density ${particleDensity}
set             atom 1*2 vx 0.3
set             atom 4 vx 0.12
set             atom 4 vy -0.03
variable        steps equal ceil(0.02/${step})
run             ${steps}
write_dump      all custom ${case}/end.dump id vx vy modify sort id
"""
MATERIAL = dict(particleDiameter=40e-6, coarseGraining=10, boundaryY="f", particleDensity=7360, youngsModulus=1e8,
                wallYoungsModulus=1e8, poissonsRatio=0.3, restitution=1, wallRestitution=0.5, rollingFriction=0,
                rollingModel="off", place=0)
GRAVITY, TIME = 9.81, 0.02  # [m/s2], [s]; with 0.3 m/s it slides for 2*0.3/(7 mu g) = 0.021 s at mu = 0.4


class WallFriction(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = Path(folder.name)
        for name, y in (("die", (-4e-3, -1e-3)), ("shoe", (1e-3, 4e-3))):
            stl.write(self.case/f"constant/triSurface/{name}.stl", walls.rectangle((-1e-3, 11e-3), y, (0, 0)))

    def ended(self, **friction):
        """Velocities of the four parcels, x and y."""
        (self.case/"scene.in").write_text(SCENE)
        command = ["liggghts", "-in", "scene.in"]
        for key, value in {**MATERIAL, **friction, "case": self.case, "scripts": ROOT/"liggghts_scripts"}.items():
            command += ["-var", key, str(value)]
        done = subprocess.run(command, cwd=self.case, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout[-500:] + done.stderr[-500:])
        return np.loadtxt(self.case/"end.dump", skiprows=9)[:, 1:]

    def testSlowsDownWhatSlidesOnTableAndOnShoe(self):
        velocity = self.ended(friction=0.4, wallFriction=0.2)
        for parcel in (0, 1):
            self.assertAlmostEqual((0.3 - velocity[parcel, 0])/(GRAVITY*TIME), 0.2, delta=0.002)

    def testIsNotThatBetweenParcels(self):
        """While they slide, which they do at 0.12/0.03 > 7/2 * 0.4 (1 + 1), the pushes are as the coefficient.
        The parcels are elastic, as LIGGGHTS adds the tangential damping to what Coulomb's limit holds."""
        velocity = self.ended(friction=0.4, wallFriction=0.2)
        self.assertAlmostEqual(-velocity[2, 0]/velocity[2, 1], 0.4, delta=0.02)

    def testIsThatOfTheParcelsIfNotGiven(self):
        velocity = self.ended(friction=0.3)
        for parcel in (0, 1):
            self.assertAlmostEqual((0.3 - velocity[parcel, 0])/(GRAVITY*TIME), 0.3, delta=0.003)


if __name__ == "__main__":
    unittest.main()
