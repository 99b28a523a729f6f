# SPDX-License-Identifier: GPL-3.0-or-later
"""What the die's case says of its parcels before a run: how many pass the mouth, and how far they are spread."""
import contextlib
import io
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT/"foam_cases/dieFilling"
sys.path[:0] = [str(ROOT/"foam_cases/common"), str(CASE/"scene")]

import geometry
import parameters


def prepared(**changes):
    """What follows from the case's parameters with some changed; and what is said."""
    p = {**parameters.read(CASE/"system/caseParameters"), **changes}
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        d = geometry.rig(p)
        geometry.powder(p, d, {"die": [], "shoe": []}, None)
    return d, said.getvalue()


class Parcels(unittest.TestCase):
    def testPassTheMouthByBeverloosLaw(self):
        """((8 - 1.4 k d)/(8 - 1.4 d))^2.5, reckoned apart, in mm."""
        for k, d, share in ((4, 40e-6, 0.948), (6, 40e-6, 0.914), (8, 40e-6, 0.881), (10, 40e-6, 0.849), (10, 60e-6, 0.778),
                            (1, 40e-6, 1)):
            found, _ = prepared(coarseGraining=k, particleDiameter=d)
            self.assertAlmostEqual(found["parcelShare"], share, delta=6e-4)
        for k, d in ((200, 40e-6), (2, 8e-3)):  # no parcel passes; no grain either
            self.assertEqual(prepared(coarseGraining=k, particleDiameter=d)[0]["parcelShare"], 0)

    def testAreToldIfTheyLetThroughLess(self):
        self.assertIn("Parcels of 0.4 mm let 85 % of grains' flow through a mouth of 8 mm", prepared()[1])
        self.assertIn("Parcels of 0.4 mm", prepared(air="off")[1])
        self.assertEqual(prepared(coarseGraining=3)[1], "")

    def testAreSpreadFarEnough(self):
        """(2 0.6 + 2.4 0.4)/0.4 = 5.4; with 1.4: 4.4. In the cell of its centre, by smoothing alone."""
        self.assertNotIn("WARNING", prepared()[1])
        self.assertIn("spread over 4.4 of its diameters", prepared(smoothingDiameters=1.4)[1])
        self.assertIn("smoothingDiameters 2 would do", prepared(smoothingDiameters=1.4)[1])
        self.assertIn("spread over 2.4 of its diameters", prepared(deposit="centre")[1])
        self.assertNotIn("WARNING", prepared(deposit="centre", air="off")[1])


if __name__ == "__main__":
    unittest.main()
