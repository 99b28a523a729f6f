#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a die filling run, and of its no-air twin if there is one.

    ./plot.py            writes pictures/filling.png, pictures/section.png, pictures/time.png
    ./plot.py --summary  prints the filling ratios, the stage table and where the pictures lie

Reads postProcessing/ and VTK/ (foamToVTK -legacy -ascii), here and in variants/noAir.
"""
import json
import os
import sys
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.path[:0] = [str(case/"plotting"), str(root/"foam_cases/common"), str(root/"studies/measures"), str(case/"scene")]

import resolution
import runTables
import section
import uniformity
from picture import blue as withAir
from picture import grey, plt, save
from picture import red as noAir
from runFolder import cells, derived, instants, parcels, stations, table

twin = case/"variants/noAir"


def moments(folder):
    """Name -> (time, filling ratio) as the run found them."""
    rows = runTables.joined(folder, "fillingRatio/*/moments.dat")
    return {moment: (float(time), float(value)) for time, moment, value in rows}


def filling(d):
    fig, (upper, lower) = plt.subplots(2, 1, figsize=(7, 6.4), sharex=True, layout="constrained")
    for folder, colour, name in ((case, withAir, "with air"), (twin, noAir, "no air")):
        ratio, flow = table(folder, "fillingRatio"), table(folder, "dieFlowRate")
        if ratio is None:
            continue
        t = 1e3*ratio[:, 0]
        upper.plot(t, 100*ratio[:, 1], color=colour, lw=2)
        upper.annotate(f"{name}: {100*ratio[-1, 1]:.1f} %", (t[-1], 100*ratio[-1, 1]),
                       xytext=(-4, 6 if ratio[-1, 1] < 0.85 else -18),
                       textcoords="offset points", ha="right", color=colour,
                       fontweight="bold", bbox=dict(facecolor="white", lw=0, pad=1))
        if flow is not None:
            lower.plot(1e3*flow[:, 0], 1e9*flow[:, 1], color=colour, lw=1.6)
    for at, text in stations(d):
        for axes in (upper, lower):
            axes.axvline(1e3*at, color="0.75", lw=0.8, zorder=0)
        upper.annotate(text, (1e3*at, 1.01), xycoords=("data", "axes fraction"), rotation=12,
                       ha="left", va="bottom", fontsize=8, color=grey)
    upper.set(ylabel="filling ratio [%]", ylim=(0, 105), xlim=(0, 1e3*d["endTime"]))
    lower.set(ylabel="powder into the die [mm³/s]", xlabel="time [ms]")
    lower.set_ylim(bottom=min(0, lower.get_ylim()[0]))
    save(fig, case, "filling.png")


def sections(d):
    shots = instants(case)
    if not shots:
        return
    rows = (len(shots) + 1)//2
    fig, panels = plt.subplots(rows, 2, figsize=(13, 3.3*rows), squeeze=False, sharex=True,
                               sharey=True, layout="constrained")
    for axes, files in zip(panels.flat, shots):
        dots = shot(axes, d, *files)
    for axes in panels[-1]:
        axes.set_xlabel("x [mm]")
    for axes in panels[:, 0]:
        axes.set_ylabel("z [mm]")
    fig.colorbar(dots, ax=panels, label="parcel speed [m/s]", shrink=0.6, pad=0.01)
    save(fig, case, "section.png")


def shot(axes, d, air, powder):
    """A section along the middle: parcels by speed, air by arrows, walls as they stand."""
    mm = section.MM
    dots = section.parcels(axes, *parcels(powder), fastest=0.3)

    t, c, data = cells(air)
    axes.set_title(f"t = {1e3*t:.0f} ms", loc="left", fontsize=11, fontweight="bold")
    u = data["U"]
    free = data["solid"][:, 0] < 0.5
    level = c[np.argmin(np.abs(c[:, 1])), 1]
    every = lambda x: np.unique(np.round(x/d["cellSize"] - 0.5), return_inverse=True)[1] % 2 == 0
    here = free & (np.abs(c[:, 1] - level) < 0.3*d["cellSize"]) & every(c[:, 0]) & every(c[:, 2])
    arrows = axes.quiver(mm*c[here, 0], mm*c[here, 2], u[here, 0], u[here, 2], color=withAir,
                         scale=0.2, scale_units="x", width=0.0022, angles="xy", zorder=3)
    axes.quiverkey(arrows, 0.93, 1.04, 0.25, "air 0.25 m/s", labelpos="W", color=withAir)

    section.walls(axes, d, t)
    section.die(axes, d, uniformity.triangles(case, d))
    axes.set(xlim=(mm*d["xLow"], mm*d["xHigh"]), aspect="equal",
             ylim=(-mm*d["dieDepth"] - section.FLOOR, mm*d["zHigh"]))
    return dots


def time():
    runs = [(folder, name) for folder, name in ((case, "with air"), (twin, "no air"))
            if (folder/"postProcessing/time.json").is_file()]
    fig, axes = plt.subplots(figsize=(7, 0.9 + 0.42*8), layout="constrained")
    reports = [(json.loads((folder/"postProcessing/time.json").read_text()), name)
               for folder, name in runs]
    stages = list(reports[0][0]["stages"])
    height = 0.8/len(reports)
    for i, (report, name) in enumerate(reports):
        seconds = [report["stages"].get(stage, {"mean": 0})["mean"] for stage in stages]
        at = np.arange(len(stages)) + (i - 0.5*(len(reports) - 1))*height
        axes.barh(at, seconds, 0.92*height, color=(withAir, noAir)[name == "no air"],
                  label=f"{name}: {report['wallSeconds']:.0f} s on {report['ranks']} rank"
                  + "s"*(report["ranks"] > 1))
        for y, s in zip(at, seconds):
            if s >= 0.05:
                axes.annotate(f"{s:.1f} s  {100*s/report['wallSeconds']:.0f} %", (s, y),
                              xytext=(3, 0), textcoords="offset points", va="center", fontsize=8)
    axes.set_yticks(range(len(stages)), stages)
    axes.invert_yaxis()
    axes.set(xlabel="wall time [s]")
    axes.margins(x=0.18)
    axes.legend(frameon=False, loc="lower right")
    save(fig, case, "time.png")


def summary():
    print("\nFilling ratio [%]" + " "*20 + "with air   no air")
    runs = [found for found in map(moments, (case, twin)) if found]
    names = {"frontCrossed": "the shoe's front wall has crossed",
             "rearArrives": "its rear wall arrives", "end": "the shoe has passed: the result"}
    for key, text in names.items():
        print(f"  {text:<35}" + "".join(
            f"{100*run[key][-1]:8.1f}" if key in run else "       -" for run in runs))
    d = derived(case)
    if sentence := resolution.told(d, d):
        print(sentence)
    report = json.loads((case/"postProcessing/time.json").read_text())
    print(f"\nTime by stage, with air, {report['ranks']} ranks [s]")
    for stage, seconds in report["stages"].items():
        print(f"  {stage:<12}{seconds['mean']:8.1f}  {100*seconds['mean']/report['wallSeconds']:5.1f} %")
    print(f"  {'wall time':<12}{report['wallSeconds']:8.1f}")
    print("\nPictures: " + ", ".join(str(p) for p in sorted((case/"pictures").glob("*.png"))))


def main():
    if "--summary" in sys.argv:
        summary()
        return
    d = derived(case)
    filling(d)
    sections(d)
    time()


if __name__ == "__main__":
    main()
