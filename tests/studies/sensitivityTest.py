# SPDX-License-Identifier: GPL-3.0-or-later
"""What a result depends on: on tables whose ranking, elasticity and crossings are known, and on some that tell none."""
import contextlib
import csv
import io
import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from program import loaded

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT/"studies/sensitivity"
program = loaded(PROGRAM)  # which makes the modules below known

import sensitivityRank
import tableFile
from accuracyTable import Choices
from badInput import BadInput
from sensitivityRank import Point

BASE = dict(height=0.01, friction=0.5, bed="poured", ramp=0.0)
ABOUT = {"height": {"unit": "m", "symbol": ""}, "ramp": {"unit": "s", "symbol": ""},
         "filling": {"unit": "1", "shown": "%", "symbol": "δ", "text": "filling ratio"},
         "early": {"unit": "1", "shown": "%", "symbol": "δ_e", "text": "filling ratio, early"},
         "slope": {"unit": "deg", "symbol": "θ", "text": "slope"}}


def row(filling, error=0.01, packings=10, status="ok", reference=False, **changes):
    label = " ".join(f"{key}={value}" for key, value in changes.items()) or "base"
    found = {"variant": label, **BASE, **changes, "status": status, "packings": packings}
    for name, value in (("filling", filling), ("early", filling if filling == "" else 0.5*float(filling)),
                        ("slope", 15)):
        found.update({name: value, f"{name}.error": error, f"{name}.difference": "" if reference else 0.1})
    return {**found, "seconds": 60}


# 0.6 at the reference; height to the power 0.5, the bed's word, friction hardly, ramp not at all.
STAR = [row(0.6, reference=True),
        *(row(0.6*math.sqrt(h/0.01), height=h) for h in (0.0025, 0.005, 0.02)),
        row(0.5, bed="tapped"), row(0.63, friction=0.25), row(0.605, friction=1.0), row(0.6, ramp=0.02)]
GRID = [row(0.4 + 10*h + 0.1*mu, reference=h == 0.01 and mu == 0.5, height=h, friction=mu)
        for h in (0.005, 0.01, 0.02) for mu in (0.25, 0.5, 1.0)]


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)

    def write(self, rows):
        (self.work/"columns.json").write_text(json.dumps(ABOUT))
        path = self.work/"table.csv"
        with open(path, "w", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]) if rows else ["variant"])
            writer.writeheader()
            writer.writerows(rows)
        return path

    def choices(self, rows):
        return Choices(tableFile.Table(self.write(rows)), (), ["filling"])

    def ran(self, rows, *words):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            program.main([str(word) for word in (self.write(rows), *words)])
        return [Path(path) for path in out.getvalue().split("\n") if path]


class Swing(Tables):
    def testRanksAsIsKnown(self):
        ranks = sensitivityRank.ranking(self.choices(STAR), "filling")
        self.assertEqual([one.parameter for one in ranks], ["height", "bed", "friction", "ramp"])
        for one, swing in zip(ranks, (0.6*(math.sqrt(2) - 0.5), 0.1, 0.03, 0)):
            self.assertAlmostEqual(one.swing.value, swing, 12)
            self.assertAlmostEqual(one.swing.error, 0.01*math.sqrt(2), 12)
        self.assertEqual([one.verdict for one in ranks], ["resolved", "resolved", "not resolved", "not resolved"])
        self.assertEqual([one.largest.x for one in ranks], [0.0025, "tapped", 0.25, 0.02])
        self.assertAlmostEqual(ranks[1].change.value, -0.1, 12)

    def testNeedsMoreOfMoreValues(self):
        """Tables of the studentized range, infinitely many degrees of freedom: 3.314 and 3.858 at 5 %."""
        self.assertAlmostEqual(sensitivityRank.rangeBelow(3, 3.314), 0.95, 4)
        self.assertAlmostEqual(sensitivityRank.rangeBelow(5, 3.858), 0.95, 4)
        self.assertAlmostEqual(sensitivityRank.rangeOfScatter(2), 2*math.sqrt(2), 5)

    def testOfScatterAloneIsSeldomResolved(self):
        """4.6 % of 2000; two standard deviations of that are 0.9 %. By the rule of two values it would be 27 %."""
        random.seed(5)
        count = 0
        for _ in range(2000):
            points = [Point(x, random.gauss(0.6, 0.01), 0.01) for x in range(1, 6)]
            count += sensitivityRank.Influence("x", points, points[0]).verdict == "resolved"
        self.assertTrue(0.036 < count/2000 < 0.056, count/2000)

    def testIsNotJudgedWithoutErrors(self):
        ranks = sensitivityRank.ranking(self.choices([{**one, "filling.error": ""} for one in STAR]), "filling")
        self.assertEqual((ranks[0].verdict, ranks[0].scatter), ("error not known", None))


class Elasticity(unittest.TestCase):
    def testIsThePowerOfAPowerLaw(self):
        points = [Point(x, 0.6*x**-0.3, 0.01) for x in (0.5, 1, 2, 7)]
        found, holds = sensitivityRank.elasticity(points)
        self.assertAlmostEqual(found.value, -0.3, 12)
        self.assertTrue(holds)

    def testHasTheErrorOfHand(self):
        """ln y = ln 2 over ln x = ln 4; errors 3 and 4 % make 5 %."""
        found, _ = sensitivityRank.elasticity([Point(1, 1, 0.03), Point(4, 2, 0.08)])
        self.assertAlmostEqual(found.value, 0.5, 12)
        self.assertAlmostEqual(found.error, 0.05/math.log(4), 12)

    def testSeesWhatIsNoPowerLaw(self):
        self.assertFalse(sensitivityRank.elasticity([Point(x, y, 0.01) for x, y in ((1, 1), (2, 2), (4, 1))])[1])

    def testIsOfNumbersAboveZero(self):
        of = lambda *points: sensitivityRank.elasticity([Point(x, y, 0.01) for x, y in points])[0]
        self.assertIsNone(of(("off", 1), ("on", 2)))
        self.assertIsNone(of((0, 1), (1, 2)))
        self.assertIsNone(of((1, -1), (2, 2)))
        self.assertAlmostEqual(of((0, 9), (1, 1), (2, 2)).value, 1, 12)


class Target(unittest.TestCase):
    def testLiesBetweenNeighboursAsOfHand(self):
        """From 0.5 at 5 to 0.6 at 10: 0.52 at 6, and hypot(0.8*0.01, 0.2*0.02)/0.02 off."""
        points = [Point(1, 0.45, 0.01), Point(5, 0.5, 0.01), Point(10, 0.6, 0.02)]
        crossing, = sensitivityRank.crossings(points, 0.52)
        self.assertEqual((crossing.low.x, crossing.high.x, crossing.resolved), (5, 10, True))
        self.assertAlmostEqual(crossing.at.value, 6, 12)
        self.assertAlmostEqual(crossing.at.error, math.hypot(0.008, 0.004)/0.02, 12)
        self.assertEqual(sensitivityRank.crossings(points, 0.7), [])

    def testMayBeCrossedTwiceAndByScatter(self):
        points = [Point(1, 0.5, 0.01), Point(2, 0.52, 0.01), Point(3, 0.4, 0.01)]
        self.assertEqual([one.resolved for one in sensitivityRank.crossings(points, 0.51)], [False, True])

    def testIsNotBetweenWords(self):
        self.assertEqual(sensitivityRank.crossings([Point("off", 0.4, 0.01), Point("on", 0.6, 0.01)], 0.5), [])

    def testIsMetWithinTwoErrors(self):
        self.assertTrue(Point(1, 0.52, 0.0101).meets(0.5))
        self.assertFalse(Point(1, 0.52, 0.0099).meets(0.5))
        self.assertFalse(Point(1, 0.5, None).meets(0.5))


class Command(Tables):
    def setUp(self):
        super().setUp()
        import matplotlib
        matplotlib.rcParams["savefig.dpi"] = 50  # enough to compare, and faster

    def same(self, names, rows, *words):
        paths = self.ran(rows, *words, "--out", self.work/"one")
        self.ran(rows, *words, "--out", self.work/"two")
        self.assertEqual([path.name for path in paths], names)
        for path in paths:
            self.assertGreater(path.stat().st_size, 200)
            self.assertEqual(path.read_bytes(), (self.work/"two"/path.name).read_bytes(), path.name)

    def testTellsOfParametersAlone(self):
        self.same(["ranking.csv", "ranking.md", "filling.tornado.png", "filling.tornado.svg", "moments.png",
                   "moments.svg"], STAR, "--target", "filling=0.507", "--moments", "early", "filling")
        words = (self.work/"one/ranking.md").read_text()
        # From 0.6 sqrt(0.5) = 0.42426 at 5 mm to 0.6 at 10 mm.
        for wanted in ("| 1 | height | 2.5 mm to 20 mm (4) | 54.85 ± 1.4 | ", "| +0.5 ± 0.01, resolved |",
                       "The reference is 9.3 ± 1 percentage points above it.",
                       "- height: 50.7 % lies between 5 mm and 10 mm, at 7.35 ± 0.20 mm\n",
                       "- bed: within two errors of it: tapped (50 ± 1 %)\n",
                       "- friction: from 60 ± 1 % to 63 ± 1 %; nearest at 0.5, 9.3 ± 1 percentage points away",
                       "| 4 | ramp | 0 s, 0.02 s | 0 ± 1.4 | 2.8 | not resolved |",
                       "Of 7 changes, scatter alone makes 0.3 that large.",
                       "The moment alone has a swing of 30 ± 1.4 percentage points",
                       "| early | 30 ± 1 % | 15 to 42.43 % | -20.7 ± 1 percentage points |"):
            self.assertIn(wanted, words)
        first = next(csv.DictReader(io.StringIO((self.work/"one/ranking.csv").read_text())))
        self.assertEqual((first["parameter"], first["target.between"], first["swing.verdict"]),
                         ("height", "0.005..0.01", "resolved"))

    def testTellsOfTwoTogether(self):
        self.same(["map.md", "filling.map.png", "filling.map.svg"], GRID, "--target", "filling=0.575")
        words = (self.work/"one/map.md").read_text()
        # 0.4 + 10 h + 0.1 mu; along h at mu = 0.5: 12.5 mm, and hypot(0.75, 0.25)*0.01/10 off.
        for wanted in ("| friction \\ height | 5 mm | 10 mm | 20 mm |", "| 0.25 | 47.5 ± 1 | 52.5 ± 1 | 62.5 ± 1 |",
                       "| friction 0.5 | height | 12.50 ± 0.79 mm |  |",
                       "| height 10 mm | friction | 0.750 ± 0.071 |  |",
                       "| friction 0.25 | height | 15.00 ± 0.71 mm |  |"):
            self.assertIn(wanted, words)

    def refused(self, wanted, rows, *words):
        with self.assertRaises(BadInput) as raised, contextlib.redirect_stdout(io.StringIO()):
            self.ran(rows, *words, "--out", self.work/"none")
        self.assertIn(wanted, str(raised.exception))
        self.assertFalse((self.work/"none").exists())

    def testThatTellsNothing(self):
        bare = [{key: value for key, value in one.items() if "difference" not in key} for one in STAR]
        self.refused("table.csv tells no reference: add 'reference: {}'", bare)
        self.assertTrue(self.ran(bare, "--reference", *(f"{key}={value}" for key, value in BASE.items()), "--out",
                                 self.work/"named"))
        self.refused("no measure 'filing' with its error; did you mean 'filling'?", STAR, "--measures", "filing")
        self.refused("no measure 'filing' with its error", STAR, "--target", "filing=0.5")
        self.refused("--target wants MEASURE=VALUE with a finite number", STAR, "--target", "filling=nan")
        self.refused("--target wants MEASURE=VALUE", STAR, "--target", "filling")
        self.refused("--target has filling twice", STAR, "--target", "filling=0.5", "filling=0.6")
        self.refused("'filling' is 'nan' and must be a finite number", STAR + [row("nan", friction=0.9)])
        self.refused("No parameter of table.csv is varied alone", STAR[:1])
        self.refused("The reference 'base' in table.csv has no good run",
                     [{**STAR[0], "filling": "", "seconds": ""}] + STAR[1:])
        self.refused("--moments wants two measures at least, with the same unit, and has filling [%], slope [deg].",
                     STAR, "--moments", "filling", "slope")
        self.refused("has no rows", [])

    def testOfTwoTogetherLacksNothing(self):
        wanted = ("needs all 9 combinations of height and friction, and table.csv has no value for height 20 mm, "
                  "friction 1")
        self.refused(wanted, GRID[:-1])
        self.refused(wanted, GRID[:-1] + [row("", "", 0, "failed", height=0.02, friction=1.0)])

    def testMayLackSomeValues(self):
        self.ran(STAR + [row("", "", 0, "failed", friction=0.9)], "--out", self.work/"some")
        self.assertIn("Without a value: friction=0.9.", (self.work/"some/ranking.md").read_text())

    def testEndsWithTwo(self):
        ended = subprocess.run([PROGRAM, self.write(STAR[:1]), "--out", self.work/"none"], capture_output=True,
                               text=True)
        self.assertEqual((ended.returncode, len(ended.stderr.splitlines())), (2, 1), ended.stderr)


class Words(unittest.TestCase):
    def testAreMovedApart(self):
        import sensitivityFigures
        self.assertEqual(sensitivityFigures.apart([0, 30], [20, 20]), [0, 30])
        a, b, c = sensitivityFigures.apart([0, 1, 2], [10, 20, 10])
        self.assertAlmostEqual(b - a, 15, 3)
        self.assertAlmostEqual(c - b, 15, 3)


if __name__ == "__main__":
    unittest.main()
