# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes that call for different effects: what each of them measures, and the processor time that it takes, with the
effects that the solver chooses, with all, and with those that one would pick by hand.

jet      light grains fall through sheared air: lift
beads    light beads rise in water: virtual mass
hopper   coarse heavy spheres run out: no air at all
"""
import math
import os
import resource
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
root = next(p for p in Path(__file__).resolve().parents if (p/"foam_cases").is_dir())
sys.path.insert(0, str(root/"tests/verification"))

from A13ShearLift import Sheared  # noqa: E402
from harness import case as cases  # noqa: E402
from harness.laws import GRAVITY, Air, Powder  # noqa: E402

KEYS = ("shearLift", "spinLift", "virtualMass", "viscousForce")


def keys(*on):
    return " ".join(f"{key} {'on' if key in on else 'off'};" for key in KEYS)


SETS = ("auto", "all", "picked")


class Grains:
    """A scene of the verification tests. `picked`: the effects of a hand."""

    repeats = math.inf  # as many as are asked for
    errors = {which: 0.0 for which in SETS}  # the same grains in each run

    def __init__(self, name, picked, make, measure):
        self.name, self.make, self.measure = name, make, measure
        self.effects = {"auto": "", "all": keys(*KEYS), "picked": keys(*picked)}

    def prepare(self):
        pass

    def run(self, which, folder):
        run = cases.run(self.make(self.effects[which]), folder, 1, shutil.which("demPimpleFoam"))
        return self.measure(run)


def meanOf(direction):
    """Where the grains' centre of mass has gone along an axis [m]."""
    def measure(run):
        record = run.record()
        first, last = record[min(record)], record[max(record)]
        return sum(last[i][0][direction] - first[i][0][direction] for i in first)/len(first)
    return measure


def spread(box, counts):
    """A lattice of so many grains over the middle half of a box."""
    return [tuple(0.25*length + 0.5*length*(index + 0.5)/n for length, index, n in zip(box.size, indices, counts))
            for indices in ((i, j, k) for i in range(counts[0]) for j in range(counts[1]) for k in range(counts[2]))]


def jet(effects):
    """Hollow spheres of 90 um that fall, and turn, with air sheared at 1200/s: lift over drag is 0.14."""
    powder, rate = Powder(90e-6, 200.0, Air()), 1200.0
    box = cases.Box((0.05, 0.01, 0.04), (50, 1, 1), ("noSlip", "periodic", "periodic"))
    wind = lambda x: rate*(x - box.size[0]/2)
    response = powder.density*powder.diameter**2/(18*powder.air.viscosity)
    steps = 2000
    return Sheared("jet", box, powder, wind, effects=effects, positions=spread(box, (8, 8, 16)),
                   velocity=lambda x: (0, 0, wind(x[0]) - response*GRAVITY), spin=(0, -rate/2, 0), gravity=(0, 0, -GRAVITY),
                   deltaT=response/50, subSteps=4, endTime=steps*response/50, recordEvery=4*steps)


def beads(effects):
    """Of 0.4 mm and 200 kg/m3 in a tank of water."""
    water = Air(1000.0, 1e-3)
    powder = Powder(0.4e-3, 200.0, water)
    box = cases.Box((0.02, 0.02, 0.04), (10, 10, 20), ("noSlip",)*3)
    steps = 800
    return cases.Case("beads", box, powder, effects=effects, positions=spread(box, (8, 8, 8)),
                      gravity=(0, 0, -GRAVITY), airGravity=(0, 0, -GRAVITY), deltaT=2.5e-4, subSteps=4,
                      endTime=steps*2.5e-4, recordEvery=4*steps)


class Hopper:
    """foam_cases/hopper with its bed; all: with air and every force of it."""
    name = "hopper: discharge [kg/s]"
    repeats = 1  # of eight minutes
    changes = {"auto": {}, "all": {"air": "on", "parcelForces": "on"}, "picked": {"air": "off"}}
    late, block, end = 0.05, 0.05, 0.4  # [s]: flows evenly from then on; blocks know nothing of each other

    def __init__(self):
        self.errors = {}

    def prepare(self):
        """The bed, which all runs begin with."""
        case = root/"foam_cases/hopper"
        quietly([case/"prepare"], case)

    def run(self, which, folder):
        case = root/"foam_cases/hopper"
        name = f"effects{which}"
        changes = {"endTime": self.end, **self.changes[which]}
        quietly([case/"variant", name, *(f"{k}={v}" for k, v in changes.items())], case)
        quietly([case/"variants"/name/"run", "-np", "1"], case)
        rows = [line.split() for line in (case/"variants"/name/"postProcessing/powderBalance/0/powderBalance.dat")
                .read_text().splitlines() if not line.startswith("#")]
        late = [(float(row[0]), float(row[1])) for row in rows if float(row[0]) >= self.late - 1e-9]
        flow = lambda rows: (rows[0][1] - rows[-1][1])/(rows[-1][0] - rows[0][0])
        count = round((self.end - self.late)/self.block)
        each = [flow([row for row in late if 0 <= row[0] - self.late - n*self.block < self.block]) for n in range(count)]
        self.errors[which] = statistics.stdev(each)/math.sqrt(count)/statistics.mean(each)
        return flow(late)


def quietly(command, folder):
    done = subprocess.run([str(word) for word in command], cwd=folder, text=True, capture_output=True,
                          env={**os.environ, "PWD": str(folder)})
    if done.returncode:
        sys.exit(f"{command[0]} failed\n{(done.stdout + done.stderr)[-2000:]}")


scenes = (Grains("jet: mean drift [m]", ("shearLift",), jet, meanOf(0)),
          Grains("beads: mean rise [m]", ("virtualMass",), beads, meanOf(2)), Hopper())


def measured(scene, which, folder):
    """The scene's measure, and the processor time of all that it started [s]."""
    spent = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    before = spent()
    value = scene.run(which, folder)
    return value, spent() - before
