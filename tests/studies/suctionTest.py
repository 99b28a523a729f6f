#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Suction through the floor of the die: from when, as OpenFOAM reads it, and what is refused."""
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT/"foam_cases/dieFilling"


class Floors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        tree = Path(folder.name)
        (tree/"liggghts_scripts").symlink_to(ROOT/"liggghts_scripts")
        self.case = tree/"foam_cases/die"
        self.case.mkdir(parents=True)
        (tree/"foam_cases/common").symlink_to(ROOT/"foam_cases/common")
        shutil.copy(CASE/"prepare", self.case)
        for name in ("0", "system", "constant", "scene"):
            shutil.copytree(CASE/name, self.case/name, ignore=shutil.ignore_patterns("polyMesh", "triSurface"))

    def derived(self, **changes):
        """What follows from the case with changed parameters; as `prepare` writes it."""
        loader = SourceFileLoader("prepare", str(self.case/"prepare"))
        prepare = importlib.util.module_from_spec(importlib.util.spec_from_loader("prepare", loader))
        loader.exec_module(prepare)
        path = self.case/"system/caseParameters"
        path.write_text(path.read_text() + "".join(f"{k} {v};\n" for k, v in changes.items()))
        numbers, _ = prepare.derived(prepare.read(), None)
        prepare.parameters.writeDerived(self.case, numbers, 9)
        return numbers

    def openfoam(self, *command):
        done = subprocess.run(command, cwd=self.case, text=True, capture_output=True, env={
            "WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ, "PWD": str(self.case)})
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout

    def floor(self, field):
        return self.openfoam("foamDictionary", f"0/{field}", "-entry", "boundaryField.dieFloor")

    def testItBeginsWhenTheShoeCoversTheDie(self):
        """The inside of its front wall, 2.5 mm before the die's near edge, reaches the far edge, 8 mm beyond: 10.5 mm at
        0.15 m/s, 5 ms late by the ramp."""
        numbers = self.derived(suction=100)
        self.assertAlmostEqual(numbers["suctionFrom"], 10.5e-3/0.15 + 5e-3, 9)
        self.assertAlmostEqual(numbers["suctionHead"], -100/1.225, 9)

    def testOpenfoamReadsIt(self):
        self.derived(suction=100)
        self.openfoam("blockMesh")
        self.assertIn("-81.6", self.floor("p"))
        self.assertIn("pressureInletOutletVelocity", self.floor("U"))
        self.assertRegex((self.case/"constant/polyMesh/boundary").read_text(), r"dieFloor\s*{\s*type\s+patch;")

    def testWithoutItTheFloorIsAWall(self):
        for rig in ({}, {"sliceWidth": 0}):
            self.derived(**rig)
            self.openfoam("blockMesh")
            self.assertIn("zeroGradient", self.floor("p"))
            self.assertIn("noSlip", self.floor("U"))
            boundary = (self.case/"constant/polyMesh/boundary").read_text()
            self.assertRegex(boundary, r"dieFloor\s*{\s*type\s+wall;")

    def testWhatMakesNoSense(self):
        for changes, wanted in (({"suction": -5}, "Turn its sign"), ({"suction": 5, "air": "off"}, "nothing can be sucked"),
                                ({"suction": 5, "dieShape": "stepped"}, "rectangular die"),
                                ({"suction": 5, "shoeLength": 7e-3}, "covers the die")):
            with self.assertRaises(SystemExit) as refused:
                self.setUp()
                self.derived(**changes)
            self.assertIn(wanted, str(refused.exception))


if __name__ == "__main__":
    unittest.main()
