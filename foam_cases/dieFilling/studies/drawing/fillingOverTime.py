# SPDX-License-Identifier: GPL-3.0-or-later
"""Filling ratio and powder flow over time, a line for each variant, from the folders of runs that were kept."""
import matplotlib.pyplot as plt
import numpy as np

import figures as engine
import keptRuns
import runFolder
from badInput import BadInput

FLOW_OVER = 2e-3  # the flow is the mean over so long [s]
INSTANTS = 400


def draw(table, chosen, study):
    found = variants(table, chosen, study)
    fig, (upper, lower) = plt.subplots(2, 1, figsize=(1.3*engine.WIDTH, 1.5*engine.WIDTH), sharex=True,
                                       layout="constrained")
    for i, (name, homes) in enumerate(found.items()):
        t, ratio, flow = averaged(homes)
        looks = dict(color=engine.COLOURS[i % 7], ls=engine.DASHES[i % 7], lw=1.2)
        line(upper, 1e3*t, 100*ratio, label=name, **looks)
        line(lower, 1e3*t, 1e9*flow, **looks)
    # The shoe goes the same way in all, or their moments are drawn beside each other.
    for at in sorted({at for homes in found.values() for at, _ in runFolder.stations(runFolder.derived(homes[0]))}):
        for axes in (upper, lower):
            axes.axvline(1e3*at, color="0.8", lw=0.7, zorder=0)
    upper.set(ylabel="filling ratio $δ$ [%]", ylim=(0, 105))
    lower.set(ylabel="powder into the die [mm$^3$/s]", xlabel="time [ms]")
    upper.legend(frameon=False, fontsize=7, handlelength=3)
    return fig


def line(axes, t, values, label=None, **looks):
    """The mean over packings, and its standard error as a band."""
    mean = values.mean(axis=0)
    axes.plot(t, mean, label=label, **looks)
    if len(values) > 1:
        error = values.std(axis=0, ddof=1)/np.sqrt(len(values))
        axes.fill_between(t, mean - error, mean + error, color=looks["color"], alpha=0.25, lw=0)


def variants(table, chosen, study):
    """What varies in it, as words -> folders of its packings."""
    runs = keptRuns.found(table, chosen, study)
    keys = sorted({key for one, _ in runs for key in keptRuns.differing(runs[0][0], one)},
                  key=list(runs[0][0]).index)
    found = {}
    for parameters, home in runs:
        name = ", ".join(table.nameOf(key, parameters[key]) for key in keys) or "all runs"
        found.setdefault(name, []).append(home)
    return found


def averaged(homes):
    """Instants [s]; filling ratio [-] and flow [m3/s] of each packing at them."""
    tables = [columns(home) for home in homes]
    t = np.linspace(0, min(ratio[-1, 0] for ratio, _ in tables), INSTANTS)
    ratios = np.array([np.interp(t, ratio[:, 0], ratio[:, 1]) for ratio, _ in tables])
    flows = np.array([smoothed(t, flow[:, 0], flow[:, 1]) for _, flow in tables])
    return t, ratios, flows


def smoothed(t, times, flow):
    """Mean over FLOW_OVER around each instant, by what has flowed until then."""
    volume = np.concatenate([[0], np.cumsum(0.5*(flow[1:] + flow[:-1])*np.diff(times))])
    low, high = (np.clip(t + side*FLOW_OVER/2, times[0], times[-1]) for side in (-1, 1))
    return (np.interp(high, times, volume) - np.interp(low, times, volume))/(high - low)


def columns(home):
    found = [runFolder.table(home, name) for name in ("fillingRatio", "dieFlowRate")]
    if any(rows is None for rows in found):
        raise BadInput(f"{home} has no postProcessing/fillingRatio or dieFlowRate: run that variant again.")
    return found
