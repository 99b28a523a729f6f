# SPDX-License-Identifier: GPL-3.0-or-later
"""A case whose runs take milliseconds, in a folder of its own for each test."""
import csv
import io
import json
import os
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STUDY, FIGURE = ROOT/"studies/study", ROOT/"studies/figure"


class ToyCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name).resolve()
        self.case = self.work/"toy"
        shutil.copytree(HERE/"toy", self.case)
        self.results = self.case/"studies/results"

    def write(self, text, name="study.yaml"):
        path = self.case/"studies"/name
        path.write_text(text)
        return path

    def study(self, text, *options, name="study.yaml"):
        """Status, stdout, stderr."""
        ended = subprocess.run([STUDY, self.write(text, name), *options], capture_output=True,
                               text=True)
        return ended.returncode, ended.stdout, ended.stderr

    def started(self, path, *options):
        """In a process group of its own, which `killed` ends at once."""
        process = subprocess.Popen([STUDY, path, *options], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        self.addCleanup(self.killed, process)
        return process

    def killed(self, process):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()

    def ran(self):
        """Names of the variants that were run, in their order."""
        path = self.case/"ran"
        return path.read_text().split() if path.is_file() else []

    def rows(self, name="table.csv", study="study"):
        return list(csv.DictReader(io.StringIO((self.results/study/name).read_text())))

    def withoutSeconds(self, folder):
        """The tables but for what differs each time."""
        found = []
        for name in ("table.csv", "runs.csv"):
            for row in csv.DictReader(io.StringIO((folder/name).read_text())):
                found.append([item for item in row.items() if not item[0].startswith("seconds")])
        return found

    def resultFiles(self, study="study"):
        return sorted((self.results/study).glob("runs/*/result.json"))

    def allWhole(self, study="study"):
        for path in self.resultFiles(study):
            self.assertIn(json.loads(path.read_text())["status"], ("ok", "failed"))
