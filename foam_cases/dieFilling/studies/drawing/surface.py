# SPDX-License-Identifier: GPL-3.0-or-later
"""The powder's surface in the die at the end, for each k, from the folders of runs that were kept."""
import math
import statistics

import matplotlib.pyplot as plt

import cloud
import figures as engine
import keptRuns
from badInput import BadInput

BINS = 10  # as many as the function object surfaceSlope has


def draw(table, chosen, study):
    found = profiles(table, chosen, study)
    fig, axes = plt.subplots(figsize=(engine.WIDTH, 0.75*engine.WIDTH), layout="constrained")
    length, depth = (1e3*next(iter(found.values()))[0][key] for key in ("dieLength", "dieDepth"))
    wall = dict(color="0.75", lw=0, zorder=0)
    edge = 0.06*length
    for x, width, z, height in ((-edge, edge, -depth, depth), (length, edge, -depth, depth),
                                (-edge, length + 2*edge, -depth - edge, edge)):
        axes.add_patch(plt.Rectangle((x, z), width, height, **wall))
    for i, (k, (_, surfaces)) in enumerate(sorted(found.items())):
        x, z, error = averaged(surfaces, length/BINS)
        axes.errorbar(x, z, error, color=engine.COLOURS[i % 7], marker=engine.MARKERS[i % 7],
                      ls=engine.DASHES[i % 7], lw=1.1, ms=4, mec="white", mew=0.4, capsize=2,
                      elinewidth=0.8, label=f"$k$ = {k:g}")
    axes.set(xlabel="$x$ [mm]", ylabel="surface height $z$ [mm]", xlim=(-edge, length + edge),
             ylim=(-depth - edge, 0.32*depth))
    axes.legend(frameon=False, fontsize=8, handlelength=2.8, ncol=2, loc="upper center")
    return fig


def averaged(surfaces, width):
    """Over the packings [mm]: middle of each bin, height, its standard error."""
    x, z, error = [], [], []
    for number in range(BINS):
        heights = [1e3*surface[number] for surface in surfaces if surface[number] is not None]
        if heights:
            x.append((number + 0.5)*width)
            z.append(statistics.fmean(heights))
            error.append(statistics.stdev(heights)/math.sqrt(len(heights)) if len(heights) > 1 else 0)
    return x, z, error


def profiles(table, chosen, study):
    """k -> (parameters, [heights of each bin of a packing])."""
    found = {}
    for parameters, home in keptRuns.found(table, chosen, study):
        others = found.setdefault(parameters["coarseGraining"], (parameters, []))
        alone(others[0], parameters)
        try:
            others[1].append(surface(cloud.parcels(home), parameters))
        except cloud.NoPowder as reason:
            raise BadInput(str(reason))
    return found


def alone(one, other):
    differ = keptRuns.differing(one, other)
    if differ:
        raise BadInput(f"Kept runs of one coarseGraining differ in {', '.join(differ)}: choose by "
                       f"--where {differ[0]}=VALUE.")


def surface(points, p):
    """The highest point of a parcel in each bin, as surfaceSlope takes it."""
    radius = 0.5*p["coarseGraining"]*p["particleDiameter"]
    heights = [None]*BINS
    for x, _, z in points:
        if 0 <= x <= p["dieLength"] and -p["dieDepth"] <= z <= 0:
            number = min(int(x/p["dieLength"]*BINS), BINS - 1)
            if heights[number] is None or z + radius > heights[number]:
                heights[number] = z + radius
    return heights
