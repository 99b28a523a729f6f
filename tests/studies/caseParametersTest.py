# SPDX-License-Identifier: GPL-3.0-or-later
"""system/caseParameters, as each case with a script `prepare` reads it."""
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Of each case parameters that `prepare` reckons with, or by which it knows a bed again.
WANTED = {"dieFilling": ["particleDiameter"], "fluidisedBed": ["particleDiameter", "settleTime"],
          "hopper": ["grainDiameter", "friction"], "packedBed": ["particleDiameter", "friction"],
          "dynamicRepose": ["particleDiameter"], "staticRepose": ["particleDiameter"]}


class Parameters(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        (self.tree/"foam_cases").mkdir()
        for shared in ("studies", "liggghts_scripts", "foam_cases/common"):
            (self.tree/shared).symlink_to(ROOT/shared)

    def copied(self, name):
        case = self.tree/"foam_cases"/name
        shutil.copytree(ROOT/"foam_cases"/name, case, ignore=shutil.ignore_patterns(
            "variants", "results", "preparation", "postProcessing", "caseDerived", "polyMesh", "0.*", "log.*"))
        return case

    def testAMissingOneIsTold(self):
        self.assertEqual({path.parent.name for path in (ROOT/"foam_cases").glob("*/prepare")}, set(WANTED))
        for name, keys in WANTED.items():
            case = self.copied(name)
            path = case/"system/caseParameters"
            whole = path.read_text()
            for key in keys:
                path.write_text(re.sub(rf"^{key} .*$", "", whole, flags=re.M))
                ended = subprocess.run([case/"prepare"], capture_output=True, text=True)
                self.assertEqual(ended.returncode, 1, name)
                self.assertNotIn("Traceback", ended.stderr, name)
                for words in (f"no {key}   system/caseParameters", f"wanted  {key} and its value", "Add it"):
                    self.assertIn(words, ended.stderr, name)


if __name__ == "__main__":
    unittest.main()
