# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a study's table say what they should; what cannot be drawn gets a sentence."""
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True

from toyCase import FIGURE, ROOT, ToyCase

sys.path.insert(0, str(ROOT/"studies/engine"))

import tableFile

HEAD = ("variant,particleDiameter,particleDensity,shoeSpeed,airDensity,airViscosity,dieLength,"
        "dieDepth,mode,ranks,status,packings,fillingRatio,fillingRatio.error,seconds\n")
ROW = "v,{d},{rho},{v},1.25,2e-5,8e-3,5e-3,plain,1,ok,3,{y},0.01,1\n"
ABOUT = """{"fillingRatio": {"kind": "measure", "unit": "1", "shown": "%", "symbol": "δ",
 "text": "filling ratio"}, "shoeSpeed": {"kind": "parameter", "unit": "m/s", "symbol": "v"},
 "particleDensity": {"kind": "parameter", "unit": "kg/m3", "symbol": ""}}"""


class Figures(ToyCase):
    def setUp(self):
        super().setUp()
        rows = [ROW.format(d=d, rho=rho, v=v, y=d*1e4*rho/7000 - v)
                for d in (40e-6, 60e-6, 80e-6) for rho in (3500, 7000) for v in (0.1, 0.2)]
        failed = ROW.format(d=20e-6, rho=7000, v=0.1, y="").replace("0.01,1\n", ",\n")
        self.table = self.work/"table.csv"
        self.table.write_text(HEAD + "".join(rows) + failed)
        (self.work/"columns.json").write_text(ABOUT)

    def figure(self, *options, name="figure"):
        """Status, stderr, and the drawing."""
        ended = subprocess.run([FIGURE, self.table, *options, "-o", self.work/name],
                               capture_output=True, text=True)
        svg = self.work/f"{name}.svg"
        return ended.returncode, ended.stderr, svg.read_bytes() if svg.is_file() else b""

    def words(self, svg):
        """All that is written in a drawing."""
        return "; ".join(re.findall(r"<!-- (.*?) -->", svg.decode()))

    def testHaveALineForEachValueAndErrorBars(self):
        wanted = ["--x", "dpOverHd", "--y", "fillingRatio", "--lines", "shoeSpeed", "--where",
                  "particleDensity=7000"]
        status, error, svg = self.figure(*wanted)
        self.assertEqual((status, error), (0, ""))
        self.assertTrue((self.work/"figure.png").read_bytes().startswith(b"\x89PNG"))
        self.assertGreater((self.work/"figure.png").stat().st_size, 10000)
        for words in ("$d_p/h_D$", "filling ratio $δ$ [%]", "$v$ = 0.1 m/s", "$v$ = 0.2 m/s"):
            self.assertIn(words, self.words(svg))
        for colour in ("#0072b2", "#d55e00"):  # line, bars, caps and three markers
            self.assertGreater(svg.decode().count(colour), 6)
        self.assertTrue(self.figure(*wanted, name="again")[2] == svg, "other bytes")

    def testKnowTheGroups(self):
        """d/h = 60e-6/5e-3, v rho L/mu = 0.1 * 1.25 * 8e-3/2e-5, rho_p/rho_g = 7000/1.25."""
        self.table.write_text(HEAD + ROW.format(d=60e-6, rho=7000, v=0.1, y=0.5))
        table = tableFile.Table(self.table)
        for group, value in (("dpOverHd", 0.012), ("shoeReynolds", 50), ("densityRatio", 5600),
                             ("LdOverHd", 1.6)):
            self.assertAlmostEqual(table.value(table.rows[0], group), value, 9)

    def refused(self, wanted, *options):
        status, error, svg = self.figure(*options)
        self.assertEqual((status, len(error.splitlines()), len(svg)), (2, 1, 0), error)
        self.assertIn(wanted, error)

    def testThatCannotBeDrawn(self):
        y = ("--y", "fillingRatio")
        self.refused("has no column or group 'dpOverH'; did you mean 'dpOverHd'?", "--x", "dpOverH",
                     *y)
        self.refused("they differ in particleDensity: choose by --where or --lines", "--x",
                     "dpOverHd", *y, "--lines", "shoeSpeed")
        self.refused("no row with shoeSpeed=0.3; shoeSpeed is 0.1, 0.2.", "--x", "dpOverHd", *y,
                     "--where", "shoeSpeed=0.3")
        self.refused("--where wants key=value", "--x", "dpOverHd", *y, "--where", "shoeSpeed")
        self.refused("'mode' is no number in table.csv, it is 'plain'", "--x", "mode", *y)
        self.refused("has no number 'fillingRatio' to draw", "--x", "dpOverHd", *y, "--where",
                     "particleDiameter=2e-5")
        self.table.write_text(HEAD)
        self.refused("has no rows", "--x", "dpOverHd", *y)
        self.table.unlink()
        self.refused("cannot be read", "--x", "dpOverHd", *y)


if __name__ == "__main__":
    unittest.main()
