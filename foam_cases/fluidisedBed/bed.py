# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of this case says of its bed, for plot.py and measure: series in time, and means over it."""
import math
import os
import sys
from pathlib import Path

import numpy as np

case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path.insert(0, str(root/"foam_cases/common"))

import parameters

GRAVITY = 9.81
INTERVALS = 512  # into which a record is cut for what wants equal ones


def numbers(folder):
    """Parameters and what follows from them."""
    return parameters.read(folder/"system/caseParameters", folder/"system/caseDerived")


def heights(folder):
    """Time, mean height of the spheres."""
    return np.loadtxt(folder/"postProcessing/bedHeight.dat")


def drops(folder, p):
    """Time, pressure drop without the weight of the gas."""
    text = (folder/"postProcessing/pressureDrop/0/volFieldValue.dat").read_text()
    gradient = np.array([line.replace("(", " ").replace(")", " ").split()
                         for line in text.splitlines() if line[0] != "#"], float)
    drop = -p["gasDensity"]*(gradient[:, 3]/p["area"] + GRAVITY*p["height"])
    return np.column_stack((gradient[:, 0], drop))


def netWeight(folder, p):
    """Of all spheres, less what the gas buoys, over area [Pa]."""
    balance = folder/"postProcessing/powderBalance/0/powderBalance.dat"
    mass = np.loadtxt(balance, skiprows=1, max_rows=1)[4]  # at the start
    return mass*(1 - p["gasDensity"]/p["particleDensity"])*GRAVITY/p["area"]


def since(series, start):
    """What of a series counts for means: from when the bed bubbles."""
    return series[series[:, 0] > start - 1e-9]


def mean(series, start):
    """Over time, which passes in unequal steps."""
    t, y = since(series, start).T
    return np.trapz(y, t)/(t[-1] - t[0]) if len(t) > 1 else math.nan


def deviation(series, start):
    """Standard deviation in time."""
    square = series[:, 1] - mean(series, start)
    return math.sqrt(mean(np.column_stack((series[:, 0], square**2)), start))


def evenly(series, start):
    """Means over equal intervals, each as the trapezoids have it."""
    t, y = since(series, start).T
    sums = np.concatenate(([0], np.cumsum(0.5*(y[1:] + y[:-1])*np.diff(t))))
    ends = np.linspace(t[0], t[-1], INTERVALS + 1)
    return np.diff(np.interp(ends, t, sums))/(ends[1] - ends[0])
