# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of this case says of its bed, for plot.py and measure: the pressure drop at the end of each
step in velocity, and what it should be.

Reads postProcessing/ and the fields at those times. The formulas are evaluated with the void fraction that
the mesh sees, layer by layer, and with the velocity of the fluid relative to the spheres: soft ones rise a
little under less load, slowly when they carry hardly any.
"""
import math
import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path.insert(0, str(root/"foam_cases/common"))

import parameters

GRAVITY = 9.81
WINDOW = 0.003  # before the end of a step, of means over time [s]


@dataclass
class Step:
    """The end of a step in velocity; pressure drops without the weight of the fluid [Pa]."""
    time: str
    velocity: float  # superficial [m/s]
    drop: float
    ergun: float
    meanDrop: float  # over WINDOW
    carried: float  # what that should be: net weight less what floor and wall hold, and the gain of speed


class Bed:
    def __init__(self):
        p = self.p = parameters.read(case/"system/caseParameters", case/"system/caseDerived")
        self.area = p["area"]
        stops = times()
        height = cells(stops[-1], "Cz")
        layer, volume = np.floor(height/p["layerHeight"]).astype(int), cells(stops[-1], "V")
        profiles = [layers(time, layer, volume) for time in stops]
        self.profile = profiles[0]  # void fraction of each layer, upwards, as the bed lies in the beginning
        self.weight = netWeight(p)
        self.onset = minimumFluidisation(self.profile, p)
        self.t, self.velocity, self.drop = history(p)
        self.steps = []
        for time, profile in zip(stops, profiles):
            at = np.argmin(np.abs(self.t - float(time)))
            slip = self.velocity[at] - rising(time, int(p["layers"]), p["layerHeight"])
            self.steps.append(Step(time, self.velocity[at], self.drop[at], drop(profile, slip, p),
                                   *self.carried(self.t[at])))

    def carried(self, end):
        """Mean pressure drop over a while up to `end`, and what carries the spheres then."""
        walls = np.loadtxt(case/"postProcessing/walls.dat")
        budget = np.loadtxt(case/"postProcessing/momentumBudget/0/momentumBudget.dat")
        inside = lambda time: (time > end - WINDOW) & (time < end + 1e-9)
        force = walls[inside(walls[:, 0]), 1:].sum(axis=1).mean()
        steps = np.flatnonzero(inside(self.t))
        first, last = steps[0] - 1, steps[-1]
        gain = (budget[last, 6] - budget[first, 6])/(self.t[last] - self.t[first])
        mean = np.average(self.drop[steps], weights=np.diff(self.t)[steps - 1])
        return mean, self.weight + (gain - force)/self.area


def table(name):
    """Columns of a function object's table; vectors are three of them."""
    path, = (case/f"postProcessing/{name}/0").glob("*FieldValue.dat")
    text = path.read_text()
    rows = [line.replace("(", " ").replace(")", " ").split() for line in text.splitlines()
            if not line.startswith("#")]
    return np.array(rows, float)


def history(p):
    """Time, superficial velocity, pressure drop without the weight of the fluid."""
    gradient, flow = table("pressureDrop"), table("flow")
    return (flow[:, 0], -flow[:, 1]/p["area"],
            -p["fluidDensity"]*(gradient[:, 3]/p["area"] + GRAVITY*p["height"]))


def times():
    folders = [path.name for path in case.iterdir() if re.fullmatch(r"\d+(\.\d+)?(e-\d+)?", path.name)]
    return sorted((name for name in folders if float(name) > 0), key=float)


def cells(time, name):
    """Values of a scalar field in all cells."""
    text = (case/time/name).read_text()
    return np.array(re.search(r"List<scalar>\s+\d+\s*\(([^()]*)\)", text).group(1).split(), float)


def layers(time, layer, volume):
    """Mean void fraction of each layer of cells, upwards."""
    alpha = cells(time, "voidFraction")
    return np.bincount(layer, alpha*volume)/np.bincount(layer, volume)


def rising(time, count, height):
    """Mean velocity of the spheres of each layer; each belongs to the two layers next to it."""
    read = lambda name: np.array(re.findall(
        r"^\((\S+) (\S+) (\S+?)\)", (case/time/"lagrangian/powder"/name).read_text(), re.M), float)
    at = np.clip(read("positions")[:, 2]/height - 0.5, 0, count - 1.001)
    low = at.astype(int)
    share = at - low
    mean = lambda values: (np.bincount(low, (1 - share)*values, count)
                           + np.bincount(low + 1, share*values, count))
    return mean(read("U")[:, 2])/np.maximum(mean(np.ones(len(at))), 1e-9)


def ergun(alpha, U, p):
    """Pressure drop per length [Pa/m] at the superficial velocity U (S. Ergun, Chem. Eng. Prog. 48
    (1952) 89-94)."""
    d, rho = p["particleDiameter"], p["fluidDensity"]
    solids = 1 - alpha
    return (150*rho*p["kinematicViscosity"]*U*solids**2/(alpha**3*d**2)
            + 1.75*rho*U**2*solids/(alpha**3*d))


def drop(profile, U, p):
    return float(np.sum(ergun(profile, U, p)))*p["layerHeight"]


def netWeight(p):
    """Of all spheres, less what the fluid buoys, per area [Pa]."""
    volume = p["spheres"]*math.pi/6*p["particleDiameter"]**3
    return volume*(p["particleDensity"] - p["fluidDensity"])*GRAVITY/p["area"]


def minimumFluidisation(profile, p):
    low, high = 0.0, 1.0
    while drop(profile, high, p) < netWeight(p):
        high *= 2
    while high - low > 1e-9:
        middle = 0.5*(low + high)
        low, high = (middle, high) if drop(profile, middle, p) < netWeight(p) else (low, middle)
    return low
