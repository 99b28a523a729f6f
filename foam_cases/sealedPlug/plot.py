#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The falling plug against the closed form: a table and pictures/plug.png.

Reads postProcessing/ and the last time, here and in noAir/.
"""
import math
import os
import re
import sys
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path.insert(0, str(root/"foam_cases/common"))

import parameters
from picture import blue as withAir
from picture import plt, save
from picture import red as noAir



def gidaspowHuilin(alpha, re):
    """Drag coefficient times Reynolds number, of spheres in a bed of void fraction alpha."""
    share = np.arctan(150*1.75*(0.8 - alpha))/np.pi + 0.5
    dense = 200*(1 - alpha)/alpha + 7/3*re
    dilute = alpha**-1.65*np.maximum(24/alpha*(1 + 0.15*(alpha*re)**0.687), 0.44*re)
    return share*dense + (1 - share)*dilute


def slope(p, alpha, v):
    """Pressure over height [Pa/m] where the plug moves at v and the air must pass through it:
    alpha_p B v/alpha^2, with B = 3/4 Cd Re mu/d^2."""
    d, nu = p["grainDiameter"], p["airViscosity"]
    B = 0.75*gidaspowHuilin(alpha, v/alpha*d/nu)*nu*p["airDensity"]/d**2
    return (1 - alpha)*B*v/alpha**2


def endSpeed(p, alpha):
    """At which the pressure drop of all layers, of these void fractions, carries the plug."""
    low, high = 0.0, 1.0
    weight = np.sum(1 - alpha)*p["grainDensity"]*abs(p["gravityZ"])
    for _ in range(60):
        middle = 0.5*(low + high)
        if np.sum(slope(p, alpha, middle)) < weight:
            low = middle
        else:
            high = middle
    return low


def field(name):
    """Along the column, at the last time."""
    times = [t for t in case.iterdir() if re.fullmatch(r"0\.\d+", t.name)]
    text = (max(times, key=lambda t: float(t.name))/name).read_text()
    return np.array(re.search(r"internalField[^(]*\(([^)]*)\)", text)[1].split(), float)


def speed(p, folder):
    parcels = 8*(p["plugHigh"] - p["plugLow"])
    mass = parcels*math.pi/6*(p["coarseGraining"]*p["grainDiameter"])**3*p["grainDensity"]
    rows = np.loadtxt(folder/"postProcessing/momentumBudget/0/momentumBudget.dat")
    return rows[:, 0], -rows[:, 6]/mass, mass


def response(t, v, end):
    """When 1 - 1/e of the end speed is reached; between steps log(1 - v/end) is a straight line."""
    i = np.argmax(v > end*(1 - 1/math.e))
    low, high = (math.log(1 - x/end) for x in (v[i - 1] if i else 0.0, v[i]))
    before = t[i - 1] if i else 0.0
    return before + (t[i] - before)*(-1 - low)/(high - low)


def main():
    p = parameters.read(case/"system/caseParameters")
    void = 1 - 8*math.pi/6*(p["coarseGraining"]*p["grainDiameter"]/p["cellSize"])**3
    t, v, mass = speed(p, case)
    probed = np.loadtxt(case/"postProcessing/cavity/0/p")
    pressure = p["airDensity"]*probed[:, 1]

    sharp = endSpeed(p, np.array([void]))
    mapped = endSpeed(p, field("voidFraction"))
    below = mass*abs(p["gravityZ"])/p["cellSize"]**2
    tau = mapped/abs(p["gravityZ"])
    table = [("end speed, sharp plug [mm/s]", 1e3*sharp, 1e3*v[-1], None),
             ("end speed, plug as on the mesh [mm/s]", 1e3*mapped, 1e3*v[-1], 2),
             ("pressure below [Pa]", below, pressure[-1], 1),
             ("response time [ms]", 1e3*tau, 1e3*response(t, v, mapped), 5)]
    tFree, vFree, _ = speed(p, case/"noAir")
    free = 1e3*abs(p["gravityZ"])*tFree[-1]
    table.append(("no air: speed at the end [mm/s]", free, 1e3*vFree[-1], 1))
    print(f"void fraction {void:.4f}\n{'':38s}expected  measured  error [%]  allowed [%]")
    for name, expected, measured, allowed in table:
        error = 100*(measured/expected - 1)
        print(f"{name:38s}{expected:8.3f}{measured:10.3f}{error:11.2f}"
              + ("        -" if allowed is None else f"{allowed:9d}")
              + ("   FAILED" if allowed and abs(error) > allowed else ""))

    fig, (left, middle, right) = plt.subplots(1, 3, figsize=(12, 3.9), layout="constrained")
    fine = np.linspace(0, t[-1], 300)
    rise = 1 - np.exp(-fine/tau)
    left.plot(1e3*fine, 1e3*mapped*rise, color=withAir, lw=1.6, label="closed form")
    left.plot(1e3*t[::3], 1e3*v[::3], "o", ms=4, mfc="white", color=withAir, label="run, with air")
    left.plot(1e3*fine, 1e3*abs(p["gravityZ"])*fine, color=noAir, lw=1.6, label="free fall")
    left.plot(1e3*tFree[::3], 1e3*vFree[::3], "s", ms=4, mfc="white", color=noAir,
              label="run, no air")
    left.set(xlabel="time [ms]", ylabel="speed of the plug [mm/s]", ylim=(0, 4*1e3*mapped),
             xlim=(0, 1e3*t[-1]))
    left.legend(frameon=False, loc="center right")
    middle.plot(1e3*fine, below*rise, color=withAir, lw=1.6, label="closed form")
    middle.plot(1e3*probed[::3, 0], pressure[::3], "o", ms=4, mfc="white", color=withAir,
                label="run")
    middle.axhline(below, color="0.6", lw=0.8, ls="--", zorder=0)
    middle.annotate("weight of the plug over its area", (1e3*t[-1], below), xytext=(-2, 4),
                    textcoords="offset points", ha="right", color="0.4", fontsize=9)
    middle.set(xlabel="time [ms]", ylabel="pressure below the plug [Pa]", ylim=(0, 1.15*below),
               xlim=(0, 1e3*t[-1]))
    middle.legend(frameon=False, loc="lower right")

    z = (np.arange(p["columnHeight"]) + 0.5)*p["cellSize"]
    fall = np.trapezoid(v, t) if hasattr(np, "trapezoid") else np.trapz(v, t)
    ends = [p[key]*p["cellSize"] - fall for key in ("plugLow", "plugHigh")]
    drop = slope(p, field("voidFraction"), v[-1])*p["cellSize"]
    line = np.cumsum(drop[::-1])[::-1] - 0.5*drop
    right.axhspan(1e3*ends[0], 1e3*ends[1], color="0.92", lw=0)
    right.annotate("plug", (0.97*below, 0.5e3*sum(ends)), ha="right", va="center", color="0.4")
    right.annotate("sealed air", (0.02*below, 1e3*0.5*ends[0]), va="center", color="0.4")
    right.plot(line, 1e3*z, color=withAir, lw=1.6, label="drag law")
    right.plot(p["airDensity"]*field("p"), 1e3*z, "o", ms=3.5, mfc="white", color=withAir,
               label="run")
    right.set(xlabel=f"pressure after {1e3*t[-1]:.0f} ms [Pa]", ylabel="height [mm]",
              ylim=(0, 1e3*p["columnHeight"]*p["cellSize"]), xlim=(0, 1.1*below))
    right.legend(frameon=False, loc="upper right")
    save(fig, case, "plug.png")


if __name__ == "__main__":
    main()
