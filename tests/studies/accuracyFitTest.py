# SPDX-License-Identifier: GPL-3.0-or-later
"""What a measure tends to as a knob gets finer: Richardson's extrapolation, on points whose limit is known."""
import math
import random
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

ROOT = Path(__file__).resolve().parents[2]

sys.path.insert(0, str(ROOT/"studies/engine"))

import accuracyFit


class Richardson(unittest.TestCase):
    def testRecoversTheLimitOfExactData(self):
        """y = 0.6 + C h^p, of cell sizes in metres: h^2 is 1e-7 of y."""
        for order, c in ((1, 83.0), (2, 1.3e5)):
            points = [(h, 0.6 + c*h**order, 0.01) for h in (3e-4, 4e-4, 6e-4, 7.5e-4)]
            fit = accuracyFit.fit(points, order)
            self.assertAlmostEqual(fit.limit, 0.6, 14)
            self.assertAlmostEqual(fit.errorOf(6e-4)[0]/(c*6e-4**order), 1, 11)
            self.assertLess(fit.chiSquare, 1e-20)

    def testTellsErrorsByHand(self):
        """h = 1, 2, 3 with errors 0.1: mean 2, spread 2; C +- 0.1/sqrt(2), y0 +- 0.1 sqrt(1/3 + 2)."""
        fit = accuracyFit.fit([(1, 1.0, 0.1), (2, 2.0, 0.1), (3, 3.0, 0.1)], 1)
        self.assertAlmostEqual(fit.coefficientError, 0.1/math.sqrt(2), 12)
        self.assertAlmostEqual(fit.limitError, 0.1*math.sqrt(7/3), 12)
        self.assertAlmostEqual(fit.between(3, 1)[0], 2, 12)
        self.assertAlmostEqual(fit.between(3, 1)[1], 0.2/math.sqrt(2), 12)

    def testWeighsByErrors(self):
        """A point of a large error hardly counts: the other three lie on 1 + h."""
        points = [(1, 2, 1e-3), (2, 3, 1e-3), (3, 4, 1e-3), (4, 9, 1e3)]
        self.assertAlmostEqual(accuracyFit.fit(points, 1).limit, 1, 6)

    def testHoldsTheLimitWithinTwoErrorsAsOftenAsItShould(self):
        """95.4 % of 2000 draws; 1 % is two standard deviations of that."""
        random.seed(20250714)
        errors = (0.01, 0.02, 0.005, 0.01)
        hits = 0
        for _ in range(2000):
            points = [(h, random.gauss(0.6 + 0.1*h*h, error), error)
                      for h, error in zip((0.5, 1, 1.5, 2), errors)]
            fit = accuracyFit.fit(points, 2)
            hits += abs(fit.limit - 0.6) < 2*fit.limitError
        self.assertTrue(0.94 < hits/2000 < 0.97, hits/2000)

    def testSeesWhenTheOrderIsNotTheOne(self):
        points = [(h, 0.6 + 0.1*h**3, 0.001) for h in (1, 2, 3, 4)]
        fit = accuracyFit.fit(points, 1)
        self.assertFalse(fit.holds)
        self.assertGreater(fit.limitError, 0.02)  # and not the 0.001 of the points
        self.assertTrue(accuracyFit.fit(points, 3).holds)

    def testNeedsThreeValues(self):
        self.assertIsNone(accuracyFit.fit([(1, 1.0, 0.1), (2, 2.0, 0.1), (2, 2.1, 0.1)], 1))

    def testSaysNothingOfErrorsThatAreNotKnown(self):
        fit = accuracyFit.fit([(1, 1.0, None), (2, 2.0, None), (3, 3.1, None)], 1)
        self.assertAlmostEqual(fit.limit, -1/15, 12)
        self.assertEqual((fit.limitError, fit.chiSquare, fit.errorOf(1)[1]), (None, None, None))


if __name__ == "__main__":
    unittest.main()
