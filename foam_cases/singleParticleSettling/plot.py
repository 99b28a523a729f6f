#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity of the falling grain against the path of the drag law: a table and pictures/velocity.png."""
import math
import os
import sys
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path.insert(0, str(root/"foam_cases/common"))

import parameters
from picture import blue, grey, plt, red, save

allowed = 0.5  # distance from the path [%]


# Drag coefficient times Reynolds number of a lone sphere.
def stokes(re):
    return 24.0


def schillerNaumann(re):
    return max(24*(1 + 0.15*re**0.687), 0.44*re)


def gidaspowHuilin(re):
    """Where there is no other grain, the blend still has a share of Ergun's law."""
    share = math.atan(150*1.75*(0.8 - 1))/math.pi + 0.5
    return share*7/3*re + (1 - share)*schillerNaumann(re)


laws = {"Stokes": stokes, "SchillerNaumann": schillerNaumann, "GidaspowHuilin": gidaspowHuilin}


def path(p, law, times):
    """Velocity downwards at these times, from rest, by Runge and Kutta's method."""
    d, rho, nu = p["grainDiameter"], p["fluidDensity"], p["fluidViscosity"]
    pull = abs(p["gravityZ"])*(1 - rho/p["grainDensity"])

    def rate(v):
        return pull - 0.75*law(v*d/nu)*rho*nu/d**2*v/p["grainDensity"]

    v, found = 0.0, []
    for before, t in zip([0.0, *times], times):
        h = (t - before)/20
        for _ in range(20):
            a = rate(v)
            b = rate(v + h/2*a)
            c = rate(v + h/2*b)
            v += h/6*(a + 2*b + 2*c + rate(v + h*c))
        found.append(v)
    return np.array(found)


def main():
    p = parameters.read(case/"system/caseParameters")
    rows = np.loadtxt(case/"postProcessing/momentumBudget/0/momentumBudget.dat")
    mass = math.pi/6*p["grainDiameter"]**3*p["grainDensity"]
    t, v = rows[:, 0], -rows[:, 6]/mass
    exact = {name: path(p, law, t) for name, law in laws.items()}
    expected = exact[p["dragLaw"]]
    error = 100*(v/expected - 1)

    print(f"drag law {p['dragLaw']}\n   time [s]   expected   measured [m/s]   error [%]")
    for moment in (0.01, 0.02, 0.05, 0.1, 0.2):
        i = np.argmin(np.abs(t - moment))
        print(f"{t[i]:11.2f}{expected[i]:11.6f}{v[i]:11.6f}{error[i]:17.3f}")
    worst = np.abs(error[t >= 0.01 - 1e-9]).max()
    print(f"largest error from 0.01 s on: {worst:.2f} %, allowed: {allowed} %"
          + ("" if worst <= allowed else "   FAILED"))

    fig, (upper, lower) = plt.subplots(2, 1, figsize=(6.4, 5.6), sharex=True, layout="constrained",
                                       height_ratios=(3, 1.2))
    for name, style in (("Stokes", ":"), ("SchillerNaumann", "--"), ("GidaspowHuilin", "-")):
        upper.plot(1e3*t, exact[name], style, color=blue if name == p["dragLaw"] else "0.55",
                   lw=1.6, label=f"path by {name}")
    upper.plot(1e3*t[4::5], v[4::5], "o", ms=4, mfc="white", color=red,
               label="demPimpleFoam, every fifth step")
    upper.set(ylabel="velocity downwards [m/s]", ylim=(0, 0.18))
    upper.legend(frameon=False, loc="lower right")
    lower.axhspan(-allowed, allowed, color="0.92", lw=0)
    lower.plot(1e3*t, error, ".", ms=3, color=red)
    lower.axhline(0, color=blue, lw=1)
    lower.set(ylabel="distance [%]", xlabel="time [ms]", xlim=(0, 1e3*t[-1]), ylim=(-1, 1))
    lower.annotate("allowed", (1e3*t[-1], allowed), xytext=(-2, 2), textcoords="offset points",
                   ha="right", color=grey, fontsize=8)
    save(fig, case, "velocity.png")


if __name__ == "__main__":
    main()
