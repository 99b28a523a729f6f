# SPDX-License-Identifier: GPL-3.0-or-later
"""The size from which on a die is full: measured, our plane, and the published Eq 21."""
import json
import math
import shutil
import subprocess
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt

import figures as engine
from badInput import BadInput
from groups import GROUPS

# Eq 21 of Materials 18 (2025) 3261: for 1, N_v and rho_p/rho_g.
PUBLISHED = (0.00256, 1.77202e-4, -1.05607e-6)
PROGRAM = "fillingModel"


def modelOf(table, chosen, study):
    """Series and plane of the file that is named, or of a fit to the table."""
    if chosen.model:
        return read(chosen.model)
    if not shutil.which(PROGRAM):
        raise BadInput(f"there is no program {PROGRAM} on the PATH; build it, or name the file of "
                       f"'{PROGRAM} fit TABLE.csv --output MODEL.json' by --model.")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder)/"model.json"
        fit = subprocess.run([PROGRAM, "fit", chosen.table, "--output", path], text=True,
                             capture_output=True)
        if fit.returncode != 0 or not path.is_file():
            said = " ".join((fit.stderr or fit.stdout).split())[:300]
            raise BadInput(f"'{PROGRAM} fit {chosen.table}' says: {said} The study {study} gives a "
                           "table that can be fitted.")
        return read(path)


def read(path):
    try:
        model = json.loads(path.read_text())
        plane = model["criticalSize"]
        points = [dict(reynolds=group("shoeReynolds", one), density=group("densityRatio", one),
                       measured=float(one["criticalSizeRatio"]), error=one["error"] or 0)
                  for one in model["series"]]
        found = dict(points=points, ours=[float(c) for c in plane["coefficients"]],
                     covariance=plane["covariance"], threshold=float(model["threshold"]))
        if len(found["ours"]) != 3 or not points:
            raise ValueError("3 coefficients and some series are wanted")
    except (OSError, ValueError, KeyError, TypeError) as reason:
        raise BadInput(f"{path} is no whole filling model ({reason}): write it again by "
                       f"'{PROGRAM} fit TABLE.csv --output {path.name}'.")
    return found


def group(name, series):
    _, needed, formula = GROUPS[name]
    return formula(*[float(series[key]) for key in needed])


def at(coefficients, reynolds, density):
    return sum(c*x for c, x in zip(coefficients, (1, reynolds, density)))


def errorAt(covariance, reynolds, density):
    """Standard error of the plane."""
    x = (1, reynolds, density)
    return math.sqrt(max(0, sum(x[i]*covariance[i][j]*x[j] for i in range(3) for j in range(3))))


def symbol(model):
    return f"$(d_p/h_D)_{{{100*model['threshold']:g}}}$"


def draw(model):
    """Against N_v, a colour for each density: measured with error bars, planes as lines."""
    fig, axes = plt.subplots(figsize=(1.5*engine.WIDTH, 0.9*engine.WIDTH), layout="constrained")
    points = model["points"]
    all_ = [point["reynolds"] for point in points]
    margin = 0.05*(max(all_) - min(all_)) or 1
    ends = (min(all_) - margin, max(all_) + margin)
    for i, density in enumerate(sorted({round(point["density"], 6) for point in points})):
        own = [point for point in points if abs(point["density"] - density) < 1e-5]
        colour = engine.COLOURS[i % 7]
        steps = [ends[0] + (ends[1] - ends[0])*step/40 for step in range(41)]
        ours = [at(model["ours"], x, density) for x in steps]
        error = [2*errorAt(model["covariance"], x, density) for x in steps]
        axes.fill_between(steps, [y - e for y, e in zip(ours, error)],
                          [y + e for y, e in zip(ours, error)], color=colour, alpha=0.15, lw=0)
        axes.plot(steps, ours, color=colour, lw=1.1)
        axes.plot(steps, [at(PUBLISHED, x, density) for x in steps], color=colour, lw=1, ls="--")
        axes.errorbar([p["reynolds"] for p in own], [p["measured"] for p in own],
                      [p["error"] for p in own], color=colour, marker=engine.MARKERS[i % 7], ls="",
                      ms=5, mec="white", mew=0.4, capsize=2.5, elinewidth=0.9,
                      label=rf"$\rho_p/\rho_g$ = {density:.4g}")
    axes.plot([], [], color="0.3", lw=1.1, label="our plane, two std. errors")
    axes.plot([], [], color="0.3", lw=1, ls="--", label="Eq 21")
    axes.set(xlabel=GROUPS["shoeReynolds"][0], ylabel=f"critical size ratio {symbol(model)}",
             xlim=ends)
    axes.set_ylim(bottom=0)
    axes.ticklabel_format(axis="y", scilimits=(-3, 4), useMathText=True)
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    return fig


def predicted(model):
    """What the planes say against what was measured; on the diagonal they agree."""
    fig, axes = plt.subplots(figsize=(engine.WIDTH, engine.WIDTH), layout="constrained")
    points = model["points"]
    measured = [point["measured"] for point in points]
    errors = [point["error"] for point in points]
    values = list(measured)
    for i, (coefficients, name) in enumerate(((model["ours"], "our plane"), (PUBLISHED, "Eq 21"))):
        y = [at(coefficients, point["reynolds"], point["density"]) for point in points]
        error = [errorAt(model["covariance"], point["reynolds"], point["density"]) if i == 0 else 0
                 for point in points]
        axes.errorbar(measured, y, error if i == 0 else None, errors, color=engine.COLOURS[i],
                      marker=engine.MARKERS[i], ls="", ms=5, mec="white", mew=0.4, capsize=2,
                      elinewidth=0.8, label=name)
        values += y
    low, high = min(values), max(values)
    ends = (max(0, low - 0.08*(high - low)), high + 0.08*(high - low))
    axes.plot(ends, ends, color="0.4", lw=0.9, zorder=0)
    axes.fill_between(ends, [0.97*end for end in ends], [1.03*end for end in ends], color="0.9",
                      lw=0, zorder=-1, label="within 3 %")
    axes.set(xlabel=f"measured {symbol(model)}", ylabel=f"predicted {symbol(model)}", xlim=ends,
             ylim=ends, aspect="equal")
    axes.ticklabel_format(axis="both", scilimits=(-3, 4), useMathText=True)
    axes.locator_params(nbins=5)
    axes.legend(frameon=False, fontsize=8, loc="upper left")
    return fig
