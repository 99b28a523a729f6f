# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction and rolling friction are recovered from two angles within the uncertainty that is stated;
what two angles do not determine is refused in one sentence."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
os.environ["OPENBLAS_NUM_THREADS"] = "1"  # more would only wait for each other

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
CALIBRATE = ROOT/"studies/calibrate"
sys.path[:0] = [str(ROOT/"studies/engine"), str(ROOT/"studies/calibration")]

import inversion
import responseSurface
import tableFile
from badInput import BadInput

FRICTION, ROLLING = (0.2, 0.4, 0.6, 0.9), (0.05, 0.15, 0.25, 0.35)
ANGLES = "staticAngle", "dynamicAngle"
HEAD = ("variant,particleDiameter,particleDensity,friction,rollingFriction,{more}ranks,status,packings,"
        "{angle},{angle}.error,seconds\n")


def static(f, r):
    return 10 + 14*f + 40*r - 5*f*f - 40*r*r + 8*f*r


def dynamic(f, r):
    return 14 + 22*f + 20*r - 10*f*f - 15*r*r + 5*f*r


def saturating(f, r):
    """Levels off at high friction, as the angles of rough parcels do."""
    return 20 + 30*r - 2/f - r/f + 0.1/f**2 - 10*r*r


def inLogs(f, r):
    return 40 + 5*np.log(f) + 4*np.log(r) - 0.5*np.log(f)**2 + 0.3*np.log(f)*np.log(r)


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)

    def table(self, angle, law, scatter=0.3, seed=1, packings=3, more="", cell="", change=None):
        """As the study engine writes it: mean and standard error over the packings."""
        random = np.random.default_rng(seed)
        rows = []
        for f in FRICTION:
            for r in ROLLING:
                runs = law(f, r) + scatter*random.standard_normal(packings)
                error = f"{runs.std(ddof=1)/packings**0.5:.10g}" if packings > 1 else ""
                rows.append(f"v,0.0004,7360,{f},{r},{cell}1,ok,{packings},{runs.mean():.10g},{error},9\n")
        path = self.work/f"{angle}.csv"
        text = HEAD.format(angle=angle, more=more) + "".join(rows)
        path.write_text(change(text) if change else text)
        return path

    def question(self, angles, errors, laws=(static, dynamic), axes="plain", known=(), **how):
        surfaces = []
        for number, (angle, law) in enumerate(zip(ANGLES, laws)):
            how["seed"] = how.get("seed", 1) + 1000*number
            table = tableFile.Table(self.table(angle, law, **how))
            surfaces.append(responseSurface.fit(responseSurface.Points(table, table.rows, angle), axes))
        return inversion.Question(surfaces, angles, errors, (FRICTION[0], ROLLING[0]),
                                  (FRICTION[-1], ROLLING[-1]), known)


class Coefficients(Tables):
    truth = np.array([0.5, 0.2])

    def testAreExactWithoutScatter(self):
        angles = static(*self.truth), dynamic(*self.truth)
        found = inversion.answer(self.question(angles, (1e-3, 1e-3), scatter=1e-6))
        np.testing.assert_allclose(found.value, self.truth, atol=1e-6)

    def testAreExactInLogarithms(self):
        laws = inLogs, lambda f, r: 30 + 9*np.log(f) - np.log(r) + 0.2*np.log(r)**2
        found = inversion.answer(self.question([law(*self.truth) for law in laws], (1e-3, 1e-3), laws,
                                               "best", scatter=1e-6))
        np.testing.assert_allclose(found.value, self.truth, atol=1e-6)

    def testAreExactWhereAnglesLevelOff(self):
        laws = saturating, lambda f, r: 40 + 20*r - 4/f + 0.2*r*r/f
        question = self.question([law(*self.truth) for law in laws], (1e-3, 1e-3), laws, "best", scatter=1e-6)
        self.assertEqual([one.over for one in question.surfaces], ["saturating", "saturating"])
        np.testing.assert_allclose(inversion.answer(question).value, self.truth, atol=1e-6)
        np.testing.assert_allclose(question.slopes(self.truth)[0], [2/0.5**2 + 0.2/0.5**2 - 0.2/0.5**3, 30 - 1/0.5 - 4],
                                   rtol=1e-3)

    def testSlopesAreThoseOfTheSurface(self):
        for axes in responseSurface.OVER:
            question = self.question((20, 30), (0.2, 0.3), axes=axes, scatter=3)     # scatter: all terms count
            step = 1e-5*np.eye(2)
            by = np.stack([(question.all(self.truth + h) - question.all(self.truth - h))/2e-5 for h in step], axis=-1)
            np.testing.assert_allclose(question.slopes(self.truth), by, rtol=1e-5)

    def testErrorsAreThoseOfTheSlopes(self):
        """By hand at friction 0.5 and rolling friction 0.2, with surfaces that are as good as exact."""
        angles = static(*self.truth), dynamic(*self.truth)
        found = inversion.answer(self.question(angles, (0.2, 0.3), scatter=1e-6))
        slopes = np.array([[14 - 10*0.5 + 8*0.2, 40 - 80*0.2 + 8*0.5],
                           [22 - 20*0.5 + 5*0.2, 20 - 30*0.2 + 5*0.5]])
        inverse = np.linalg.inv(slopes)
        covariance = inverse@np.diag([0.04, 0.09])@inverse.T
        np.testing.assert_allclose(found.error, np.sqrt(np.diag(covariance)), rtol=1e-3)
        self.assertAlmostEqual(found.correlation, covariance[0, 1]/np.prod(found.error), 3)
        # Nearly linear here: intervals of 1.96 and a region of 2.45 standard errors.
        np.testing.assert_allclose(found.high - found.low, 3.92*found.error, rtol=0.12)
        np.testing.assert_allclose(found.regionHigh - found.regionLow, 4.9*found.error, rtol=0.15)

    def testAKnownFrictionCountsByItsError(self):
        """Weighted least squares by hand: three numbers, of which friction has the slopes 1 and 0."""
        angles = static(*self.truth), dynamic(*self.truth)
        found = inversion.answer(self.question(angles, (0.2, 0.3), known=[(0, 0.5, 0.02)], scatter=1e-6))
        np.testing.assert_allclose(found.value, self.truth, atol=1e-6)
        slopes = np.array([[14 - 10*0.5 + 8*0.2, 40 - 80*0.2 + 8*0.5],
                           [22 - 20*0.5 + 5*0.2, 20 - 30*0.2 + 5*0.5], [1, 0]])
        covariance = np.linalg.inv(slopes.T@np.diag([1/0.04, 1/0.09, 1/0.0004])@slopes)
        np.testing.assert_allclose(found.error, np.sqrt(np.diag(covariance)), rtol=1e-3)
        np.testing.assert_allclose(found.high - found.low, 3.92*found.error, rtol=0.12)
        np.testing.assert_allclose(found.regionHigh - found.regionLow, 4.9*found.error, rtol=0.15)
        # One that is 2 of its errors off pulls the answer by the share of its weight.
        pulled = inversion.answer(self.question(angles, (0.2, 0.3), known=[(0, 0.54, 0.02)], scatter=1e-6))
        self.assertAlmostEqual(pulled.value[0] - 0.5, 0.04*covariance[0, 0]/0.0004, 2)
        # One that all but contradicts the angles has a region as large.
        far = inversion.answer(self.question(angles, (0.2, 0.3), known=[(0, 0.59, 0.02)], scatter=1e-6))
        np.testing.assert_allclose(far.regionHigh - far.regionLow, found.regionHigh - found.regionLow, rtol=0.15)

    def testAKnownFrictionMakesUpForAnglesThatTellTheSame(self):
        same = lambda f, r: static(f, r) + 4
        found = inversion.answer(self.question((static(0.5, 0.2), same(0.5, 0.2)), (0.3, 0.3), (static, same),
                                               known=[(0, 0.5, 0.03)], scatter=0.1))
        np.testing.assert_array_less(np.abs(found.value - self.truth), 3*found.error)
        self.assertLess(found.error[1], 0.02)

    def covered(self, scatter, given, packings, draws=200, axes="plain", friction=None):
        """How often region and intervals hold the truth, with tables and angles drawn anew."""
        random = np.random.default_rng(7)
        exact = np.array([static(*self.truth), dynamic(*self.truth)])
        inRegion, inInterval, refused = 0, np.zeros(2), 0
        for draw in range(draws):
            angles = exact + given*random.standard_normal(2)
            known = [(0, self.truth[0] + friction*random.standard_normal(), friction)] if friction else []
            try:
                found = inversion.answer(self.question(angles, (given, given), scatter=scatter, known=known,
                                                       seed=draw, packings=packings, axes=axes), 400, 51)
            except BadInput:
                refused += 1
                continue
            inRegion += found.holds(self.truth)
            inInterval += (found.low <= self.truth) & (self.truth <= found.high)
        # Three numbers contradict each other at 95 % in one draw of twenty.
        self.assertLessEqual(refused, (0.1 if friction else 0.02)*draws)
        return np.array([inRegion, *inInterval])/(draws - refused)

    def mostlyCovered(self, **how):
        shares = self.covered(**how)
        self.assertGreaterEqual(shares.min(), 0.9, shares)
        self.assertLessEqual(shares.mean(), 0.99, shares)

    def testAreCoveredWhenTheAnglesAreUncertain(self):
        self.mostlyCovered(scatter=0.1, given=0.12, packings=3)

    def testAreCoveredWhenTheTablesAreUncertain(self):
        self.mostlyCovered(scatter=0.4, given=0.02, packings=3)

    def testAreCoveredWithOnePackingOnly(self):
        self.mostlyCovered(scatter=0.2, given=0.1, packings=1, axes="best")

    def testAreCoveredWithAKnownFriction(self):
        self.mostlyCovered(scatter=0.2, given=0.2, packings=3, friction=0.02)


class Refused(Tables):
    def refused(self, wanted, *question, **how):
        with self.assertRaises(BadInput) as caught:
            inversion.answer(self.question(*question, **how))
        sentence = str(caught.exception)
        self.assertRegex(sentence, wanted)
        self.assertNotIn("\n", sentence)

    def testTwoAnglesThatDependOnTheSame(self):
        same = lambda f, r: static(f, r) + 4
        self.refused("The two angles do not determine both friction and rollingFriction: the region of 95 "
                     "% confidence leaves the grid", (static(0.5, 0.2), same(0.5, 0.2)), (0.3, 0.3),
                     (static, same))

    def testLargeErrors(self):
        self.refused("leaves the grid", (static(0.5, 0.2), dynamic(0.5, 0.2)), (3, 3))

    def testAnglesThatNothingOnTheGridGives(self):
        self.refused("No friction and rollingFriction of the grid give both angles: the closest, .* wanted "
                     "are 50 and 20; take a wider grid", (50, 20), (0.3, 0.3))

    def testAKnownFrictionThatContradictsTheAngles(self):
        self.refused(r"No friction and rollingFriction of the grid give the two angles and the friction: the closest, friction "
                     r"0\.\d+, .* wanted are 22.9 and 26.8, and friction 0.8; look at what was measured",
                     (static(0.5, 0.2), dynamic(0.5, 0.2) + 0.4), (0.1, 0.1), known=[(0, 0.8, 0.01)], scatter=0.05)

    def testAKnownFrictionThatIsTooUncertain(self):
        same = lambda f, r: static(f, r) + 4
        self.refused("The two angles and the friction do not determine both .*; give them with smaller errors, run",
                     (static(0.5, 0.2), same(0.5, 0.2)), (0.3, 0.3), (static, same), known=[(0, 0.5, 0.5)])

    def testAnAnswerBeyondTheGrid(self):
        self.refused("leaves the grid|take a wider grid",
                     (static(1.0, 0.2), dynamic(1.0, 0.2)), (0.05, 0.05), scatter=0.05)

    def testTwoAnswers(self):
        """The second angle is highest at friction 0.55, so that 0.4 and 0.7 give the same."""
        hill = lambda f, r: 30 - 60*(f - 0.55)**2
        flat = lambda f, r: 10 + 60*r
        self.refused(r"Two pairs give both angles, friction 0\.(4|39|69|7)\d*, .* and friction 0\.",
                     (hill(0.4, 0.2), flat(0.4, 0.2)), (0.1, 0.1), (hill, flat), scatter=0.05)


class TheCommand(Tables):
    def ended(self, *words, first=None, second=None):
        tables = [first or self.table(ANGLES[0], static, 0.2), second or self.table(ANGLES[1], dynamic, 0.2, 2)]
        given = ["--static", f"{static(0.5, 0.2):.3f}", "0.2", "--dynamic", f"{dynamic(0.5, 0.2):.3f}", "0.2"]
        return subprocess.run([str(word) for word in [CALIBRATE, *tables, *given, *words]],
                              capture_output=True, text=True)

    def refused(self, wanted, *words, **tables):
        found = self.ended(*words, **tables)
        self.assertEqual((found.returncode, found.stdout, len(found.stderr.splitlines())), (2, "", 1),
                         found.stderr)
        self.assertIn(wanted, found.stderr)

    def testTellsBothWithTheirErrors(self):
        found = self.ended("-o", self.work/"answer.json")
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        self.assertRegex(found.stdout, r"(?m)^friction +0\.[45]\d+ +0\.0\d+ +0\.\d+ to 0\.\d+")
        self.assertIn("16 rows (0 without an angle)", found.stdout)
        self.assertNotIn(", friction", found.stdout)
        told = json.loads((self.work/"answer.json").read_text())
        for key, truth in (("friction", 0.5), ("rollingFriction", 0.2)):
            self.assertLess(abs(told["value"][key] - truth), 3*told["error"][key])
            self.assertLess(told["region95"]["low"][key], truth)
            self.assertGreater(told["region95"]["high"][key], truth)

    def testTakesAFrictionThatIsKnown(self):
        errors = []
        for words in ([], ["--friction", "0.5", "0.01"]):
            found = self.ended(*words, "-o", self.work/"answer.json")
            self.assertEqual((found.returncode, found.stderr), (0, ""))
            errors.append(json.loads((self.work/"answer.json").read_text())["error"]["friction"])
        self.assertIn("deg, friction 0.5 +- 0.01", found.stdout)
        self.assertLess(errors[1], 0.01)
        self.assertGreater(errors[0], 2*errors[1])
        self.refused("--friction wants a coefficient and its standard error, both above 0, and has 0.5 and 0", "--friction",
                     "0.5", "0")

    def testTakesTheRowsThatAreAsked(self):
        both = lambda text: text + "".join(line.replace("7360", "8000") for line in
                                           text.splitlines(True)[1:])
        tables = dict(first=self.table(ANGLES[0], static, 0.2, change=both))
        self.refused("The rows of staticAngle.csv differ in particleDensity, which is 7360, 8000: choose one "
                     "by --where particleDensity=VALUE.", **tables)
        self.assertEqual(self.ended("--where", "particleDensity=7360", **tables).returncode, 0)

    def testLeavesOutRowsWithoutAnAngle(self):
        def hole(text):
            rows = text.splitlines(True)
            rows[6] = ",".join(rows[6].split(",")[:6]) + ",failed,0,,,9\n"
            return "".join(rows)
        found = self.ended(first=self.table(ANGLES[0], static, 0.2, change=hole))
        self.assertIn("15 rows (1 without an angle)", found.stdout)

    def testRefusesTablesThatDoNotServe(self):
        self.refused("has no column 'dynamicAngle'", second=self.table(ANGLES[0], static))
        self.refused("8 rows with staticAngle; 9 or more are wanted", first=self.table(
            ANGLES[0], static, change=lambda text: "".join(text.splitlines(True)[:9])))
        self.refused("fewer than 3 values of friction", first=self.table(
            ANGLES[0], static, change=lambda text: text.replace(",0.9,", ",0.2,").replace(",0.6,", ",0.4,")))
        self.refused("of different powders: restitution is 0.5 in the first and 0.3",
                     first=self.table(ANGLES[0], static, more="restitution,", cell="0.5,"),
                     second=self.table(ANGLES[1], dynamic, more="restitution,", cell="0.3,"))
        self.refused("there is a word where a number is wanted", first=self.table(
            ANGLES[0], static, change=lambda text: text.replace("0.35,1,ok", "much,1,ok", 1)))
        self.refused("--static wants an angle between 0 and 90 degrees", "--static", "95", "1")


if __name__ == "__main__":
    unittest.main()
