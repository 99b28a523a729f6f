# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of particles in die filling: closed forms of the log-normal distribution, tables by hand, bad input, and what
LIGGGHTS really pours."""
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True

from bedStoreTest import DieFilling
from toyCase import ROOT

sys.path[:0] = [str(ROOT/"foam_cases/common"), str(ROOT/"foam_cases/dieFilling/scene")]

import sizes

D = 40e-6
LOG_NORMAL = dict(sizeDistribution="logNormal", particleDiameter=D, geometricDeviation=1.3, diameterIs="medianByMass",
                  smallestSize=0.05, largestSize=20.0, sizeClasses=100.0, sizeTable="none")


def logNormal(**changes):
    return sizes.read(None, {**LOG_NORMAL, **changes})


def mean(powder, p, q):
    """d_[p,q] = (sum n d^p/sum n d^q)^(1/(p - q)) of the classes."""
    n, d = powder.numbers(), powder.diameters
    return (np.sum(n*d**p)/np.sum(n*d**q))**(1/(p - q))


def below(shares, diameters, d):
    """Share finer than d: a class spreads about its diameter."""
    middle = np.cumsum(shares) - 0.5*shares
    return np.interp(math.log(d), np.log(diameters), middle)


class ALogNormalDistribution(unittest.TestCase):
    def testHasTheMeansOfTheClosedForm(self):
        """d_[p,q] = d50 exp((p + q)/2 s^2), d50 by number. Classes keep d_[3,0] exactly; others by their fineness."""
        for deviation in (1.2, 1.3, 1.6):
            s2 = math.log(deviation)**2
            powder = logNormal(geometricDeviation=deviation)
            byNumber = D*math.exp(-3*s2)
            for p, q, within in ((3, 0, 1e-6), (3, 2, 2e-3), (4, 3, 2e-3)):
                self.assertAlmostEqual(mean(powder, p, q)/(byNumber*math.exp((p + q)/2*s2)), 1, delta=within)

    def testHasTheMediansOfHatchAndChoate(self):
        """d50 by mass = d50 by number exp(3 s^2): half of the number, and half of the mass, are finer."""
        powder = logNormal(diameterIs="medianByNumber")
        byMass = D*math.exp(3*math.log(1.3)**2)
        self.assertAlmostEqual(below(powder.numbers(), powder.diameters, D), 0.5, delta=0.01)
        self.assertAlmostEqual(below(powder.masses, powder.diameters, byMass), 0.5, delta=0.005)

    def testHasTheSauterMeanWithinItsEnds(self):
        for deviation, count, smallest, largest in (
                (1.1, 2, 0.5, 2.), (1.3, 8, 0.5, 2.), (1.4, 8, 0.7, 3.), (1.8, 20, 0.4, 2.)):
            powder = logNormal(diameterIs="sauterMean", geometricDeviation=deviation, sizeClasses=float(count),
                               smallestSize=smallest, largestSize=largest)
            self.assertAlmostEqual(mean(powder, 3, 2)/D, 1, 10)
            self.assertAlmostEqual(powder.sauter()/D, 1, 10)
            self.assertTrue(smallest*D < powder.diameters[0] and powder.diameters[-1] < largest*D)
            self.assertTrue(np.all(np.diff(powder.diameters) > 0))
            np.testing.assert_allclose(powder.masses, 1/count)

    def testKeepsMassAndNumberOfWhatIsBetweenItsEnds(self):
        """The truncated distribution, integrated on a fine grid: mean volume of all and of the finest class."""
        powder = logNormal(smallestSize=0.7, largestSize=1.5, sizeClasses=5.0)
        x = np.linspace(math.log(0.7*D), math.log(1.5*D), 200001)
        mass = np.exp(-0.5*((x - math.log(D))/math.log(1.3))**2)
        finer = np.cumsum(mass)/mass.sum()
        for part, found in ((finer <= 1, powder.meanVolume()), (finer < 0.2, powder.diameters[0])):
            wanted = (mass[part].sum()/(mass[part]*np.exp(-3*x[part])).sum())**(1/3)
            self.assertAlmostEqual(found/wanted, 1, 4)


class WithTable(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = Path(folder.name)

    def table(self, text, **changes):
        (self.case/"sizes.csv").write_text(text)
        p = {**LOG_NORMAL, "sizeDistribution": "table", "diameterIs": "sauterMean", "sizeTable": "sizes.csv"}
        return sizes.read(self.case, {**p, **changes})


class ATable(WithTable):
    def testTurnsNumberIntoMass(self):
        """As many of 20 as of 40 um: masses 1 to 8; d32 = (8000 + 64000)/(400 + 1600) um."""
        powder = self.table("diameter,numberFraction\n20e-6,0.5\n40e-6,0.5\n", particleDiameter=36e-6)
        np.testing.assert_allclose(powder.masses, (1/9, 8/9))
        self.assertAlmostEqual(powder.sauter(), 36e-6, 15)

    def testTurnsMassIntoNumber(self):
        powder = self.table("# two\ndiameter, massFraction\n20e-6, 0.1111 # fine\n40e-6, 0.8889\n",
                            particleDiameter=36e-6)
        np.testing.assert_allclose(powder.numbers(), (0.5, 0.5), 1e-3)

    def testSpreadsWhatASieveHoldsEvenly(self):
        """Over ln d from 20 to 40 um: d^3 = 3 ln 2/(20^-3 - 40^-3) by mass, (40^3 - 20^3)/(3 ln 2) by number."""
        for column, wanted in (("massFiner", 26.68965), ("numberFiner", 29.97416)):
            powder = self.table(f"diameter,{column}\n10e-6,0\n20e-6,0\n40e-6,1\n", particleDiameter=wanted*1e-6)
            self.assertEqual(len(powder.diameters), 1)
            self.assertAlmostEqual(1e6*powder.diameters[0], wanted, 4)


class BadInput(WithTable):
    def refused(self, call, *words):
        with self.assertRaises(SystemExit) as end:
            call()
        for word in words:
            self.assertIn(word, str(end.exception))
        self.assertNotIn(str(end.exception), ("0", "None"))

    def testOfParameters(self):
        for key, value, words in (
                ("sizeDistribution", "lognormal", "Did you mean logNormal?"),
                ("sizeDistribution", 7.0, "mono, logNormal, table"),
                ("diameterIs", "medianByMas", "Did you mean medianByMass?"),
                ("geometricDeviation", 1.0, "a number above 1"), ("geometricDeviation", 0.5, "a number above 1"),
                ("geometricDeviation", math.nan, "geometricDeviation nan"), ("geometricDeviation", "wide", "wide"),
                ("largestSize", 0.3, "a number above 1"), ("smallestSize", 1.5, "below 1"),
                ("smallestSize", -1.0, "above 0"),
                ("sizeClasses", 2.5, "a whole number"), ("sizeClasses", 1.0, "from 2 to 100")):
            with self.subTest(key=key, value=value):
                self.refused(lambda: logNormal(**{key: value}), key, words)
        self.refused(lambda: logNormal(diameterIs="sauterMean", smallestSize=0.99, geometricDeviation=1.5),
                     "No log-normal", "Lower smallestSize")

    def testOfTables(self):
        for text, words in (
                ("diameter,massFraction\n2e-5,0.5\n4e-5,0.4\n", ("sum to 1", "0.9", "sizes.csv")),
                ("diameter,massFraction\n2e-5,50\n4e-5,50\n", ("not percent",)),
                ("diameter,massFraction\n2e-5,1.5\n4e-5,-0.5\n", ("-0.5", "line 3")),
                ("diameter,massFraction\n2e-5,nan\n4e-5,0.5\n", ("nan", "line 2")),
                ("diameter,massFraction\n20,0.5\n40,0.5\n", ("in metres", "line 2")),
                ("diameter,massFraction\n2e-5,0.5,1\n4e-5,0.5\n", ("line 2",)),
                ("diameter,massFraction\n4e-5,0.5\n2e-5,0.5\n", ("must ascend", "Sort")),
                ("diameter,massFraction\n4e-5,1\n", ("two rows",)), ("", ("first line",)),
                ("2e-5,0.5\n4e-5,0.5\n", ("first line", "diameter, and one of")),
                ("diameter,masFraction\n2e-5,1\n4e-5,0\n", ("Did you mean massFraction?",)),
                ("diameter,massFiner\n2e-5,0\n3e-5,0.7\n4e-5,0.5\n5e-5,1\n", ("only grow", "0.5 after 0.7")),
                ("diameter,massFiner\n2e-5,0.1\n4e-5,1\n", ("begins at 0", "Add the diameter")),
                ("diameter,massFiner\n2e-5,0\n4e-5,100\n", ("ends at 1", "not percent")),
                ("diameter,massFraction\n2e-5,0.5\n4e-5,0.5\n", ("Write particleDiameter 2.667e-05",))):
            with self.subTest(text=text):
                self.refused(lambda: self.table(text), *words)
        self.refused(lambda: self.table("", sizeTable="size.csv"), "is not there", "sizeTable size.csv")

    def testOfASizeTooRareToBePoured(self):
        self.refused(lambda: sizes.told(logNormal(largestSize=2.0, sizeClasses=20.0), 20), "less than one parcel",
                     "Lower coarseGraining")


class Poured(DieFilling):
    """By LIGGGHTS, as `prepare` has it; nothing settles."""

    def pour(self, *changes, table=None):
        """Diameters of the particles, masses of the parcels, LIGGGHTS' log."""
        shutil.copytree(ROOT/"liggghts_scripts", self.work/"liggghts_scripts", dirs_exist_ok=True)
        if table:
            (self.case/"system/sizes.csv").write_text(table)
        subprocess.run([self.case/"variant", "v", "settleTime=1e-9", "powderHeight=4e-3", *changes], check=True,
                       capture_output=True)
        folder = self.case/"variants/v"
        ended = subprocess.run([folder/"prepare"], capture_output=True, text=True)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        rows = np.loadtxt(folder/"preparation/bed.dump", skiprows=9)
        return 2*rows[:, 4]/10, rows[:, 5], (folder/"preparation/log.bed").read_text()

    def key(self):
        """What the bed was poured with: another one is poured anew."""
        return (self.case/"variants/v/preparation/madeWith").read_text()

    def agree(self, diameters, wanted):
        """Numbers of each class: chi-square below what 1 of 1000 samples exceeds, of 2 or 7 degrees of freedom."""
        total, chi2 = len(diameters), 0
        for d, share in wanted:
            count = np.sum(np.abs(diameters/d - 1) < 1e-5)
            chi2 += (count - total*share)**2/(total*share)
        self.assertLess(chi2, 13.8 if len(wanted) == 3 else 24.3)
        self.assertEqual(sum(np.sum(np.abs(diameters/d - 1) < 1e-5) for d, _ in wanted), total)

    def hasTheMassOfTheBed(self, masses):
        self.assertAlmostEqual(masses.sum()/(0.58*4e-3*12e-3*2.4e-3*7360), 1, delta=5e-3)

    def testFractionsOfMass(self):
        """Numbers go with 0.2/27, 0.5/64, 0.3/216; the step with the smallest R:
        0.2 pi R sqrt(rho/G)/(0.1631 nu + 0.8766)."""
        table = "diameter,massFraction\n30e-6,0.2\n40e-6,0.5\n60e-6,0.3\n"
        diameters, masses, log = self.pour("sizeDistribution=table", "particleDiameter=41.38e-6",
                                           "sizeTable=system/sizes.csv", "youngsModulus=2e7", table=table)
        share = np.array([0.2/27, 0.5/64, 0.3/216])
        self.agree(diameters, list(zip((30e-6, 40e-6, 60e-6), share/share.sum())))
        self.hasTheMassOfTheBed(masses)
        for d, wanted in ((30e-6, 0.2), (40e-6, 0.5), (60e-6, 0.3)):
            self.assertAlmostEqual(masses[np.abs(diameters/d - 1) < 1e-5].sum()/masses.sum(), wanted, delta=5e-3)
        step = 0.2*math.pi*150e-6*math.sqrt(7360/(2e7/2.6))/(0.1631*0.3 + 0.8766)
        said = [float(line.split()[1]) for line in log.splitlines() if line.startswith("timestep") and "$" not in line]
        self.assertAlmostEqual(said[0]/step, 1, 8)

    def testFractionsOfNumber(self):
        table = "diameter,numberFraction\n30e-6,0.2\n40e-6,0.5\n60e-6,0.3\n"
        diameters, masses, _ = self.pour("sizeDistribution=table", "particleDiameter=49.2e-6",
                                         "sizeTable=system/sizes.csv", table=table)
        self.agree(diameters, [(30e-6, 0.2), (40e-6, 0.5), (60e-6, 0.3)])
        self.hasTheMassOfTheBed(masses)

    def testALogNormalDistribution(self):
        diameters, masses, _ = self.pour("sizeDistribution=logNormal")
        self.assertAlmostEqual(np.sum(diameters**3)/np.sum(diameters**2)/D, 1, delta=5e-3)
        self.hasTheMassOfTheBed(masses)
        powder = logNormal(diameterIs="sauterMean", smallestSize=0.5, largestSize=2.0, sizeClasses=8.0)
        self.agree(diameters, list(zip(powder.diameters, powder.numbers())))
        self.assertIn("parcel1", self.key())

    def testOneSizeIsPouredAsEver(self):
        """The lines that LIGGGHTS had before there were sizes; what describes sizes then makes no other bed."""
        self.assertEqual(sizes.script(None, 10, 32452843), (
            "fix             parcel all particletemplate/sphere 160481183 atom_type 1 &\n"
            "                density constant ${particleDensity} radius constant ${parcelRadius}\n"
            "fix             mix all particledistribution/discrete 179424673 1 parcel 1.0\n"))
        self.pour("coarseGraining=20", "geometricDeviation=1.5")
        self.assertNotIn("Deviation", self.key())
        self.assertNotIn("particletemplate", self.key())


if __name__ == "__main__":
    unittest.main()
