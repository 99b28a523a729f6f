#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pictures/drum.png: the drum with the line whose slope is the angle, and the angle in time.

    ./plot.py [FOLDER]     of a run, as variants/NAME; without, of the run in this folder
"""
import math
import os
import sys
from pathlib import Path

import numpy as np
from matplotlib.patches import Circle

case = Path(__file__).resolve().parent
root = next((p for p in case.parents if (p/"liggghts_scripts").is_dir()), None) or Path(
    os.environ.get("INTERSTICE_ROOT") or sys.exit("INTERSTICE_ROOT is not set: source cmake/environment.sh of Interstice"))
sys.dont_write_bytecode = True
sys.path[:0] = [str(root/"studies/calibration"), str(root/"foam_cases/common")]

import parameters
import scene
import surfaceLine
from parcelPicture import parcels
from picture import blue, mm, plt, red, save


def line(grains, radius):
    return surfaceLine.inDrum(*(grains[key] for key in ("x", "y", "z", "radius")), radius)


def draw(axes, grains, radius):
    drawn = parcels(axes, grains)
    axes.add_patch(Circle((0, 0), mm*radius, fill=False, color="0.5", lw=1.5))
    slope, height = line(grains, radius)
    foot = -slope*height/(1 + slope**2)
    ends = foot + np.array([-0.5, 0.5])*radius/math.sqrt(1 + slope**2)
    axes.plot(mm*ends, mm*(height + slope*ends), color=red, lw=2)
    room = 1.05*mm*radius
    axes.set(aspect="equal", xlim=(-room, room), ylim=(-room, room), xlabel="x [mm]", ylabel="z [mm]")
    return drawn


def main():
    folder = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else case
    p = parameters.read(folder/"system/caseParameters")
    radius = 0.5*p["drumDiameter"]
    grains = [scene.dump(path) for path in scene.frames(folder, "frame")]
    angles = np.array([-surfaceLine.inDegrees(line(one, radius)[0], 0)[0] for one in grains])
    mean, error = surfaceLine.meanInTime(angles)

    fig, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    fig.colorbar(draw(left, grains[-1], radius), ax=left, label="speed [m/s]")
    turns = p["startTurns"] + p["measuredTurns"]*(np.arange(len(angles)) + 1)/len(angles)
    right.plot(turns, angles, color=blue, lw=1.2)
    right.axhline(mean, color=red, lw=1.6)
    right.axhspan(mean - error, mean + error, color=red, alpha=0.15, lw=0)
    right.set(xlabel="turns of the drum", ylabel="angle of the surface [degrees]",
              title=f"mean {mean:.1f} ± {error:.1f} degrees")
    right.title.set_fontsize(10)
    save(fig, case, "drum.png")
    print(f"dynamic angle of repose {mean:.2f} +- {error:.2f} deg, scatter in time "
          f"{angles.std(ddof=1):.2f} deg")


if __name__ == "__main__":
    main()
