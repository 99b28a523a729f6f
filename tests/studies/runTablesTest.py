# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of a run that was stopped and went on: one row for each time, those of the later start where both have it."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2]/"studies/measures"))

import coupledRun
import runTables


class Resumed(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = Path(folder.name)

    def write(self, name, *lines):
        path = self.case/"postProcessing"/name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(line + "\n" for line in lines))

    def ratio(self, start, *lines):
        self.write(f"fillingRatio/{start}/fillingRatio.dat", "# Time [s]\tfillingRatio [-]\tparcels [-]", *lines)

    def testLaterStartsReplaceWhatTheyMadeAgain(self):
        self.ratio("0", "1\t0.1\t7", "2\t0.2\t8", "3\t0.9\t9")
        self.ratio("2", "3\t0.3\t10", "4\t0.4\t11", "11\t0.9\t12")
        self.ratio("10", "12\t0.5\t13")                       # after 2 as a number, before it as a word
        self.assertEqual(coupledRun.table(self.case, "fillingRatio", "parcels", "fillingRatio"),
                         [[1, 7, 0.1], [2, 8, 0.2], [3, 10, 0.3], [4, 11, 0.4], [12, 13, 0.5]])

    def testWhatAKillToreIsLeftOutWithWhatCameAfterTheCheckpoint(self):
        self.ratio("0", "1\t0.1\t7", "2\t0.2\t8", "3\t0.")
        self.ratio("2", "3\t0.3\t9")
        self.assertEqual(coupledRun.table(self.case, "fillingRatio", "parcels"), [[1, 7], [2, 8], [3, 9]])

    def testWordsStayWords(self):
        self.write("fillingRatio/0/moments.dat", "# Time [s]\tmoment\tratio", "0.06\tfrontCrossed\t0.2", "", "0.1\tend\t0.3")
        self.write("fillingRatio/0.06/moments.dat", "# Time [s]\tmoment\tratio", "0.2\tend\t0.6")
        self.assertEqual(runTables.joined(self.case, "fillingRatio/*/moments.dat"),
                         [["0.06", "frontCrossed", "0.2"], ["0.2", "end", "0.6"]])

    def testNoTable(self):
        self.assertEqual(runTables.joined(self.case, "p/*/p"), [])
        self.assertEqual(coupledRun.table(self.case, "fillingRatio", "parcels"), [])


if __name__ == "__main__":
    unittest.main()
