# SPDX-License-Identifier: GPL-3.0-or-later
"""Angles of repose are measured from particles as well as their errors say; the scenes' folders offer
what a study wants."""
import json
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT/"studies/calibration"))
sys.path.insert(0, str(ROOT/"studies/engine"))

import scene
import surfaceLine
from studyCase import Case

DIAMETER, DEPTH = 0.4e-3, 3.2e-3


def packed(low, high, tops, seed):
    """Particles at random, as dense as a random cloud gets by rejection, all below the surface
    tops(x): many layers, so that the highest one is as uneven as that of poured powder."""
    random = np.random.default_rng(seed)
    count = int((high - low)*DEPTH*4e-3/DIAMETER**3*0.9)
    x = random.uniform(low, high, count)
    y = random.uniform(0, DEPTH, count)
    z = tops(x) - 0.5*DIAMETER - random.uniform(0, 4e-3, count)
    return x, y, z, np.full(count, 0.5*DIAMETER)


def wedge(left, right, height, seed, base=0.0):
    """A heap with two flanks, in degrees."""
    tangents = [math.tan(math.radians(angle)) for angle in (left, right)]
    ends = -height/tangents[0], height/tangents[1]
    x, y, z, r = packed(*ends, lambda x: height - np.where(x < 0, -tangents[0], tangents[1])*x,
                        seed)
    inside = z > 0.5*DIAMETER
    return x[inside], y[inside], z[inside] + base, r[inside]


def share(found, wanted, within=2):
    """How often |angle - wanted| < within*error."""
    return np.mean([abs(angle - wanted) < within*error for angle, error in found])


class AHeap(unittest.TestCase):
    def testIsFoundWithinItsError(self):
        for angle in (12, 25, 40):
            found = []
            for seed in range(40):
                heap = surfaceLine.heap(*wedge(angle, angle, 6e-3, seed))
                found.append((heap["angle"], heap["error"]))
            angles, errors = np.transpose(found)
            self.assertGreaterEqual(share(found, angle), 0.85, angle)
            # Neither is the error so large that this is no feat, nor is there a bias.
            self.assertLess(errors.mean(), 3*angles.std(ddof=1), angle)
            self.assertLess(abs(angles.mean() - angle), 0.3, angle)

    def testOfUnequalFlanksSaysSo(self):
        heap = surfaceLine.heap(*wedge(25, 33, 8e-3, 1))
        self.assertAlmostEqual(heap["left"], 25, delta=2)
        self.assertAlmostEqual(heap["right"], 33, delta=2)
        self.assertAlmostEqual(heap["angle"], 29, delta=1.5)
        self.assertGreater(heap["error"], 3)
        self.assertAlmostEqual(heap["height"], 8e-3, delta=0.5e-3)

    def testIsTheSameOnAHigherTable(self):
        low, high = (surfaceLine.heap(*wedge(30, 30, 6e-3, 2, base), base)
                     for base in (0.0, 5e-3))
        self.assertAlmostEqual(low["angle"], high["angle"], 9)
        self.assertAlmostEqual(low["height"], high["height"], 9)

    def testIsNotFlatterForAFlatTopAndAFoot(self):
        """The uppermost eighth is missing, and a thin layer lies around."""
        found = []
        for seed in range(8):
            x, y, z, r = wedge(30, 30, 8e-3, seed)
            kept = z < 7e-3
            random = np.random.default_rng(seed)
            n = 4000
            foot = (random.uniform(-22e-3, 22e-3, n), random.uniform(0, DEPTH, n),
                    random.uniform(0, 0.8e-3, n), np.full(n, 0.5*DIAMETER))
            found.append(surfaceLine.heap(*(np.concatenate([own[kept], more]) for own, more in
                                            zip((x, y, z, r), foot)))["angle"])
        self.assertAlmostEqual(np.mean(found), 30, delta=0.6)

    def testTooSmallIsRefused(self):
        with self.assertRaisesRegex(surfaceLine.NoSurface, "6 or more are wanted"):
            surfaceLine.heap(*wedge(30, 30, 1.2e-3, 1))


class ADrum(unittest.TestCase):
    radius = 6e-3

    def frame(self, angle, seed, height=-0.5e-3, curved=0.0):
        slope = math.tan(math.radians(angle))
        return packed(-4.5e-3, 4.5e-3, lambda x: height + slope*x + curved*(x/6e-3)**3, seed)

    def testIsFoundWithinItsError(self):
        means = []
        for start in range(20):
            angles = [surfaceLine.inDegrees(surfaceLine.inDrum(*self.frame(-35, 100*start + i),
                                                               self.radius)[0], 0)[0]
                      for i in range(16)]
            means.append(surfaceLine.meanInTime(angles))
        self.assertGreaterEqual(share(means, -35), 0.85)
        self.assertLess(np.mean([error for _, error in means]), 1)

    def testParticlesInTheAirDoNotCount(self):
        frame = self.frame(-30, 1)
        own, _ = surfaceLine.inDrum(*frame, self.radius)
        flying = np.array([2e-3, 2.1e-3]), np.array([0.4e-3, 1.2e-3]), np.full(2, 5e-3), frame[3][:2]
        more, _ = surfaceLine.inDrum(*(np.concatenate(pair) for pair in zip(frame, flying)),
                                     self.radius)
        bend = abs(math.degrees(math.atan(more) - math.atan(own)))
        self.assertLess(bend, 0.5)

    def testErrorOfAMeanGrowsWithMemory(self):
        """Noise that forgets in tau frames: the error is sqrt((1 + a)/(1 - a)) times as large."""
        random, memory = np.random.default_rng(5), 0.8
        errors, means = [], []
        for _ in range(200):
            series = [random.normal()]
            for _ in range(255):
                series.append(memory*series[-1] + math.sqrt(1 - memory**2)*random.normal())
            mean, error = surfaceLine.meanInTime(series)
            means.append(mean)
            errors.append(error)
        self.assertAlmostEqual(np.mean(errors)/np.std(means), 1, delta=0.2)
        with self.assertRaisesRegex(surfaceLine.NoSurface, "8 or more are wanted"):
            surfaceLine.meanInTime([1.0]*7)


class TheScenes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)
        (self.work/"foam_cases").mkdir()
        (self.work/"studies").mkdir()
        shutil.copytree(ROOT/"liggghts_scripts", self.work/"liggghts_scripts")
        shutil.copytree(ROOT/"studies/calibration", self.work/"studies/calibration")
        shutil.copytree(ROOT/"foam_cases/common", self.work/"foam_cases/common")

    def case(self, name):
        source, target = ROOT/"foam_cases"/name, self.work/"foam_cases"/name
        for part in ("system", "studies"):
            shutil.copytree(source/part, target/part, ignore=lambda *_: ["results"])
        for part in ("variant", "run", "prepare", "measure"):
            shutil.copy(source/part, target/part)
        return target

    def ended(self, *words):
        return subprocess.run([str(word) for word in words], capture_output=True, text=True)

    def testCanBeStudied(self):
        for name, angle in (("staticRepose", "staticAngle"), ("dynamicRepose", "dynamicAngle")):
            case = Case(self.case(name))
            self.assertIn(angle, case.measures)
            for key in ("friction", "rollingFriction", "seed"):
                self.assertIn(key, case.parameters)

    def testGiveLiggghtsEveryNumberItsScriptWants(self):
        for name in ("staticRepose", "dynamicRepose"):
            case = self.case(name)
            self.ended(case/"variant", "other", "friction=0.25", "sliceDiameters=5")
            self.assertEqual(self.ended(case/"variants/other/prepare").stderr, "")
            given = (case/"variants/other/preparation/parameters.in").read_text()
            self.assertRegex(given, r"(?m)^variable +friction index 0\.25$")
            self.assertRegex(given, r"(?m)^variable +halfSlice index 0\.001$")
            known = set(scene.re.findall(r"^variable +(\w+)", given, scene.re.M))
            known |= {"case", "scripts"}
            for script in ("powder", "contacts", "roughParcels", name):
                text = (ROOT/f"liggghts_scripts/{script}.in").read_text()
                known |= set(scene.re.findall(r"^variable +(\w+)", text, scene.re.M))
                wanted = set(scene.re.findall(r"\$\{(\w+)\}", text))
                self.assertEqual(wanted - known, set(), script)

    def testMeasureWhatLiggghtsWrote(self):
        for name, frames in (("staticRepose", ["heap.dump"]),
                             ("dynamicRepose", [f"frame.{i}0.dump" for i in range(9)])):
            case = self.case(name)
            (case/"postProcessing").mkdir()
            for seed, frame in enumerate(frames):
                x, y, z, r = (wedge(30, 30, 6e-3, 7) if name == "staticRepose"
                              else ADrum.frame(ADrum(), -33, seed))
                rows = np.column_stack([np.arange(len(x)), np.ones(len(x)), x, y, z, *[0*x]*3, r])
                with open(case/"postProcessing"/frame, "w") as file:
                    file.write("head\n"*9)
                    np.savetxt(file, rows)
            found = self.ended(case/"measure")
            self.assertEqual(found.stderr, "")
            numbers = json.loads(found.stdout)
            key, wanted = (("staticAngle", 30) if name == "staticRepose" else ("dynamicAngle", 33))
            self.assertAlmostEqual(numbers[key], wanted, delta=2)
            self.assertEqual(list(numbers), list(json.loads(self.ended(case/"measure",
                                                                       "-list").stdout)))

    def testAskForASliceThatDoesNotMeetItself(self):
        case = self.case("dynamicRepose")
        self.ended(case/"variant", "thin", "sliceDiameters=3")
        thin = self.ended(case/"variants/thin/prepare")
        self.assertEqual(thin.returncode, 1)
        self.assertIn("sliceDiameters in system/caseParameters must be a whole number from 4",
                      thin.stderr)
        self.assertIn("found   3", thin.stderr)
        ranks = self.ended(case/"run", "-np", "2")
        self.assertEqual(ranks.returncode, 1)
        self.assertIn("runs on one rank", ranks.stderr)


if __name__ == "__main__":
    unittest.main()
