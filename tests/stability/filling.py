# SPDX-License-Identifier: GPL-3.0-or-later
"""The slice of foam_cases/dieFilling with few large parcels, as tests of going on use it: run, stopped,
resumed and compared."""
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

from hardCase import Failed
from harness.case import environment, execute

ROOT = pathlib.Path(__file__).resolve().parents[2]
COARSE = ("coarseGraining=20", "cellSize=1.2e-3", "shoeWallThickness=2.4e-3")
PARALLEL = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np"]


class Filling:
    """A folder of the case. `name` and `seconds` are what the harness prints of it."""

    def __init__(self, folder, solver, ranks=1):
        self.folder, self.solver, self.ranks = pathlib.Path(folder), solver, ranks
        self.name = self.folder.name
        self.case, self.seconds = self, 0.0

    @classmethod
    def poured(cls, work, solver, *changes):
        """A new one, with its bed; `changes` of the parameters beside those of COARSE."""
        shutil.rmtree(work, ignore_errors=True)
        base = work/"tree/foam_cases/dieFilling"
        shutil.copytree(ROOT/"foam_cases/dieFilling", base, ignore=shutil.ignore_patterns(
            "variants", "processor*", "postProcessing", "preparation", "VTK", "log.*", "pictures",
            "polyMesh", "triSurface", "0.*"))
        for shared in ("liggghts_scripts", "cmake", "foam_cases/common"):
            (work/"tree"/shared).symlink_to(ROOT/shared)
        execute(base, [str(base/"variant"), "coarse", *COARSE, *changes], "log.variant")
        made = cls(base/"variants/coarse", solver)
        execute(made.folder, ["./prepare"], "log.prepare")
        execute(made.folder, ["blockMesh"], "log.blockMesh")
        made.set("system/controlDict", "writeFormat", "ascii")
        made.set("system/controlDict", "writePrecision", "17")
        # What a linear solver leaves would be larger than what the last digits make of a path.
        solvers = made.path("system/fvSolution")
        solvers.write_text(re.sub(r"tolerance +\S+;", "tolerance 1e-13;", solvers.read_text()))
        return made

    def copy(self, name, ranks=None):
        plain = re.sub(r"\W+", "_", name)  # OpenFOAM allows few characters in the name of a folder
        twin = Filling(self.folder.parent/plain, self.solver, ranks or self.ranks)
        twin.name = name
        shutil.rmtree(twin.folder, ignore_errors=True)
        shutil.copytree(self.folder, twin.folder, symlinks=True)
        return twin

    def set(self, file, key, value):
        path = self.folder/file
        text, count = re.subn(rf"(?m)^(\s*{key}\s+)[^;]*;", rf"\g<1>{value};", path.read_text())
        assert count == 1, f"{count} keys {key} in {file}"
        path.write_text(text)

    def until(self, endTime, interval):
        """Writes at each interval, and ends at endTime, whatever the case's parameters say."""
        control = self.path("system/controlDict")
        text = re.sub(r"(?m)^endTime .*\n", "", control.read_text())
        control.write_text(text.replace("\nstopAt ", f"\nendTime {endTime:.9g};\nstopAt "))
        self.set("system/controlDict", "writeInterval", f"{interval:.9g}")
        return self

    def path(self, name):
        return self.folder/name

    def decompose(self, ranks):
        """The last time on disk, on another number of ranks."""
        if self.ranks > 1:
            execute(self.folder, ["reconstructPar", "-latestTime"], "log.reconstructPar")
            for old in self.folder.glob("processor*"):
                shutil.rmtree(old)
        self.ranks = ranks
        self.path("system/ranks").write_text(f"numberOfSubdomains {ranks};\n")
        if ranks > 1:
            execute(self.folder, ["decomposePar", "-latestTime"], "log.decomposePar")
        return self

    def command(self):
        return [self.solver] if self.ranks == 1 else [
            *PARALLEL, str(self.ranks), self.solver, "-parallel"]

    def run(self):
        start = time.monotonic()
        self.log = execute(self.folder, self.command(), "log.demPimpleFoam")
        self.seconds = time.monotonic() - start
        return self

    def refused(self):
        """What it says instead of running."""
        try:
            self.run()
        except Failed as failure:
            return str(failure)
        return ""

    def runUntil(self, stop, number):
        """Runs until stop() holds, sends the signal `number` to all ranks; returns what the program, or
        mpirun, ended with."""
        with open(self.path("log.demPimpleFoam"), "w") as out:
            process = subprocess.Popen(self.command(), cwd=self.folder, stdout=out,
                                       stderr=subprocess.STDOUT, env=environment(self.folder))
            while process.poll() is None and not stop():
                time.sleep(0.002)
            for pid in self.pids(process.pid):
                os.kill(pid, number)
            code = process.wait(timeout=60)
        self.log = self.path("log.demPimpleFoam").read_text()
        return code

    def pids(self, parent):
        """Of the ranks."""
        if self.ranks == 1:
            return [parent]
        children = subprocess.run(["pgrep", "-P", str(parent)], capture_output=True, text=True)
        return [int(pid) for pid in children.stdout.split()]

    def parts(self):
        return sorted(self.folder.glob("processor*")) or [self.folder]

    def times(self):
        """Written, in order, whole or not."""
        return sorted((p.name for p in self.parts()[0].iterdir()
                       if re.fullmatch(r"[0-9][0-9.e-]*", p.name)), key=float)

    def whole(self):
        return [t for t in self.times() if (self.powder(t)/"checkpoint").is_file()]

    def powder(self, name):
        return self.parts()[0]/name/"uniform/powder"

    def scale(self, name, key, factor):
        """A number in the record of a checkpoint."""
        record = self.powder(name)/"checkpoint"
        text, count = re.subn(rf"(?m)^({key}\s+)([^;]+);",
                              lambda m: f"{m[1]}{factor*float(m[2]):.17g};", record.read_text())
        assert count == 1, f"{count} entries {key} in {record}"
        record.write_text(text)

    def forget(self, after):
        """The times later than this one."""
        for part in self.parts():
            for folder in part.iterdir():
                if re.fullmatch(r"[0-9][0-9.e-]*", folder.name) and float(folder.name) > float(after):
                    shutil.rmtree(folder)
        return self

    def parcels(self, name):
        """{id: position} of a time."""
        found = {}
        for part in self.parts():
            cloud = part/name/"lagrangian/powder"
            if (cloud/"id").is_file():
                ids = re.search(r"\n\d+\s*\(([^)]*)\)", (cloud/"id").read_text())[1].split()
                places = re.findall(r"\n\(([^()]*)\)", (cloud/"positions").read_text())
                found.update({int(i): tuple(map(float, x.split()))
                              for i, x in zip(ids, places, strict=True)})
        return found

    def apart(self, other, name):
        """Largest distance of a parcel between two runs [m]; infinite if they hold others."""
        mine, theirs = self.parcels(name), other.parcels(name)
        if mine.keys() != theirs.keys() or not mine:
            return math.inf
        return max(math.dist(mine[i], theirs[i]) for i in mine)


SIGNALS = {signal.SIGTERM: "SIGTERM", signal.SIGINT: "SIGINT", signal.SIGUSR1: "SIGUSR1"}
