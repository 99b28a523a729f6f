# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene that is timed: the slice of foam_cases/dieFilling, a short window, nothing written.

Each scene is a folder of its own, made by the case's `variant`; the case itself stays as it is.
"""
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from importlib.machinery import SourceFileLoader
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
root = next(p for p in Path(__file__).resolve().parents if (p/"foam_cases").is_dir())
dieFilling = root/"foam_cases/dieFilling"
scripts = root/"liggghts_scripts"
foamFile = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"


def at(folder):
    """OpenFOAM warns if the shell's idea of the current folder is another one."""
    return {**os.environ, "PWD": str(folder)}


def shell(command, folder, log=None):
    """Runs a command; its output goes to a log, of which the end is shown on failure."""
    log = folder/(log or "log.benchmark")
    with open(log, "w") as out:
        code = subprocess.call([str(word) for word in command], cwd=folder, stdout=out,
                               stderr=subprocess.STDOUT, env=at(folder))
    if code:
        end = "".join(log.read_text(errors="replace").splitlines(True)[-20:])
        sys.exit(f"{end}{command[0]} failed: see {log}")


def control(folder, endTime, deltaT=None):
    """`deltaT`: fixed step; without it the solver chooses, as in the case."""
    (folder/"system/controlDict").write_text(
        foamFile.format("controlDict")
        + '#include "caseDerived"\n'
        "application demPimpleFoam; startFrom startTime; startTime 0; stopAt endTime;\n"
        f"endTime {endTime:.12g}; deltaT {deltaT or 1e-5:.15g}; maxCo 1; maxDeltaT $maxDeltaT;\n"
        f"adjustTimeStep {'off' if deltaT else 'on'};\n"
        "writeControl timeStep; writeInterval 100000000; writeFormat ascii; timePrecision 8;\n")


def runScript(folder, name):
    """The solver runs this LIGGGHTS script of the folder instead of the case's."""
    path = folder/"constant/couplingProperties"
    path.write_text(path.read_text().replace('"dieFilling.in"', f'"{name}"'))


# A script in the case folder finds those that it includes by their own place.
fromHere = f"variable scripts delete\nvariable scripts index {scripts}\n"


class Scene:
    """One folder; `number` holds the case's parameters and what follows from them."""

    def __init__(self, name, **changes):
        words = [f"{key}={value if isinstance(value, str) else format(value, '.12g')}" for key, value in changes.items()]
        subprocess.run([dieFilling/"variant", f"benchmark{name}", *words], check=True,
                       stdout=subprocess.DEVNULL)
        self.folder = dieFilling/f"variants/benchmark{name}"
        loader = SourceFileLoader("prepare", str(self.folder/"prepare"))
        self.case = importlib.util.module_from_spec(
            importlib.util.spec_from_loader("prepare", loader))
        loader.exec_module(self.case)
        self.parameters = self.case.read()
        derived, self.given = self.case.derived(self.parameters, None)
        self.number = {**self.parameters, **derived}

    def mesh(self, cut=(1, 1, 1)):
        """blockMesh and, for more than one rank, decomposePar: `cut` parts along x, y, z."""
        self.ranks = int(np.prod(cut))
        for old in self.folder.glob("processor*"):
            shutil.rmtree(old)
        shell(["blockMesh"], self.folder)
        if self.ranks > 1:
            (self.folder/"system/decomposeParDict").write_text(
                foamFile.format("decomposeParDict")
                + f"numberOfSubdomains {self.ranks}; method simple;\n"
                "simpleCoeffs { n (%d %d %d); delta 0.001; }\n" % tuple(cut))
            shell(["decomposePar", "-force"], self.folder)

    def solver(self):
        """The command that runs the scene."""
        if self.ranks == 1:
            return ["demPimpleFoam"]
        return ["mpirun", "-np", self.ranks, "demPimpleFoam", "-parallel"]


def slice_(name, window, deltaT=None, **changes):
    """The slice as the case has it, with its poured bed."""
    scene = Scene(name, **changes)
    shell(["./prepare"], scene.folder)
    control(scene.folder, window, deltaT)
    scene.mesh()
    return scene


def emptySlice(window, steps):
    """The same without a particle: shoe, mesh and number of steps are those of the slice."""
    step = window/steps
    scene = slice_("Air", window, step)
    (scene.folder/"empty.in").write_text(
        f"{fromHere}include {scripts}/dieFilling.in\ndelete_atoms group all\n"
        "atom_modify sort 0 0\n"  # without particles it has no bins to sort into
        # LIGGGHTS wants something of type 1.
        "fix below all wall/gran model hertz tangential history primitive type 1 zplane -1\n"
        f"timestep {step:.15g}\n")
    runScript(scene.folder, "empty.in")
    return scene


def aloneCommand(scene, steps, demStep):
    """LIGGGHTS alone: the slice's own script, and as many steps in one run."""
    (scene.folder/"alone.in").write_text(
        f"include {scripts}/dieFilling.in\ntimestep {demStep:.15g}\nrun {steps}\n")
    command = ["liggghts", "-in", "alone.in", "-log", "log.alone", "-screen", "screen.alone",
               "-var", "case", scene.folder, "-var", "scripts", scripts]
    for key, value in scene.number.items():
        if not (isinstance(value, str) and value.startswith("(")):
            command += ["-var", key, f"{value:.12g}" if isinstance(value, float) else value]
    return command


def wideSlice(copies, window):
    """A slice as wide as `copies` of them, holding as many beds side by side."""
    narrow = dieFilling/"preparation/bed.dump"
    width = Scene("Wide").parameters["sliceWidth"]
    scene = Scene("Wide", sliceWidth=copies*width)
    d = scene.number
    scene.case.walls.write(scene.folder, scene.parameters, scene.number, scene.given)
    (scene.folder/"system/caseDerived").write_text(
        foamFile.format("caseDerived")
        + '#include "caseParameters"\n'
        + "".join(f"{key} {value};\n" for key, value in d.items()
                  if key not in scene.parameters))
    control(scene.folder, window)

    bed = np.loadtxt(narrow, skiprows=9)
    rows = []
    for copy in range(copies):
        for x, y, z, radius in bed[:, 1:5]:
            rows.append(f"{len(rows) + 1} 1 {2*radius:.9g} {d['particleDensity']:.9g} {x:.9g} "
                        f"{y + (copy - 0.5*(copies - 1))*width:.9g} {z:.9g}")
    (scene.folder/"bed.data").write_text(
        f"Beds side by side\n\n{len(rows)} atoms\n2 atom types\n\n"
        + "".join(f"{d[f'dem{a}Low']:.9g} {d[f'dem{a}High']:.9g} {b}lo {b}hi\n"
                  for a, b in ("Xx", "Yy", "Zz"))
        + "\nAtoms\n\n" + "\n".join(rows) + "\n")
    text, found = re.subn(r'(?m)^if .* "read_restart .*&\n.*bed.restart"$', "read_data ${case}/bed.data",
                          (scripts/"dieFilling.in").read_text())
    if found != 1:
        raise SystemExit("dieFilling.in no longer reads its bed as this benchmark expects.")
    (scene.folder/"wide.in").write_text(fromHere + text)
    runScript(scene.folder, "wide.in")
    return scene
