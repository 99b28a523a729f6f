#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pictures/heap.png: the box as it begins to rise, on its way, and the heap with the lines whose slopes are
its angles.

    ./plot.py [FOLDER]     of a run, as variants/NAME; without, of the run in this folder
"""
import os
import sys
from pathlib import Path

import numpy as np

case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.dont_write_bytecode = True
sys.path[:0] = [str(root/"studies/calibration"), str(root/"foam_cases/common")]

import scene
import surfaceLine
from parcelPicture import parcels
from picture import mm, plt, red, save


def draw(axes, grains):
    """Parcels by speed, those of the table in grey."""
    glued = grains["type"] == 2
    parcels(axes, grains, glued, facecolors="0.6")
    drawn = parcels(axes, grains, ~glued)
    drawn.set_clim(0, 0.1)
    axes.set(aspect="equal", ylabel="z [mm]")
    return drawn


def main():
    folder = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else case
    lifted = scene.frames(folder, "lift")
    heap = scene.dump(folder/"postProcessing/heap.dump")
    powder = scene.powder(folder/"postProcessing/heap.dump")
    found = surfaceLine.heap(*(powder[key] for key in ("x", "y", "z", "radius")))

    states = [("the box begins to rise", scene.dump(lifted[0])), ("on its way", scene.dump(lifted[-2])),
              (f"the heap: {found['left']:.1f} and {found['right']:.1f} degrees, "
               f"{found['angle']:.1f} ± {found['error']:.1f}", heap)]
    reach = mm*1.15*np.quantile(np.abs(powder["x"]), 0.998)
    heights = [mm*max(grains["z"]) + 0.6 for _, grains in states]
    fig, panels = plt.subplots(3, 1, figsize=(8, 8*sum(heights)/(2*reach) + 1.8), sharex=True,
                               layout="constrained", height_ratios=heights)
    for axes, (words, grains), height in zip(panels, states, heights):
        drawn = draw(axes, grains)
        axes.set(xlim=(-reach, reach), ylim=(-0.5, height))
        axes.set_title(words, fontsize=10)
    for (slope, foot), side in zip(found["lines"], (-1, 1)):
        levels = np.array([0.2, 0.8])*found["height"]
        panels[-1].plot(mm*(levels - foot)/slope, mm*levels, color=red, lw=2)
    panels[-1].set_xlabel("x [mm]")
    fig.colorbar(drawn, ax=panels, label="speed [m/s]", shrink=0.5)
    save(fig, case, "heap.png")
    print(f"static angle of repose {found['angle']:.2f} +- {found['error']:.2f} deg (left "
          f"{found['left']:.2f}, right {found['right']:.2f})")


if __name__ == "__main__":
    main()
