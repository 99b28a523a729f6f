#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Height and pressure drop of the bed in time, and the spheres in the end: pictures/bed.png, and means.

Reads postProcessing/ and VTK/ (foamToVTK -legacy -ascii) here, postProcessing/ of variants/blend, and
dpmFoam.dat, whichever of them are there.
"""
import sys
from xml.etree import ElementTree

import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

sys.dont_write_bytecode = True

import bed
from picture import blue, green, grey, plt, red, save

case = bed.case
colours = {"ErgunWenYu": blue, "GidaspowHuilin": green, "DPMFoam": red}


def runs():
    """Name, (time, height), (time, pressure drop without the weight of the gas)."""
    found = []
    for folder in (case, case/"variants/blend"):
        if (folder/"postProcessing/bedHeight.dat").is_file():
            p = bed.numbers(folder)
            found.append((p["dragLaw"], bed.heights(folder), bed.drops(folder, p)))
    if (case/"dpmFoam.dat").is_file():
        table = np.loadtxt(case/"dpmFoam.dat")
        found.append(("DPMFoam", table[:, :2], table[:, ::2]))
    return found


def spheres():
    """Position, velocity and diameter of the last picture that foamToVTK wrote, or None."""
    files = sorted((case/"VTK/lagrangian/powder").glob("powder_*.vtp"),
                   key=lambda path: int(path.stem.split("_")[-1]))
    if not files:
        return None
    data = {}
    for array in ElementTree.parse(files[-1]).iter("DataArray"):
        values = np.array((array.text or "").split(), float)
        data[array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents", 1)))
    return data["Points"], data["U"], data["d"][:, 0]


def snapshot(axes, p):
    found = spheres()
    if not found:
        axes.set_axis_off()
        return
    x, v, d = found
    front = np.argsort(x[:, 0])
    mm = 1e3
    dots = PatchCollection([Circle((mm*q[1], mm*q[2]), mm*r/2) for q, r in zip(x[front], d[front])],
                           cmap="YlOrBr", edgecolor="#5a4632", lw=0.1)
    dots.set_array(np.linalg.norm(v[front], axis=1))
    dots.set_clim(0, 1)
    axes.add_collection(dots)
    axes.set(xlim=(-500*p["width"], 500*p["width"]), ylim=(0, 1e3*p["height"]), aspect="equal",
             xlabel="y [mm]", ylabel="z [mm]")
    axes.figure.colorbar(dots, ax=axes, label="speed [m/s]", shrink=0.5)


def main():
    p = bed.numbers(case)
    expected, start = bed.netWeight(case, p), p["meansFrom"]
    fig = plt.figure(figsize=(10, 5.6), layout="constrained")
    grid = fig.add_gridspec(2, 2, width_ratios=(2.2, 1))
    upper = fig.add_subplot(grid[0, 0])
    lower = fig.add_subplot(grid[1, 0], sharex=upper)
    print(f"\n  Means from {start:g} s on {'height [mm]':>20}{'pressure drop [Pa]':>21}   (expected "
          f"{expected:.0f})")
    for name, height, drop in runs():
        upper.plot(height[:, 0], 1e3*height[:, 1], color=colours[name], lw=1.4, label=name)
        lower.plot(drop[:, 0], drop[:, 1], color=colours[name], lw=0.6, alpha=0.8)
        print(f"  {name:<18}{1e3*bed.mean(height, start):19.2f}{bed.mean(drop, start):21.1f}"
              f"{100*(bed.mean(drop, start)/expected - 1):9.2f} %")
    lower.axhline(expected, color=grey, lw=1)
    lower.annotate("net weight over area", (0, expected), xytext=(2, 3), color=grey,
                   textcoords="offset points", fontsize=8)
    upper.set(ylabel="mean height of the spheres [mm]")
    lower.set(ylabel="pressure drop [Pa]", xlabel="time [s]", ylim=(0, 2*expected),
              xlim=(0, p["endTime"]))
    upper.legend(frameon=False, ncol=3, loc="upper right")
    snapshot(fig.add_subplot(grid[:, 1]), p)
    save(fig, case, "bed.png")


if __name__ == "__main__":
    main()
