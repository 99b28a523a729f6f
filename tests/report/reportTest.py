# SPDX-License-Identifier: GPL-3.0-or-later
"""The report on made-up results: nothing red is lost, and each bad input gets one sentence."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import results
from swarm import swarm

MET = dict(case="plug", quantity="end speed [m/s]", expected=2.0, measured=2.01, error=0.005,
           tolerance=0.01, ranks=1, seconds=1.5, good=True)
MISSED = dict(MET, measured=2.06, error=0.03, good=False)
CURVE = dict(title="falling", x="t [s]", y="v [m/s]", log=False, theory=[[0, 0], [1, 2.0]], measured=[[0.5, 1.01]])
SHOWN = dict(MET, case="coarse", measured=2.2, error=0.1, tolerance=None)


def rows(*some, **changes):
    return [results.Row(**{**row, **changes}) for row in some]


def run(*some, ranks=1):
    return results.Run(f"verification.Plug.np{ranks}", Path("Plug.py"), Path("."),
                       rows(*some, ranks=ranks), 1.0)


class MadeUp(unittest.TestCase):
    """A build folder of which ctest lists the runs np1 and np2 of one test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build = Path(folder.name).resolve()/"build"
        self.out = Path(folder.name)/"out"
        self.build.mkdir()
        (self.build/"solver").touch()
        (self.build/"Plug.py").write_text('"""A plug falls.\n\nIt cannot fall faster."""\n')
        self.known("verification.Plug.np1", "verification.Plug.np2")

    def known(self, *names):
        (self.build/"CTestTestfile.cmake").write_text("".join(
            f'add_test({name} python3 "{self.build}/Plug.py" --solver "{self.build}/solver"'
            f' --work "{self.work(name)}")\n' for name in names))

    def work(self, name):
        return self.build/"tests"/name

    def left(self, ranks, *some, curves=()):
        folder = self.work(f"verification.Plug.np{ranks}")
        folder.mkdir(parents=True, exist_ok=True)
        content = {"test": "Plug", "rows": [{**row, "ranks": ranks} for row in some], "curves": list(curves)}
        (folder/"results.json").write_text(json.dumps(content))
        return folder/"results.json"

    def report(self):
        """Exit code, what went to stderr, and both texts."""
        ended = subprocess.run([HERE/"report", "--build", self.build, "--out", self.out],
                               capture_output=True, text=True)
        texts = [path.read_text() if path.is_file() else "" for path in
                 (self.out/"report.md", self.out/"report.html")]
        return ended.returncode, ended.stderr, *texts


class TheReport(MadeUp):
    def testEndsWithZeroIfAllIsMet(self):
        self.left(1, MET, SHOWN)
        self.left(2, MET, SHOWN)
        code, error, text, page = self.report()
        self.assertEqual((code, error), (0, ""))
        self.assertIn("| plug | end speed [m/s] | 2 | 2.01 | 5.0e-03 | 0.01 | **1**, 2 | 1.5 "
                      "| met |", text)
        self.assertIn("All 2 numbers are met, in 2 runs", text)
        self.assertIn("A plug falls.", page)
        self.assertNotIn('<tr class="missed">', page)

    def testMarksWhatIsMissed(self):
        self.left(1, MET)
        self.left(2, MISSED)
        code, error, text, page = self.report()
        self.assertEqual(code, 1)
        self.assertIn("1 of 2 numbers is missed", text)
        self.assertIn("| **plug** | end speed [m/s] | 2 | 2.06 | 3.0e-02 | 0.01 | 2 | 1.5 "
                      "| **MISSED** |", text)
        self.assertIn('<tr class="missed"><td>plug</td>', page)

    def testOpensWhatIsMissedAmongWhatAlwaysHolds(self):
        always = dict(MET, quantity=results.STANDING[0], expected=0, measured=0, error=0.0,
                      tolerance=0)
        self.left(1, always)
        self.left(2, dict(always, measured=3, error=3, good=False))
        before, _, after = self.report()[2].rpartition("<details>")
        self.assertIn("| 0 | 3 | 3.0e+00 | at most | 2 | 1.5 | **MISSED** |",
                      before.partition("## Every number")[2])
        self.assertIn("| 0 | 0 | 0 | exactly | 1 | 1.5 | met |", after)

    def testMarksATestThatLeftNoResult(self):
        self.left(1, MET)
        code, error, text, page = self.report()
        self.assertEqual(code, 1)
        self.assertIn("1 of 2 runs has left no result", text)
        self.assertIn("| **np2** | no result |", text)
        self.assertIn('<tr class="missed"><td><b>np2</b></td><td>no result</td>', page)

    def testTakesAResultWithoutRowsForNone(self):
        self.left(1, MET)
        self.left(2)
        self.assertEqual(self.report()[0], 1)

    def testShowsANumberThatIsNone(self):
        self.left(1, dict(MET, measured=float("nan"), error=float("nan"), good=False))
        self.left(2, MET)
        code, error, text, page = self.report()
        self.assertEqual((code, "| no number | no number |" in text), (1, True))

    def testTellsDistancesWithTheWordsOfTheTest(self):
        self.left(1, SHOWN)
        self.left(2, dict(SHOWN, case="fine", error=1e-4))
        text = self.report()[2].partition("## Distances")[2].partition("## Every number")[0]
        self.assertIn("| coarse | end speed [m/s] | 2 | 2.2 | 1.0e-01 | shown |", text)
        self.assertIn("It cannot fall faster.", text)
        self.assertNotIn("| fine |", text)

    def testHoldsItsFiguresAndNamesNoFolderOfTheMachine(self):
        self.left(1, MET)
        self.left(2, SHOWN)
        code, error, text, page = self.report()
        self.assertEqual(page.count('src="data:image/png;base64,iVBOR'), 2)
        for name in ("margins.png", "deviations.png"):
            self.assertIn(f"]({name})", text)
            self.assertTrue((self.out/name).is_file())
        self.assertNotIn(str(self.build.parent), text + page)

    def testDrawsTheCurvesOfATestOnce(self):
        self.left(1, MET)
        self.left(2, MET, curves=[CURVE, dict(CURVE, log=True, theory=[[1, 1], [2, 4]], measured=[[1, 1], [2, 5]])])
        code, error, text, page = self.report()
        self.assertEqual((code, error), (0, ""))
        theory = text.partition("## Against theory")[2].partition("## Distances")[0]
        self.assertEqual(theory.count("](Plug.png)"), 1)
        self.assertIn("**Plug**: A plug falls.", theory)
        self.assertTrue((self.out/"Plug.png").read_bytes().startswith(b"\x89PNG"))

    def testTellsThatTheSolverIsYounger(self):
        path = self.left(1, MET)
        self.left(2, MET)
        self.assertNotIn("was built after", self.report()[2])
        later = path.stat().st_mtime + 60
        os.utime(self.build/"solver", (later, later))
        self.assertIn("was built after", self.report()[2])


class BadInput(MadeUp):
    def refused(self, *words):
        code, error, text, page = self.report()
        self.assertEqual((code, text, page), (2, "", ""), error)
        self.assertEqual(len(error.splitlines()), 1, error)
        self.assertFalse(self.out.is_dir() and list(self.out.iterdir()))
        for word in words:
            self.assertIn(word, error)

    def testNoBuildFolder(self):
        self.build = self.build/"none"
        self.refused("does not exist", "./Alltest", "cmake --build")

    def testNotConfigured(self):
        (self.build/"CTestTestfile.cmake").unlink()
        self.refused("no configured build", "./Alltest", "cmake --build")

    def testNotBuilt(self):
        self.left(1, MET)
        (self.build/"solver").unlink()
        self.refused("no solver", "./Alltest", "cmake --build")

    def testNoSuchTests(self):
        self.known("architecture")
        self.refused("no verification test")

    def testBrokenListOfTests(self):
        (self.build/"CTestTestfile.cmake").write_text("add_test(")
        self.left(1, MET)
        self.refused("ctest cannot list the tests", "CTestTestfile.cmake")

    def testNoResultAtAll(self):
        self.refused("left a result", "./Alltest -L")

    def testTorn(self):
        path = self.left(1, MET)
        path.write_text(path.read_text()[:80])
        self.refused("tests/verification.Plug.np1/results.json", "torn")

    def testMissingKeys(self):
        for key in MET:
            with self.subTest(key):
                path = self.left(1, MET, MET)
                content = json.loads(path.read_text())
                del content["rows"][1][key]
                path.write_text(json.dumps(content))
                self.refused(f"'{key}'", "row 2 of tests/verification.Plug.np1/results.json")

    def testBrokenCurves(self):
        for change in ({"theory": 5}, {"measured": [[1]]}, {"measured": [[1, "fast"]]}, {"log": 1}):
            self.left(1, MET, curves=[CURVE, {**CURVE, **change}])
            self.refused("curve 2 of tests/verification.Plug.np1/results.json", "run its test again")

    def testMissingRows(self):
        for content in ('{"test": "Plug"}', '[]', '5', '{"test": "Plug", "rows": [5]}'):
            self.left(1).write_text(content)
            self.refused("results.json", "is missing")

    def testAWordForANumber(self):
        self.left(1, dict(MET, measured="fast"))
        self.refused("'measured'", "'fast'")

    def testAFileWhereTheReportShouldGo(self):
        self.left(1, MET)
        self.out.write_text("")
        self.refused("cannot be written", "--out")


class Folding(unittest.TestCase):
    def testJoinsRanksAndKeepsTheWorst(self):
        line, = results.fold([run(MET), run(dict(MET, error=-0.009), ranks=2),
                              run(MET, ranks=4)])
        self.assertEqual((line.ranks, line.row.error), ([1, 2, 4], -0.009))

    def testComparesErrorsByWhatIsAllowed(self):
        line, = results.fold([run(dict(MET, error=0.009, tolerance=0.1)), run(MET, ranks=2)])
        self.assertEqual(line.row.tolerance, 0.01)

    def testNeverHidesAFailure(self):
        for order in ((MISSED, MET, MET), (MET, MISSED, MET), (MET, MET, MISSED)):
            lines = results.fold([run(row, ranks=n) for row, n in zip(order, (1, 2, 4))])
            self.assertEqual(sorted(line.row.verdict for line in lines), ["MISSED", "met"])

    def testKeepsEachFailureApart(self):
        lines = results.fold([run(MISSED), run(dict(MISSED, error=9.0), ranks=2)])
        self.assertEqual([line.ranks for line in lines], [[1], [2]])

    def testKeepsRowsOfOneRunApart(self):
        self.assertEqual(len(results.fold([run(MET, MET), run(MET, MET, ranks=2)])), 2)


class TheShareThatIsUsed(unittest.TestCase):
    def used(self, **changes):
        row, = rows(MET, **changes)
        return row.kind, row.used

    def testIsTheErrorOverTheTolerance(self):
        self.assertEqual(self.used(error=-0.02, good=False), ("within", 2.0))

    def testOfABound(self):
        bound = dict(tolerance=0, error=0.0, expected=4.0)
        self.assertEqual(self.used(**bound, measured=1.0), ("at most", 0.25))
        self.assertEqual(self.used(**bound, measured=16.0), ("at least", 0.25))
        self.assertEqual(self.used(**bound, measured=4.0), ("exactly", 0.0))
        self.assertEqual(self.used(**dict(bound, expected=-4.0), measured=-1.0),
                         ("at least", 0.25))

    def testIsAboveOneWhenABoundIsMissed(self):
        missed = dict(tolerance=0, good=False)
        self.assertEqual(self.used(**missed, expected=2, measured=3, error=1), ("at most", 1.5))
        self.assertEqual(self.used(**missed, expected=3, measured=2, error=-1), ("at least", 1.5))
        self.assertEqual(self.used(**missed, expected=0, measured=1, error=1)[1], float("inf"))
        self.assertEqual(self.used(**missed, expected=1, measured=float("nan"), error=0)[1],
                         float("inf"))


class Swarm(unittest.TestCase):
    def testLaysPointsAtOnePlaceApartWithinTheStrip(self):
        heights = swarm([0.5]*40)
        self.assertEqual(len(set(heights)), 40)
        self.assertLessEqual(max(map(abs, heights)), 0.4 + 1e-12)


if __name__ == "__main__":
    unittest.main()
