# SPDX-License-Identifier: GPL-3.0-or-later
"""A case that was copied to where one likes: its scripts find Interstice by INTERSTICE_ROOT, and say so if it is not set."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASES = sorted(path.parent.name for path in (ROOT/"foam_cases").glob("*/Allrun"))
SCRIPTS = ("Allrun", "run", "variant x", "prepare", "measure", "plot.py", "uniformity")


class Elsewhere(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = Path(folder.name)
        self.assertFalse([p for p in self.place.parents if (p/"liggghts_scripts").is_dir()])

    def copied(self, name):
        return Path(shutil.copytree(ROOT/"foam_cases"/name, self.place/name, ignore=shutil.ignore_patterns(
            "variants", "results", "preparation", "postProcessing", "caseDerived", "polyMesh", "0.*", "log.*")))

    def command(self, case, words, root=None):
        known = {key: value for key, value in os.environ.items() if key != "INTERSTICE_ROOT"}
        if root:
            known["INTERSTICE_ROOT"] = str(root)
        words = words.split()
        return subprocess.run([case/words[0], *words[1:]], cwd=self.place, env=known, capture_output=True, text=True, timeout=60)

    def testAnUnknownRootIsTold(self):
        self.assertEqual(len(CASES), 8)
        for name in CASES:
            case = self.copied(name)
            for words in SCRIPTS:
                if (case/words.split()[0]).exists():
                    ended = self.command(case, words)
                    self.assertNotEqual(ended.returncode, 0, (name, words))
                    self.assertIn("INTERSTICE_ROOT", ended.stderr, (name, words))
                    self.assertIn("source cmake/environment.sh", ended.stderr, (name, words))
                    self.assertNotIn("Traceback", ended.stderr, (name, words))

    def testItIsPreparedAndVaried(self):
        for name in ("dynamicRepose", "staticRepose", "fluidisedBed"):  # those that pour in the run itself
            case = self.copied(name)
            self.assertEqual(self.command(case, "prepare", ROOT).returncode, 0, name)
            ended = self.command(case, "variant other particleDiameter=1e-3", ROOT)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            self.assertRegex((case/"variants/other/system/caseParameters").read_text(), r"particleDiameter +1e-3;")
            self.assertEqual(self.command(case, "variants/other/prepare", ROOT).returncode, 0, name)

    def testANumberOfRanksThatIsNoneIsTold(self):
        for name in CASES:
            case = self.copied(name)
            script = "run" if (case/"run").exists() else "Allrun"
            for ranks in ("-np", "-np two", "-np 0", "-np -1", "-np 2 more", "2"):
                ended = self.command(case, f"{script} {ranks}", ROOT)
                self.assertNotEqual(ended.returncode, 0, (name, ranks))
                self.assertRegex(ended.stderr, r"^usage: .*\[-np (RANKS|1)\]", (name, ranks))
                self.assertEqual(ended.stdout, "", (name, ranks))


if __name__ == "__main__":
    unittest.main()
