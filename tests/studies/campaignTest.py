# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies of a toy case: failures are rows, kills lose nothing, the tables hold hand numbers."""
import json
import os
import random
import subprocess
import sys
import threading
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from toyCase import ROOT, STUDY, ToyCase

sys.path.insert(0, str(ROOT/"studies/engine"))

import oneRun
import tables


class Failures(ToyCase):
    STUDY = ("title: Toy\nvary: {mode: [broken, plain, dumb, short, silent]}\npackings: [2]\n"
             "reference: {mode: plain}\n")

    def testAreRowsWithTheirReasonAndTheOthersGoOn(self):
        status, out, error = self.study(self.STUDY, "--cores", "2")
        self.assertEqual((status, error), (1, ""))
        self.assertEqual([row["status"] for row in self.rows()],
                         ["failed", "ok", "failed", "failed", "ok"])
        reasons = [row["reason"] for row in self.rows("runs.csv")]
        self.assertEqual(reasons, ["ERROR: The powder is wet. where system", "",
                                   "run: it failed without a word", "run: it ended at 0.5 s of 1 s",
                                   ""])
        self.assertIn("5 of 5 done, 3 failed | ", out)
        self.assertRegex(out, r"mode=plain seed 1: filling 12 % in [\d.]+ s")
        self.assertIn("2 runs good, 3 failed, 0 not run", out)
        # A measure that a run does not have is an empty cell.
        self.assertEqual((self.rows()[4]["slope"], self.rows()[4]["packings"]), ("", "1"))
        self.leavesLogsOfFailuresOnly()
        self.areRunAgainWithRetryOnly()

    def leavesLogsOfFailuresOnly(self):
        self.assertEqual(list((self.case/"variants").iterdir()), [])
        kept = sorted(path.parts[-2].split("_")[0] + " " + path.name
                      for path in self.results.glob("study/runs/*/*") if path.name == "logs")
        self.assertEqual(kept, ["modebroken logs", "modedumb logs", "modeshort logs"])
        log, = self.results.glob("study/runs/modebroken_seed2_*/logs/log.toy")
        self.assertIn("The powder is wet", log.read_text())

    def areRunAgainWithRetryOnly(self):
        before = self.ran()
        status, out, _ = self.study(self.STUDY)
        self.assertEqual((status, self.ran()), (1, before))
        self.assertIn("All 5 runs were done before, 3 failed; --retry runs those again", out)
        run = self.case/"run"
        run.write_text(run.read_text().replace("broken)", "mended)"))
        status, _, _ = self.study(self.STUDY, "--retry")
        self.assertEqual(status, 1)
        self.assertEqual([row["status"] for row in self.rows()],
                         ["ok", "ok", "failed", "failed", "ok"])
        again = {name.split(".")[1].split("_")[0] for name in self.ran()[len(before):]}
        self.assertEqual(again, {"modebroken", "modedumb", "modeshort"})


class DryRun(ToyCase):
    def testIntoAPipeThatIsClosedSaysNothing(self):
        """As in `--dry-run | head -1`."""
        reader, writer = os.pipe()
        os.close(reader)
        path = self.write("vary: {shoeSpeed: [0.1, 0.2]}\n")
        ended = subprocess.run([STUDY, path, "--dry-run"], stdout=writer, stderr=subprocess.PIPE, text=True)
        os.close(writer)
        self.assertEqual((ended.stderr, self.ran()), ("", []))


class Reuse(ToyCase):
    def testTakesGoodRunsOfOtherStudiesAndMakesTheOthers(self):
        """Of speed and mode, in other orders: v 0.1 is there, v 0.2 not, broken failed there and runs again."""
        self.study("vary: {mode: [plain, broken], shoeSpeed: [0.1]}\npackings: [1, 2]\nmeasures: [fillingRatio, slope]\n",
                   name="one.yaml")
        before = self.ran()
        self.assertEqual(len(before), 4)
        two = ("vary: {shoeSpeed: [0.1, 0.2], mode: [plain, broken]}\npackings: [1]\nmeasures: [fillingRatio]\n")
        status, out, error = self.study(two, "--reuse")
        self.assertEqual((status, error), (1, ""))
        self.assertIn("1 runs are taken from other studies, 1 of version ", out)
        self.assertIn("4 of 4 done, 2 failed", out)
        self.assertEqual(len(self.ran()) - len(before), 3)
        first = self.rows()[0]
        self.assertEqual((first["shoeSpeed"], first["mode"], first["packings"]), ("0.1", "plain", "1"))
        self.assertAlmostEqual(float(first["fillingRatio"]), 0.11, 9)

    def testTakesNothingThatFailedOrLacksAMeasureOrIsOfAnotherCase(self):
        self.study("packings: [1, 2]\n", name="one.yaml")
        slopeOnly, failed = (self.results/f"one/runs/{run}/result.json" for run in
                             sorted(path.name for path in self.results.glob("one/runs/*")))
        content = json.loads(slopeOnly.read_text())
        slopeOnly.write_text(json.dumps({**content, "measures": {"slope": content["measures"]["slope"]}}))
        failed.write_text(json.dumps({**json.loads(failed.read_text()), "status": "failed"}))
        status, out, _ = self.study("packings: [1, 2]\nmeasures: [slope, fillingRatio]\n", "--reuse", name="two.yaml")
        self.assertEqual((status, len(self.ran())), (0, 4))
        self.assertIn("0 runs are taken", out)
        plans = [self.results/name/"plan.json" for name in ("one", "two")]
        for plan, case in zip(plans, (self.work, self.work/"gone")):
            plan.write_text(json.dumps({**json.loads(plan.read_text()), "case": str(case)}))
        status, out, _ = self.study("packings: [1]\nmeasures: [slope]\n", "--reuse", name="three.yaml")
        self.assertEqual((status, len(self.ran())), (0, 5))
        self.assertIn("0 runs are taken", out)

    def testIsRefusedIfRunsAreKeptOrNoneIsMade(self):
        status, _, error = self.study("packings: [1]\nkeep: yes\n", "--reuse")
        self.assertEqual((status, self.ran()), (2, []))
        self.assertIn("leave out --reuse or 'keep'", error)
        status, _, error = self.study("packings: [1]\n", "--reuse", "--dry-run")
        self.assertEqual(status, 2)
        self.assertIn("--reuse is for studies that run", error)


class Tables(ToyCase):
    def testHoldMeansErrorsAndDifferences(self):
        """fillingRatio = v + seed/100: mean v + 0.02, standard deviation 0.01, error 0.01/sqrt(3);
        a difference is resolved above 2 sqrt(2) 0.01/sqrt(3) = 0.0163."""
        status, _, error = self.study("vary: {shoeSpeed: [0.1, 0.116, 0.117]}\n"
                                      "packings: [1, 2, 3]\nreference: {shoeSpeed: 0.1}\nkeep: yes\nranks: 2\n",
                                      "--cores", "2")
        self.assertEqual((status, error), (0, ""))
        first, near, far = self.rows()
        self.assertAlmostEqual(float(first["fillingRatio"]), 0.12, 9)
        self.assertAlmostEqual(float(far["fillingRatio"]), 0.137, 9)
        for row in (first, near, far):
            self.assertAlmostEqual(float(row["fillingRatio.error"]), 0.005773502692, 9)
            self.assertEqual((row["ranks"], row["particleDiameter"], row["dieDepth"]),
                             ("2", "4e-05", "0.005"))
            self.assertEqual((row["seconds.solver"], row["seconds.solver.error"], row["seconds.DEM"]), ("0.25", "0", "0.125"))
            self.assertGreater(float(row["seconds.error"]), 0)
        self.assertAlmostEqual(float(near["fillingRatio.difference"]), 0.016, 9)
        self.assertAlmostEqual(float(far["fillingRatio.difference"]), 0.017, 9)
        self.assertEqual([row["fillingRatio.resolved"] for row in self.rows()], ["", "no", "yes"])
        self.assertEqual(first["fillingRatio.difference"], "")
        self.assertEqual(first["fillingRatio.pairedError"], "")
        self.assertAlmostEqual(float(far["fillingRatio.pairedError"]), 0, 12)  # the same scatter in both
        self.haveARowForEachRun()
        text = (self.results/"study/table.md").read_text()
        self.assertIn("| shoeSpeed v [m/s] | status | packings | fillingRatio δ [%] |", text)
        self.assertIn("| 0.117 | ok | 3 | **13.7 ± 0.58** | 30 ± 0 |", text)
        self.assertEqual(len(list((self.case/"variants").iterdir())), 9)  # keep
        self.areOfWhatThereIs()

    def testTellTheErrorOfADifferenceFromPairs(self):
        """Three beds, of which the second failed with one speed: 0.1 and 0.4 more, by which they scatter by 0.3/sqrt(2)."""
        runs = [{"variant": variant, "packing": packing} for variant in (0, 1) for packing in (1, 2, 3)]
        results = [{"status": "ok" if value else "failed", "seconds": 1, "measures": {"m": value}}
                   for value in (5.0, 7.0, 9.0, 5.1, None, 9.4)]
        plan = {"runs": runs, "variants": [{"reference": 0}, {"reference": 0}], "measures": ["m"]}
        first, second = tables.summarised(plan, results)
        self.assertEqual(first["differences"]["m"], (None, "", None))
        self.assertAlmostEqual(second["differences"]["m"][2], 0.15)

    def haveARowForEachRun(self):
        rows = self.rows("runs.csv")
        self.assertEqual([row["seed"] for row in rows], 3*["1", "2", "3"])
        self.assertEqual(rows[4]["fillingRatio"], "0.136")
        for key, wanted in (("particles", "7"), ("version.OpenFOAM", "OPENFOAM=1912"),
                            ("version.LIGGGHTS", "3.8.0"), ("seconds.solver", "0.25"),
                            ("seconds.DEM", "0.125")):
            self.assertEqual(rows[0][key], wanted)

    def areOfWhatThereIs(self):
        """--tables-only, with one result gone, and one failed."""
        paths = self.resultFiles()
        paths[0].unlink()
        content = {**json.loads(paths[1].read_text()), "status": "failed", "measures": {}}
        paths[1].write_text(json.dumps(content))
        ran = self.ran()
        path = self.case/"studies/study.yaml"
        ended = subprocess.run([STUDY, path, "--tables-only"], capture_output=True, text=True)
        self.assertEqual((ended.returncode, self.ran()), (1, ran))
        self.assertIn("7 runs good, 1 failed, 1 not run", ended.stdout)
        self.assertIn("partly", [row["status"] for row in self.rows()])


class Kills(ToyCase):
    STUDY = ("vary: {shoeSpeed: [0.1, 0.2], mode: [plain, broken]}\nbase: {pause: 0.2}\n"
             "packings: [1, 2, 3]\nreference: {shoeSpeed: 0.1}\n")
    RUNS = 12

    def testLoseNothing(self):
        """Killed before the first result, then after some more at a random moment, twice."""
        path = self.write(self.STUDY)
        whole = self.work/"whole"
        self.study(self.STUDY, "--cores", "2", "--results", whole)
        (self.case/"ran").unlink()
        seed = random.randrange(10**6)
        chance = random.Random(seed)
        for more in (0, 1, 2):
            had = len(self.resultFiles())
            process = self.started(path, "--cores", "2")
            self.await_(lambda: len(self.ran()) > had and len(self.resultFiles()) >= had + more)
            if not more:
                self.refusesASecond(path)
            time.sleep(chance.uniform(0, 0.3))
            self.assertIsNone(process.poll(), f"ended before the kill, seed {seed}")
            self.killed(process)
            self.allWhole()
        left = self.RUNS - len(self.resultFiles())
        before = len(self.ran())
        self.assertGreater(left, 0, f"seed {seed}")
        self.assertEqual(self.study(self.STUDY, "--cores", "2")[0], 1)  # some are broken
        self.assertEqual(len(self.ran()) - before, left)
        self.assertEqual(self.withoutSeconds(self.results/"study"),
                         self.withoutSeconds(whole/"study"), f"seed {seed}")
        self.assertEqual(list((self.case/"variants").iterdir()), [])

    def await_(self, condition):
        end = time.monotonic() + 30
        while not condition():
            self.assertLess(time.monotonic(), end, "the study does not get on")
            time.sleep(0.02)

    def refusesASecond(self, path):
        ended = subprocess.run([STUDY, path], capture_output=True, text=True)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("Another study process is at work", ended.stderr)


class TheSameRunTwice(ToyCase):
    def testIsMadeOnce(self):
        """As when a cluster's job lives on after its study was killed, and the next one starts it
        again: that waits, and takes the result that is there then."""
        plan = {"study": "study", "case": str(self.case), "bedStore": "", "tree": "", "keep": False}
        run = {"id": "one", "label": "one", "seed": 1, "ranks": 1, "changes": {"pause": "0.3"}}
        both = [threading.Thread(target=oneRun.make, args=(plan, run, self.work/"one"))
                for _ in range(2)]
        for thread in both:
            thread.start()
        for thread in both:
            thread.join()
        self.assertEqual(self.ran(), ["study.one"])
        self.assertEqual(json.loads((self.work/"one/result.json").read_text())["status"], "ok")


class EachRun(ToyCase):
    def testHasAPlaceForTemporariesOfItsOwn(self):
        """In a common one Open MPI's programs, beginning and ending, take each other's folder away."""
        self.study("vary: {mode: [plain]}\npackings: 3\n")
        places = (self.case/"places").read_text().split()
        self.assertEqual(len(set(places)), 3)
        self.assertNotIn("none", places)
        self.assertFalse(any(Path(place).exists() for place in places))


class ABrokenCase(ToyCase):
    def testIsAReasonToo(self):
        """Scripts that cannot start or say nonsense give rows as well."""
        (self.case/"measure").write_text((self.case/"measure").read_text().replace(
            "END { printf", 'END { printf "x"; printf'))
        (self.case/"variant").write_text((self.case/"variant").read_text()
                                         + 'grep -q "^mode  *silent" $folder/system/caseParameters '
                                           '&& rm $folder/run || true\n')
        status, _, _ = self.study("vary: {mode: [plain, silent]}\n")
        self.assertEqual(status, 1)
        reasons = [row["reason"] for row in self.rows("runs.csv")]
        self.assertIn("measure: no JSON object of numbers", reasons[0])
        self.assertIn("run: [Errno 2] No such file or directory: 'run'", reasons[1])


if __name__ == "__main__":
    unittest.main()
