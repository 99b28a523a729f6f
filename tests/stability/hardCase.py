# SPDX-License-Identifier: GPL-3.0-or-later
"""What hard cases need beside the harness of tests/verification, which it puts on the path: changes of
single lines of a case, and more readings of a run."""
import collections
import math
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent/"verification"))

from harness.bench import main  # noqa: E402, F401
from harness.case import Box, Case, Failed, lattice, run, spaced  # noqa: E402, F401
from harness.laws import GRAVITY, Air, Powder  # noqa: E402, F401

STEP = re.compile(r"^t = .*\| dt (?P<dt>\S+) s \((?P<limit>[^,]+), \d+ DEM steps\)"
                  r" \| air max (?P<speed>\S+) m/s, Co \S+, p iterations (?P<iterations>\d+)"
                  r"(?: \| (?P<outside>\d+) outside the mesh)?", re.M)

Step = collections.namedtuple("Step", "dt limit speed iterations outside")


def change(case, file, old, new):
    """The case, with another text in one of its files once it is written."""
    write = case.write

    def changed(folder, ranks):
        write(folder, ranks)
        text = (folder/file).read_text()
        assert old in text, f"no '{old}' in {file}"
        (folder/file).write_text(text.replace(old, new, 1))
    case.write = changed
    return case


def measured(case, function):
    """The case with one more function object, which acts in every step."""
    return change(case, "system/controlDict", "functions\n{", "functions\n{\n" + function)


def table(run, name):
    """What a function object wrote, a row a step."""
    return run.table(name)


def steps(run):
    """What the log says of each step."""
    return [Step(float(m["dt"]), m["limit"], float(m["speed"]), int(m["iterations"]),
                 int(m["outside"] or 0)) for m in STEP.finditer(run.log)]


def mostIterations(run):
    """Of the pressure in a step, which solves it once."""
    return max(step.iterations for step in steps(run))


def cellVolume(run):
    return math.prod(run.case.box.cell)


def grainVolume(case):
    """Of all grains [m3]."""
    return len(case.positions)*math.pi/6*case.diameter**3


def volumeError(run, time=None):
    """Powder on the mesh less that of the grains, of these."""
    onMesh = math.fsum(1 - alpha for alpha in run.field("voidFraction", time))*cellVolume(run)
    return onMesh/grainVolume(run.case) - 1


def numbers(text):
    return [float(x) for x in text.split()]


def listed(path):
    """A list of labels of the mesh."""
    return [int(x) for x in re.search(r"\n\d+\s*\(([^()]*)\)", path.read_text()).group(1).split()]


def outflow(run):
    """Net volume flux of air out of each cell, and the sum of its parts' magnitudes [m3/s]."""
    mesh = run.folder/"constant/polyMesh"
    owner, neighbour = listed(mesh/"owner"), listed(mesh/"neighbour")
    text = (run.folder/run.times()[-1]/"alphaPhi").read_text()
    inside, boundary = text.split("boundaryField")
    net = [0.0]*(max(owner) + 1)
    gross = list(net)

    def add(cell, flux):
        net[cell] += flux
        gross[cell] += abs(flux)
    for face, flux in enumerate(numbers(re.search(r"\(([^()]*)\)\s*;", inside).group(1))):
        add(owner[face], flux)
        add(neighbour[face], -flux)
    for name, start, count in patches(mesh/"boundary"):
        found = re.search(name + r"\s*\{[^}]*?\svalue\s+(?:uniform\s+([^;]+)|[^(]*\(([^()]*)\))\s*;",
                          boundary)
        fluxes = [float(found[1])]*count if found[1] else numbers(found[2])
        for face, flux in enumerate(fluxes):
            add(owner[start + face], flux)
    return net, gross


def patches(path):
    return [(name, int(start), int(count)) for name, count, start in re.findall(
        r"(\w+)\s*\{[^}]*nFaces\s+(\d+);[^}]*startFace\s+(\d+);", path.read_text())]


def continuityError(run):
    """Largest of any cell, in the last step: air that came in and void that was opened do not match,
    of the air that passed."""
    net, gross = outflow(run)
    volume = cellVolume(run)
    opened = [volume*rate for rate in run.field("ddtVoidFraction")]
    return max(abs(a + b) for a, b in zip(net, opened))/max(gross)
