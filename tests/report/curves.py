# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what a test has measured along the line of the theory that it is compared with."""
import math

from matplotlib.ticker import LogLocator

from contents import Figure
from figures import close, ink, plt, png

ACROSS = 3  # panels beside each other


def draw(test):
    curves = test.curves
    across = min(ACROSS, len(curves))
    down = math.ceil(len(curves)/across)
    fig, panels = plt.subplots(down, across, figsize=(3.1*across, 2.5*down), squeeze=False, layout="constrained")
    for axes, curve in zip(panels.flat, curves):
        panel(axes, curve)
    for axes in panels.flat[len(curves):]:
        axes.axis("off")
    first = " ".join(test.text.split("\n\n")[0].split())
    return Figure(f"{test.name}.png", f"**{test.name}**: {first}", png(fig))


def panel(axes, curve):
    axes.plot(*zip(*curve.theory), color=ink, lw=1.1)
    axes.plot(*zip(*curve.measured), "o", color=close, ms=3.8, mec="white", mew=0.4)
    axes.set_title(curve.title, fontsize=9)
    axes.set_xlabel(curve.x, fontsize=8)
    axes.set_ylabel(curve.y, fontsize=8)
    axes.tick_params(labelsize=7.5)
    if curve.log:
        logarithmic(axes, [x for x, _ in curve.measured])
    else:
        axes.ticklabel_format(scilimits=(-3, 4))
        for axis in (axes.xaxis, axes.yaxis):
            axis.get_offset_text().set_fontsize(7.5)


def logarithmic(axes, places):
    """With numbers where something was measured, and 1, 2, 5 upwards."""
    axes.set(xscale="log", yscale="log")
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_xticks(places, [f"{x:.3g}" for x in places])
    axes.minorticks_off()
