#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast the hopper empties, without air against Beverloo's law, and with air: a table and
pictures/beverloo.png, pictures/air.png.

Reads variants/noAir8, noAir12, noAir16, vacuum, open and closed, and preparation/bed.dump.
"""
import math
import os
import re
import sys
from pathlib import Path

import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle, Rectangle

sys.dont_write_bytecode = True
case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path.insert(0, str(root/"foam_cases/common"))

import parameters
from picture import blue, green, grey, plt, red, save

steady = 0.05  # the flow has settled from then on [s]
spheres, constant = 1.4, 0.58  # k and C of Beverloo's law


class Run:
    def __init__(self, name):
        self.folder = case/"variants"/name
        self.p = parameters.read(self.folder/"system/caseParameters", self.folder/"system/caseDerived")
        rows = np.loadtxt(self.folder/"postProcessing/powderBalance/0/powderBalance.dat")
        self.t, self.mass, self.out = rows[:, 0], rows[:, 1], rows[0, 4] - rows[:, 1]

    def rate(self):
        late = self.t >= steady
        return np.polyfit(self.t[late], self.out[late], 1)[0]


def bulkDensity(p):
    """Of the bed at rest, without its lowest and highest layers."""
    rows = np.loadtxt(case/"preparation/bed.dump", skiprows=9)
    z, r, m = rows[:, 3], rows[:, 4], rows[:, 5]
    top = np.quantile(z, 0.99)

    def below(height):  # of a sphere that the plane cuts, what is below
        h = np.clip(height - z + r, 0, 2*r)
        return np.sum(m*h*h*(3*r - h)/(4*r**3))
    return (below(0.7*top) - below(0.2*top))/(0.5*top*p["binWidth"]**2)


def parcels(folder):
    """Centres at the last time."""
    times = [t for t in folder.iterdir() if re.fullmatch(r"\d+\.\d+", t.name)]
    last = max(times, key=lambda t: float(t.name))
    text = (last/"lagrangian/powder/positions").read_text()
    rows = re.findall(r"^\(([^()]+)\) \d+$", text, re.M)
    return float(last.name), np.array([row.split() for row in rows], float)


def beverloo(runs, density):
    scale = density*math.sqrt(9.81)
    free = np.array([run.p["orifice"] - spheres*run.p["parcelDiameter"] for run in runs])
    rates = np.array([run.rate() for run in runs])
    exponent = np.polyfit(np.log(free), np.log(rates), 1)[0]
    print(f"bulk density {density:.0f} kg/m3\n   D [mm]   Beverloo   measured [g/s]       C")
    for run, x, W in zip(runs, free, rates):
        print(f"{1e3*run.p['orifice']:9.0f}{1e3*constant*scale*x**2.5:11.2f}{1e3*W:11.2f}"
              f"{W/(scale*x**2.5):14.3f}")
    print(f"exponent of D - 1.4 d: {exponent:.2f}, expected 2.5; C expected 0.55 to 0.65")

    fig, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for run, colour in zip(runs, (green, blue, red)):
        name = f"D = {1e3*run.p['orifice']:.0f} mm"
        left.plot(run.t, 1e3*run.out, color=colour, lw=1.6, label=name)
    left.set(xlabel="time [s]", ylabel="powder that ran out [g]", xlim=(0, runs[0].t[-1]),
             ylim=(0, None))
    left.legend(frameon=False)
    x = np.linspace(5e-3, 18e-3, 50)
    right.fill_between(1e3*x, 550*scale*x**2.5, 650*scale*x**2.5, color="0.9", lw=0,
                       label="Beverloo, C = 0.55 to 0.65")
    right.plot(1e3*x, 1e3*constant*scale*x**2.5, color=blue, lw=1.6, label="C = 0.58")
    right.plot(1e3*free, 1e3*rates, "o", ms=6, mfc="white", color=red, label="runs")
    right.set(xlabel="D - 1.4 d [mm]", ylabel="discharge [g/s]", xscale="log", yscale="log")
    right.set_xticks([5, 7, 10, 14, 18], ["5", "7", "10", "14", "18"])
    right.set_xticks([], minor=True)
    right.legend(frameon=False, loc="upper left")
    save(fig, case, "beverloo.png")


def withAir(runs):
    """By name; the first one without air."""
    fig, axes = plt.subplots(1, 4, figsize=(13, 4.2), layout="constrained",
                             width_ratios=(1.5, 1, 1, 1))
    print("\nfine powder, D = 10 mm      discharge [g/s]   of that without air")
    first = next(iter(runs.values()))
    for (name, run), colour, panel in zip(runs.items(), (red, blue, green), axes[1:]):
        print(f"{name:28s}{1e3*run.rate():15.2f}{run.rate()/first.rate():22.2f}")
        axes[0].plot(run.t, 1e3*run.out, color=colour, lw=1.8, label=name)
        section(panel, run, name, colour)
    axes[0].set(xlabel="time [s]", ylabel="powder that ran out [g]", xlim=(0, first.t[-1]),
                ylim=(0, None))
    axes[0].legend(frameon=False)
    axes[1].set_ylabel("height [mm]")
    save(fig, case, "air.png")


def section(axes, run, name, colour):
    """Parcels near the middle plane, hopper and tray, at the end."""
    p, mm = run.p, 1e3
    t, x = parcels(run.folder)
    r = 0.5*p["parcelDiameter"]
    near = x[np.abs(x[:, 1]) < 1.2*r]
    near = near[np.argsort(-np.abs(near[:, 1]))]
    axes.add_collection(PatchCollection([Circle((mm*c[0], mm*c[2]), mm*r) for c in near],
                                        facecolor=colour, edgecolor="white", lw=0.2, alpha=0.85))
    half, hole, thick = mm*p["half"], mm*p["orifice"]/2, mm*p["plateThickness"]
    for side in (-1, 1):
        axes.fill([side*hole, side*half, side*half, side*hole], [0, 0, -thick, -thick],
                  color=grey, lw=0)
        axes.add_patch(Rectangle((side*(half + 0.5) - 0.5, 0), 1, mm*p["airHigh"], color=grey))
    if p["lid"] == "closed":
        axes.add_patch(Rectangle((-half - 1, mm*p["airHigh"]), 2*half + 2, 1, color=grey))
    axes.set(xlim=(-half - 1, half + 1), ylim=(mm*p["airLow"], mm*p["airHigh"] + 1),
             aspect="equal", xlabel="x [mm]")
    axes.set_title(f"{name}, {1e3*t:.0f} ms", fontsize=10)


def main():
    dry = [Run(f"noAir{d}") for d in (8, 12, 16)]
    beverloo(dry, bulkDensity(dry[0].p))
    withAir({"no air": Run("vacuum"), "open lid": Run("open"), "closed lid": Run("closed")})


if __name__ == "__main__":
    main()
