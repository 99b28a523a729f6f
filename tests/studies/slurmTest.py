# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Slurm profile tells Snakemake of a job, with a controller and an accounting that only pretend."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

STATUS = Path(__file__).resolve().parents[2]/"studies/profiles/slurm/status.sh"
UNKNOWN = "slurm_load_jobs error: Invalid job id specified"
ALONE = "slurm_load_jobs error: Unable to contact slurm controller (connect failure)"


class TheStatusOfAJob(unittest.TestCase):
    def told(self, controller, accounting="", code=0):
        with tempfile.TemporaryDirectory() as folder:
            for name, text, end in (("scontrol", controller, code), ("sacct", accounting, 0)):
                program = Path(folder)/name
                program.write_text(f"#!/bin/sh\ncat <<'END'\n{text}\nEND\nexit {end}\n")
                program.chmod(0o755)
            return subprocess.run([STATUS, "7"], capture_output=True, text=True, check=True,
                                  env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
                                  ).stdout.strip()

    def testTheControllerKnows(self):
        for state, word in (("PENDING", "running"), ("RUNNING", "running"), ("COMPLETED", "success"),
                            ("FAILED", "failed"), ("CANCELLED", "failed"), ("TIMEOUT", "failed"),
                            ("NODE_FAIL", "failed"), ("OUT_OF_MEMORY", "failed")):
            with self.subTest(state):
                self.assertEqual(self.told(f"JobId=7 JobName=a\n   JobState={state} Reason=None"), word)

    def testOnlyTheAccountingKnows(self):
        self.assertEqual(self.told(UNKNOWN, "COMPLETED\nCOMPLETED", 1), "success")
        self.assertEqual(self.told(UNKNOWN, "TIMEOUT", 1), "failed")

    def testWithoutAccountingTheResultTells(self):
        self.assertEqual(self.told(UNKNOWN, "", 1), "success")

    def testAControllerThatIsAwayEndsNoJob(self):
        self.assertEqual(self.told(ALONE, "", 1), "running")


if __name__ == "__main__":
    unittest.main()
