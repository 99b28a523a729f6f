# SPDX-License-Identifier: GPL-3.0-or-later
"""What few packings tell together: by tables of ISO 5725-2 and of the GUM, and on drawn numbers."""
import math
import random
import statistics
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2]/"studies/engine"))

import scatter


def rows(variances, packings=3):
    return [(packings, math.sqrt(variance/packings)) for variance in variances]


class Scatter(unittest.TestCase):
    def testIsTakenTogether(self):
        """Errors 0.01 and 0.03 of 3 packings: sqrt((2*3*1e-4 + 2*3*9e-4)/4)."""
        found = scatter.together([(3, 0.01), (3, 0.03), (0, None), (1, None)])
        self.assertAlmostEqual(found.onePacking, 0.0387298, 6)
        self.assertAlmostEqual(found.errors[0], 0.0223607, 6)
        self.assertEqual(found.errors[0], found.errors[1])
        self.assertIsNone(found.errors[2])
        self.assertAlmostEqual(found.errors[3], 0.0387298, 6)

    def testIsTrustedInEachRowThatHasEnough(self):
        found = scatter.together([(10, 0.01), (12, 0.3)])
        self.assertEqual(found.errors, [0.01, 0.3])
        self.assertIsNone(found.onePacking)
        self.assertIsNone(scatter.together([(1, None)]).onePacking)

    def testSetsARowApartAtCochransCriticalValue(self):
        """ISO 5725-2, table of Cochran's test at 1 %: 0.5358 of 10 rows of 3, 0.2654 of 20 rows of 4."""
        for count, packings, critical in ((10, 3, 0.5358), (20, 4, 0.2654)):
            for share, apart in ((critical - 0.001, []), (critical + 0.001, [4])):
                variances = [1.0]*count
                variances[4] = share/(1 - share)*(count - 1)
                self.assertEqual(scatter.together(rows(variances, packings)).apart, apart, (count, share))

    def testOfARowApartIsItsOwn(self):
        """Of two standard errors that are known, 2.283 or 3.31/2 times as much from 3 or 4 packings (GUM, table G.2: 4.53
        and 3.31 at 95.45 %); the others are as they were without it."""
        for packings, wider in ((3, 4.53/2), (4, 3.31/2)):
            found = scatter.together(rows([1, 2, 1e4, 0.5, 1, 1e5], packings))
            self.assertEqual(found.apart, [2, 5])
            self.assertAlmostEqual(found.errors[5], wider*math.sqrt(1e5/packings), delta=1e-3*found.errors[5])
            self.assertAlmostEqual(found.errors[0], math.sqrt(4.5/4/packings), 9)

    def testOfRowsWithoutAnyLeavesTheOthersResolved(self):
        found = scatter.together(rows([0, 0, 4, 0]))
        self.assertEqual((found.apart, found.errors[0], found.errors[3]), ([2], 0, 0))
        self.assertEqual(scatter.together(rows([0, 0, 0])).apart, [])

    def testSetsAlikeRowsApartInOneTableOfAHundred(self):
        random.seed(5)
        drawn = lambda: statistics.variance(random.gauss(0, 1) for _ in range(3))
        tables = [scatter.together(rows([drawn() for _ in range(12)])) for _ in range(1500)]
        share = statistics.fmean(bool(table.apart) for table in tables)
        self.assertTrue(0.004 < share < 0.02, share)


if __name__ == "__main__":
    unittest.main()
