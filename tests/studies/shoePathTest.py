#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shoe's path by a table: where it is at which time, what LIGGGHTS makes of it, and what is refused."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT/"foam_cases/common"), str(ROOT/"foam_cases/dieFilling/scene")]

import shoePath

ROWS = "# there, wait, back, on\ntime, position\n0, 0\n0.03, 0.004\n0.05, 0.004\n0.06, 0.002\n0.1, 0.012\n"
SPEEDS = "time, speed\n0, 0\n0.01, 0.2\n0.03, 0.2\n0.05, -0.1\n"
USUAL = {"shoePath": "none", "shoeSpeed": 0.15, "rampTime": 0.01}


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = Path(folder.name)

    def path(self, text):
        (self.case/"path.csv").write_text(text)
        return shoePath.read(self.case, {**USUAL, "shoePath": "path.csv"})

    def testPositionsAreMetOnStraightLines(self):
        path = self.path(ROWS)
        for time, position in ((0, 0), (0.015, 0.002), (0.04, 0.004), (0.055, 0.003), (0.06, 0.002), (0.1, 0.012), (1, 0.012)):
            self.assertAlmostEqual(path.at(time), position, 12)
        self.assertAlmostEqual(path.when(0.003), 0.0225, delta=2e-5)
        self.assertIsNone(path.when(0.013))
        self.assertEqual(path.end, 0.1)

    def testSpeedsChangeEvenly(self):
        path = self.path(SPEEDS)
        # 1 mm in the ramp, 4 mm at 0.2 m/s, then 0.05 m/s on average over 20 ms; farthest where the speed is zero.
        for time, position in ((0.005, 0.25e-3), (0.01, 1e-3), (0.03, 5e-3), (0.05, 6e-3)):
            self.assertAlmostEqual(path.at(time), position, 12)
        self.assertAlmostEqual(path.farthest()[1], 5e-3 + 0.5*0.2*0.02*2/3, 9)

    def testWithoutATableItIsRampedUp(self):
        path = shoePath.read(self.case, USUAL)
        self.assertAlmostEqual(path.at(0.01), 0.5*0.15*0.01, 12)
        self.assertAlmostEqual(path.at(0.03), 0.15*0.025, 12)
        self.assertAlmostEqual(path.at(path.when(0.01)), 0.01, 12)

    def testLiggghtsMovesByIt(self):
        """Its variable, summed over steps of 0.1 ms."""
        for text in (ROWS, SPEEDS):
            path = self.path(text)
            (self.case/"walk.in").write_text(
                "units si\natom_style granular\nboundary f f f\nnewton off\ncommunicate single vel yes\nregion box block 0 1 0 1 0 1 units box\n"
                "create_box 1 box\nneighbor 0.1 bin\ntimestep 1e-4\n"
                f"variable shoeVelocityFormula index {path.formula()}\nvariable shoeVelocity equal ${{shoeVelocityFormula}}\n"
                "fix E all property/global youngsModulus peratomtype 1e7\n"
                "fix nu all property/global poissonsRatio peratomtype 0.3\n"
                "fix e all property/global coefficientRestitution peratomtypepair 1 0.5\n"
                "fix mu all property/global coefficientFriction peratomtypepair 1 0.5\n"
                "pair_style gran model hertz tangential history\npair_coeff * *\n"
                "create_atoms 1 single 0.5 0.5 0.5\nset group all diameter 0.1 density 1000\nfix move all nve/sphere\n"
                "thermo_style custom step v_shoeVelocity\nthermo 1\nrun 1000\n")
            ended = subprocess.run(["liggghts", "-in", "walk.in", "-log", "none"], cwd=self.case, capture_output=True,
                                   text=True)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            rows = [line.split() for line in ended.stdout.splitlines()]
            speed = {int(row[0]): float(row[1]) for row in rows if len(row) == 2 and row[0].isdigit()}
            gone = sum(1e-4*0.5*(speed[i] + speed[i + 1]) for i in range(round(path.end/1e-4)))
            self.assertAlmostEqual(gone, path.at(path.end), delta=5e-5)

    def testWhatMakesNoSense(self):
        for text, wanted in (("time, positon\n0, 0\n1, 1\n", "Did you mean position"), ("t, position\n0, 0\n1, 1\n", "names its columns"),
                             ("time, position\n0, 0\n1, one\n", "1,one   line 3"), ("time, position\n0, 0\n", "2 to 25"),
                             ("time, position\n0, 0\n1, nan\n", "is two numbers"),
                             ("time, position\n0, 0\n2, 1\n1, 2\n", "must ascend"),
                             ("time, position\n0, 1\n1, 2\n", "begins where it stands")):
            with self.assertRaises(SystemExit) as refused:
                self.path(text)
            self.assertIn(wanted, str(refused.exception), text)
        with self.assertRaises(SystemExit) as refused:
            shoePath.read(self.case, {**USUAL, "shoePath": "system/none.csv"})
        self.assertIn("is not there", str(refused.exception))


if __name__ == "__main__":
    unittest.main()
