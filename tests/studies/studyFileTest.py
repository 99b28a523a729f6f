# SPDX-License-Identifier: GPL-3.0-or-later
"""From a study file to runs; each bad input gets one sentence, and nothing is run."""
import re
import shutil
import subprocess
import sys
import unittest
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO

sys.dont_write_bytecode = True

from program import loaded
from toyCase import ROOT, STUDY, ToyCase

# To be called here: that is quicker than to start it for each study.
study = loaded(STUDY)


class InThisProcess(ToyCase):
    def study(self, text, *options, name="study.yaml"):
        """Status, stdout, stderr."""
        return self.called(self.write(text, name), *options)

    def called(self, *words):
        with redirect_stdout(StringIO()) as out, redirect_stderr(StringIO()) as error:
            status = study.main([str(word) for word in words])
        return status, out.getvalue(), error.getvalue()


class TheRuns(InThisProcess):
    def runs(self, text):
        """What is given to `variant` and `run`, without names."""
        status, out, error = self.study(text, "--dry-run")
        self.assertEqual((status, error), (0, ""))
        self.assertFalse(self.results.exists())
        return [" ".join(line.split()[3:]) for line in out.splitlines()[:-1]], out

    def testAreTheFullProductInTheOrderOfTheFile(self):
        runs, out = self.runs("base: {dieDepth: 4e-3}\n"
                              "vary: {shoeSpeed: [0.1, .2], particleDiameter: [40e-6, 6.0E-5]}\n")
        self.assertEqual(runs, ["ranks=1 dieDepth=0.004",
                                "ranks=1 particleDiameter=6e-05 dieDepth=0.004",
                                "ranks=1 shoeSpeed=0.2 dieDepth=0.004",
                                "ranks=1 particleDiameter=6e-05 shoeSpeed=0.2 dieDepth=0.004"])
        self.assertIn("4 variants, 4 runs, 0 of them done", out)

    def testVaryInStepWhatStandsTogether(self):
        together = "together: {particleDiameter: [40e-6, 80e-6], mode: [plain, plain], dieDepth: [4e-3, 2e-3]}\n"
        pair = ["ranks=1 dieDepth=0.004", "ranks=1 particleDiameter=8e-05 dieDepth=0.002"]
        self.assertEqual(self.runs(together)[0], pair)
        runs, out = self.runs("vary: {shoeSpeed: [0.1, 0.2]}\n" + together + "packings: 1\n")
        self.assertEqual(runs, pair + ["ranks=1 shoeSpeed=0.2 dieDepth=0.004",
                                       "ranks=1 particleDiameter=8e-05 shoeSpeed=0.2 dieDepth=0.002"])
        self.assertIn("4 variants, 4 runs", out)

    def testVaryOneAtATimeAboutTheBase(self):
        runs, _ = self.runs("oneAtATime: {shoeSpeed: [0.1, 0.3], ranks: [2]}\n"
                            "variants: [{shoeSpeed: 0.3, ranks: 4}]\n")
        self.assertEqual(runs, ["ranks=1", "ranks=1 shoeSpeed=0.3", "ranks=2",
                                "ranks=4 shoeSpeed=0.3"])

    def testTakeNumbersAndWordsAsOpenFoamDoes(self):
        parameters = self.case/"system/caseParameters"
        parameters.write_text(parameters.read_text() + "air on;\nlight 1;\n")
        runs, _ = self.runs("variants: [{air: off}, {air: yes}, {light: 010}, {light: +1.5E+1}]\n")
        self.assertEqual(runs, ["ranks=1 air=off", "ranks=1 air=yes", "ranks=1 light=10",
                                "ranks=1 light=15"])

    def testAreOneForEachPacking(self):
        runs, out = self.runs("packings: [1, 5, 7]\nranks: 2\n")
        self.assertEqual(runs, ["ranks=2", "ranks=2 seed=5", "ranks=2 seed=7"])
        self.assertIn("1 variants, 3 runs", out)
        self.assertEqual(len(self.runs("packings: 4\n")[0]), 4)

    def testTakeNoSeedThatAScriptUsesItself(self):
        """LIGGGHTS refuses to pour where two seeds are alike."""
        seeds = {word.split("=")[1] for run in self.runs("packings: 10\n")[0] for word in run.split() if "seed" in word}
        self.assertEqual(len(seeds), 9)  # and the case's own
        sources = [*(ROOT/"liggghts_scripts").glob("*.in"), *(ROOT/"foam_cases").glob("*/*.in"),
                   *(ROOT/"foam_cases").glob("*/scene/*.py")]
        used = set(re.findall(r"\b\d{8,}\b", "".join(path.read_text() for path in sources)))
        self.assertTrue(used)
        self.assertEqual(seeds & used, set())

    def testKeepTheirNamesWhenTheStudyGrows(self):
        names = lambda out: {line.split()[2] for line in out.splitlines()[:-1]}
        small = names(self.runs("vary: {shoeSpeed: [0.2]}\n")[1])
        large = names(self.runs("vary: {shoeSpeed: [0.2, 0.3], dieDepth: [4e-3, 5e-3]}\n")[1])
        self.assertEqual(len(small & large), 1)

    def testGetOtherNamesWhenADefaultChanges(self):
        names = lambda out: {line.split()[2] for line in out.splitlines()[:-1]}
        before = names(self.runs("title: t\n")[1])
        parameters = self.case/"system/caseParameters"
        parameters.write_text(parameters.read_text().replace("5e-3", "6e-3"))
        self.assertFalse(before & names(self.runs("title: t\n")[1]))

    def testOfTheShippedStudiesCanBeListed(self):
        files = set(ROOT.glob("foam_cases/*/studies/*.yaml"))
        files -= set(ROOT.glob("foam_cases/*/studies/ranges.yaml"))
        self.assertTrue(files)
        for path in files:
            status, out, error = self.called(path, "--dry-run", "--results", self.work/"none")
            self.assertEqual((status, error), (0, ""), path)
            self.assertIn(" runs, 0 of them done", out)


class BadInput(InThisProcess):
    def refused(self, text, *wanted, options=(), name="study.yaml"):
        status, out, error = self.study(text, *options, name=name)
        self.assertEqual((status, out), (2, ""), error)
        self.assertEqual(len(error.splitlines()), 1, error)
        for words in wanted:
            self.assertIn(words, error)
        self.assertEqual(self.ran(), [])
        self.assertFalse(self.results.exists() or (self.case/"variants").exists())

    def testNamesTheNearestKey(self):
        self.refused("varry: {}\n", "study.yaml: a study has no key 'varry'; did you mean 'vary'?")
        self.refused("vary: {shoeSped: [0.1]}\n", "study.yaml, vary: the case toy has no parameter "
                     "'shoeSped'; did you mean 'shoeSpeed'?")
        self.refused("base: {rank: 2}\n", "did you mean 'ranks'?")
        self.refused("measures: [filingRatio]\n", "study.yaml, measures: the case toy has no "
                     "measure 'filingRatio'; did you mean 'fillingRatio'?")
        self.refused("measures: [weight]\n", "there are fillingRatio, slope.")

    def testWrongTypes(self):
        self.refused("base: {shoeSpeed: fast}\n", "base: 'shoeSpeed' must be a number, as 0.1 in "
                     "system/caseParameters, and is 'fast'")
        self.refused("base: {shoeSpeed: }\n", "'shoeSpeed' must be a number", "is empty")
        self.refused("base: {shoeSpeed: .inf}\n", "is '.inf'")
        self.refused("base: {mode: 3}\n", "'mode' must be a word, as 'plain'", "is 3")
        self.refused("base: {mode: 'a; b'}\n", "'mode' must be a word", "'a; b'")
        self.refused("base: [shoeSpeed]\n", "'parameter: value' is wanted")
        self.refused("vary: {shoeSpeed: 0.1}\n", "'shoeSpeed' must have a list of values", "0.1")
        self.refused("vary: [0.1]\n", "'parameter: [value, value]' is wanted")
        self.refused("variants: {shoeSpeed: 0.1}\n", "'variants' must be a list")
        self.refused("ranks: 1.5\n", "'ranks' must be a whole number from 1, and is 1.5")
        self.refused("vary: {ranks: [0]}\n", "'ranks' must be a whole number from 1, and is 0")
        self.refused("keep: [yes]\n", "'keep' must be yes or no, and is ['yes']")
        self.refused("measures: [[slope]]\n", "no measure '['slope']'")
        self.refused("base: {1: 2}\n", "has no parameter '1'")
        self.refused("variants: [1]\n", "'parameter: value' is wanted, and it is 1")
        self.refused("keep: perhaps\n", "'keep' must be yes or no, and is 'perhaps'")

    def testOutsideItsRange(self):
        self.refused("base: {shoeSpeed: 11}\n", "'shoeSpeed' must lie between 0.01 and 10, and is "
                     "11")
        self.refused("variants: [{}, {dieDepth: -1}]\n", "variants, entry 2: 'dieDepth' must be "
                     "greater than zero, as 0.005 in system/caseParameters, and is -1")
        self.refused("vary: {mode: [plane]}\n", "'mode' cannot be 'plane'; did you mean 'plain'?")

    def testNothingToRun(self):
        self.refused("packings: 0\n", "there must be one packing or more", "is 0")
        self.refused("packings: []\n", "there are no packings")
        self.refused("packings: many\n", "is 'many'")
        self.refused("packings: 99\n", "list the seeds")
        self.refused("packings: [1.5]\n", "a seed must be a whole number, and is 1.5")
        self.refused("vary: {shoeSpeed: []}\n", "the list of 'shoeSpeed' is empty")
        self.refused("variants: []\n", "'variants' must be a list")
        self.refused("measures: []\n", "'measures' must be a list with one name at least")

    def testTwice(self):
        self.refused("vary: {particleDiameter: [40e-6, 4e-5]}\n",
                     "the list of 'particleDiameter' has 4e-05 twice; keep one")
        self.refused("vary: {shoeSpeed: [0.1, 0.2]}\nvariants: [{shoeSpeed: 0.2}]\n",
                     "the variant shoeSpeed=0.2 stands there twice; keep one")
        self.refused("packings: [1, 1]\n", "the list of packings has 1 twice")
        self.refused("measures: [slope, slope]\n", "the list of measures has slope twice")
        self.refused("ranks: 1\nbase: {ranks: 2}\n", "'ranks' stands in the study and in its base")
        self.refused("vary: {seed: [1, 2]}\n", "'seed' is varied by the packings")

    def testTogetherThatIsNoPairing(self):
        self.refused("together: {shoeSpeed: [0.1, 0.2], dieDepth: [4e-3]}\n", "study.yaml, together: the lists must be of "
                     "one length", "2 (shoeSpeed), 1 (dieDepth)")
        self.refused("vary: {shoeSpeed: [0.3]}\ntogether: {shoeSpeed: [0.1], dieDepth: [4e-3]}\n",
                     "'shoeSpeed' stands in 'vary' and in 'together'; keep one")
        self.refused("together: {shoeSpeed: [0.2, 0.2], dieDepth: [4e-3, 4e-3]}\n",
                     "the variant shoeSpeed=0.2 dieDepth=0.004 stands there twice")
        self.refused("together: {shoeSpeed: []}\n", "together: the list of 'shoeSpeed' is empty")
        self.refused("together: [0.1]\n", "'parameter: [value, value]' is wanted")

    def testAReferenceThatIsNotThere(self):
        self.refused("vary: {shoeSpeed: [0.1, 0.2]}\nreference: {shoeSpeed: 0.3}\n",
                     "the reference shoeSpeed=0.3 of variant 1 is not among the variants")

    def testUnreadable(self):
        self.refused("vary: [1, 2\nbase: 1\n", "study.yaml, line ", "this is no YAML")
        self.refused("ranks: 1\nranks: 2\n", "the key 'ranks' stands there twice")
        self.refused("words\n", "it must hold keys with values")
        self.refused("", "it must hold keys with values")
        self.refused("title: t\n", "rename the file", name="my study.yaml")
        ended = subprocess.run([STUDY, self.case/"none.yaml"], capture_output=True, text=True)
        self.assertEqual((ended.returncode, ended.stdout), (2, ""))
        self.assertIn("none.yaml cannot be read: No such file", ended.stderr)

    def testNoCase(self):
        self.refused("case: ../nowhere\n", "case: there is no folder")
        self.refused("case: .\n", "cannot be studied, it has no variant")
        (self.case/"studies/ranges.yaml").write_text("shoeSped: [0, 1]\n")
        self.refused("title: t\n", "ranges.yaml: the case has no parameter 'shoeSped'")
        (self.case/"studies/ranges.yaml").write_text("shoeSpeed: 1\n")
        self.refused("title: t\n", "the range of 'shoeSpeed' must be")
        (self.case/"studies/ranges.yaml").unlink()
        parameters = self.case/"system/caseParameters"
        parameters.write_text(parameters.read_text() + "slope 1;\n")
        self.refused("title: t\n", "'slope' is the name of more than one column")
        (self.case/"measure").write_text("#!/bin/sh\necho no >&2; exit 1\n")
        self.refused("title: t\n", "measure -list' failed: no")
        shutil.rmtree(self.case/"system")
        self.refused("title: t\n", "study.yaml lies in no case")

    def testAProfileThatIsNotThere(self):
        self.refused("title: t\n", "The profile slurn has no config.yaml", "slurm",
                     options=("--profile", "slurn"))


if __name__ == "__main__":
    unittest.main()
