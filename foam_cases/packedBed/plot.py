#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of the bed against superficial velocity: pictures/pressureDrop.png, and a table.

Reads postProcessing/ and the fields at the end of each step in velocity. The formulas are evaluated
with the void fraction that the mesh sees, layer by layer, and with the velocity of the fluid relative
to the spheres: soft ones rise a little under less load, slowly when they carry hardly any.
"""
import math
import re
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

case = Path(__file__).resolve().parent
GRAVITY = 9.81
ink, found, theory, grey = "#22303c", "#2166ac", "#b2182b", "0.45"
plt.rcParams.update({"font.size": 10, "axes.edgecolor": ink, "axes.labelcolor": ink,
                     "axes.spines.top": False, "axes.spines.right": False, "text.color": ink,
                     "xtick.color": ink, "ytick.color": ink, "savefig.dpi": 160})


def parameters():
    numbers = {}
    for name in ("caseParameters", "caseDerived"):
        for line in (case/"system"/name).read_text().splitlines():
            words = line.split("//")[0].replace(";", " ").split()
            if len(words) == 2:
                try:
                    numbers[words[0]] = float(words[1])
                except ValueError:
                    pass
    return numbers


def table(name):
    """Columns of a function object's table; vectors are three of them."""
    path, = (case/f"postProcessing/{name}/0").glob("*FieldValue.dat")
    text = path.read_text()
    rows = [line.replace("(", " ").replace(")", " ").split() for line in text.splitlines()
            if not line.startswith("#")]
    return np.array(rows, float)


def cells(time, name):
    """Values of a scalar field in all cells."""
    text = (case/time/name).read_text()
    return np.array(re.search(r"List<scalar>\s+\d+\s*\(([^()]*)\)", text).group(1).split(), float)


def times():
    folders = [p.name for p in case.iterdir() if re.fullmatch(r"0\.\d+", p.name)]
    return sorted(folders, key=float)


def layers(time, geometry):
    """Mean void fraction of each layer of cells, upwards."""
    layer, volume = geometry
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
    volume = p["particles"]*math.pi/6*p["particleDiameter"]**3
    return volume*(p["particleDensity"] - p["fluidDensity"])*GRAVITY/p["area"]


def minimumFluidisation(profile, p):
    low, high = 0.0, 1.0
    while high - low > 1e-9:
        middle = 0.5*(low + high)
        low, high = (middle, high) if drop(profile, middle, p) < netWeight(p) else (low, middle)
    return low


def history(p):
    """Time, superficial velocity, pressure drop without the weight of the fluid."""
    gradient, flow = table("pressureDrop"), table("flow")
    drop = -p["fluidDensity"]*(gradient[:, 3]/p["area"] + GRAVITY*p["height"])
    return flow[:, 0], -flow[:, 1]/p["area"], drop


def carried(p, t, pressure, ends, window=0.003):
    """Mean pressure drop over a while up to each end, and what it should be: net weight less what floor
    and wall hold, and what speeds the spheres up, over area [Pa]."""
    walls = np.loadtxt(case/"postProcessing/walls.dat")
    budget = np.loadtxt(case/"postProcessing/momentumBudget/0/momentumBudget.dat")
    rows = []
    for end in ends:
        inside = lambda time: (time > end - window) & (time < end + 1e-9)
        force = walls[inside(walls[:, 0]), 1:].sum(axis=1).mean()
        steps = np.flatnonzero(inside(t))
        first, last = steps[0] - 1, steps[-1]
        gain = (budget[last, 6] - budget[first, 6])/(t[last] - t[first])
        mean = np.average(pressure[steps], weights=np.diff(t)[steps - 1])
        rows.append((mean, netWeight(p) + (gain - force)/p["area"]))
    return rows


def main():
    p = parameters()
    stops = times()
    height = cells(stops[-1], "Cz")
    geometry = (np.floor(height/p["layerHeight"]).astype(int), cells(stops[-1], "V"))
    profiles = [layers(time, geometry) for time in stops]
    rise = [rising(time, int(p["layers"]), p["layerHeight"]) for time in stops]
    t, U, pressure = history(p)
    at = [np.argmin(np.abs(t - float(time))) for time in stops]
    balance = carried(p, t, pressure, t[at])
    weight, onset = netWeight(p), minimumFluidisation(profiles[0], p)

    print(f"\n  net weight over area {weight:.2f} Pa; U_mf {1e3*onset:.2f} mm/s by Ergun and the bed's "
          "void fraction\n\n  Pressure drop [Pa] at the end of each step, and its mean over the last 3 ms."
          "\n  Ergun: with the spheres as they move; carried: net weight less what floor and wall\n"
          "  hold, and what speeds the spheres up\n"
          f"{'t [ms]':>8}{'U [mm/s]':>10}{'dp':>10}{'Ergun':>9}{'error':>9}{'mean dp':>10}"
          f"{'carried':>9}{'error':>9}")
    for time, i, profile, v, (mean, load) in zip(stops, at, profiles, rise, balance):
        formula = drop(profile, U[i] - v, p)
        print(f"{1e3*float(time):8.0f}{1e3*U[i]:10.2f}{pressure[i]:10.2f}{formula:9.2f}"
              f"{100*(pressure[i]/formula - 1):8.2f}%{mean:10.2f}{load:9.2f}"
              f"{100*(mean/load - 1):8.2f}%")

    fig, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
    mm = 1e3
    speeds = np.linspace(0, mm*U.max(), 50)
    axes.plot(speeds, [drop(profiles[0], s/mm, p) for s in speeds], color=theory, lw=1.2)
    axes.annotate("Ergun, bed as in the beginning", (0.5*mm*onset, 0.5*weight), xytext=(8, -14),
                  textcoords="offset points", color=theory)
    axes.axhline(weight, color=grey, lw=1.2)
    axes.annotate(f"net weight over area, {weight:.2f} Pa", (0, weight), xytext=(2, 4),
                  textcoords="offset points", color=grey)
    axes.axvline(mm*onset, color=grey, lw=0.8, ls=":")
    axes.annotate("$U_{mf}$", (mm*onset, 0), xytext=(4, 4), textcoords="offset points", color=grey)
    axes.plot(mm*U, pressure, color=found, lw=0.8, alpha=0.6)
    axes.plot(mm*U[at], pressure[at], "o", color=found, ms=5, label="end of each step in velocity")
    axes.legend(frameon=False, loc="upper left")
    axes.set(xlabel="superficial velocity [mm/s]", ylabel="pressure drop of the bed [Pa]",
             xlim=(0, None), ylim=(0, 1.3*weight))
    (case/"pictures").mkdir(exist_ok=True)
    fig.savefig(case/"pictures/pressureDrop.png")


if __name__ == "__main__":
    main()
