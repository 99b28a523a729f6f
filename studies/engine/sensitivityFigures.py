# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of what a measure depends on: parameters by their swing, moments of reading, and two parameters together."""
import re
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np

import figures
from accuracyFigures import BLUE, GREY, ORANGE, Axis
from accuracyJudge import Number, combined
from sensitivityRank import ranking
from shownAs import isNumber
from tableFile import superscripts

WIDE, ROW = 6.3, 0.38  # [in]
SMALL = 6.5  # points, of what is written beside a mark


def tornado(choices, measure, target, folder):
    """Strongest on top; a mark for each value, blue if it differs from the reference by more than scatter."""
    ranks = ranking(choices, measure)
    if not ranks:
        return []
    axis = Axis(choices, measure)
    fig, axes = plt.subplots(figsize=(WIDE, 1 + ROW*len(ranks)), layout="constrained")
    own, error = choices.reference.values[measure], choices.reference.errors[measure]
    lines(axes, axis, own, error, target)
    marks = [row(axes, choices, measure, place, one) for place, one in enumerate(ranks)]
    axes.set_yticks(range(len(ranks)), [one.parameter for one in ranks])
    axes.set_ylim(len(ranks) - 0.4, -0.7)
    axes.margins(x=0.08)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(choices.table.label(measure))
    axes.plot([], [], color=BLUE, marker="o", ls="", ms=4.5, label="resolved")
    axes.plot([], [], color=GREY, marker="o", ls="", ms=4.5, label="not resolved")
    axes.legend(frameon=False, fontsize=8, ncols=4, loc="lower right", bbox_to_anchor=(1, 1), handlelength=1.6,
                columnspacing=1, handletextpad=0.5)
    fig.draw_without_rendering()  # else it is not known where the marks are
    for place, own in enumerate(marks):
        label(axes, place, own)
    return figures.save(fig, folder/f"{measure}.tornado")


def lines(axes, axis, own, error, target):
    axes.axvline(axis.scale*own, color=figures.ink, lw=0.9, zorder=1, label="reference ± 2 errors")
    if error is not None:
        axes.axvspan(axis.scale*(own - 2*error), axis.scale*(own + 2*error), color="0.9", lw=0, zorder=0)
    if target is not None:
        axes.axvline(axis.scale*target, color=ORANGE, lw=1.3, ls="--", zorder=1,
                     label=f"target {axis.scale*target:.4g} {axis.valueUnit}".rstrip())


def row(axes, choices, measure, place, one):
    """Marks to be labelled: value, words."""
    axis, reference = Axis(choices, measure), choices.reference
    own = Number(reference.values[measure], reference.errors[measure])
    axes.plot([axis.scale*one.lowest.y, axis.scale*one.highest.y], [place, place], color="0.75", lw=3,
              solid_capstyle="butt", zorder=1.5)
    found = []
    for point in one.points:
        isOwn = point.x == reference.parameters[one.parameter]
        change = Number(point.y - own.value, combined(point.error, own.error))
        colour = figures.ink if isOwn else BLUE if change.resolved else GREY
        axes.errorbar(axis.scale*point.y, place, xerr=axis.scale*(point.error or 0), color=colour,
                      marker="s" if isOwn else "o", ms=3.5 if isOwn else 4.5, mec="white", mew=0.4, capsize=2,
                      elinewidth=0.9, zorder=3)
        words = choices.table.written(one.parameter, point.x, superscripts)
        found.append((axis.scale*point.y, words))
    return found


def label(axes, place, marks):
    """Words above the marks of a row, moved apart where they would overlap; then a line tells whose they are."""
    points = axes.figure.dpi/72
    marks = sorted(marks)
    own = [axes.transData.transform((x, place))[0]/points for x, _ in marks]
    widths = [0.6*SMALL*len(re.sub(r"\$\^{(.*?)}\$", r"\1", words)) + 4 for _, words in marks]
    for (x, words), start, end in zip(marks, own, apart(own, widths)):
        moved = abs(end - start) > 2
        axes.annotate(words, (x, place), xytext=(end - start, 6), textcoords="offset points", fontsize=SMALL,
                      ha="center", va="bottom", zorder=5,
                      bbox=dict(boxstyle="square,pad=0.05", fc="white", ec="none", alpha=0.75),
                      arrowprops=dict(arrowstyle="-", lw=0.4, color=GREY, shrinkA=0, shrinkB=2) if moved else None)


def apart(middles, widths):
    """Middles of words in a line, moved until none overlaps its neighbour."""
    middles = list(middles)
    for _ in range(200):
        for i in range(len(middles) - 1):
            lacking = 0.5*(widths[i] + widths[i + 1]) - (middles[i + 1] - middles[i])
            if lacking > 0:
                middles[i] -= 0.5*lacking
                middles[i + 1] += 0.5*lacking
    return middles


def moments(choices, measures, target, folder):
    """One quantity read at several moments: the reference, behind it all variants."""
    axes_ = [Axis(choices, measure) for measure in measures]
    fig, axes = plt.subplots(figsize=(WIDE, 0.9 + 0.5*len(measures)), layout="constrained")
    if target is not None:
        axes.axvline(axes_[0].scale*target, color=ORANGE, lw=1.3, ls="--", zorder=1,
                     label=f"target {axes_[0].scale*target:.4g} {axes_[0].valueUnit}".rstrip())
    for place, (measure, axis) in enumerate(zip(measures, axes_)):
        some = [axis.scale*variant.values[measure] for variant in choices.variants
                if variant.values[measure] is not None]
        axes.plot(some, [place]*len(some), marker="|", ms=11, color=GREY, ls="", zorder=2,
                  label="" if place else "all variants")
        own, error = choices.reference.values[measure], choices.reference.errors[measure]
        if own is not None:
            axes.errorbar(axis.scale*own, place, xerr=axis.scale*(error or 0), color=BLUE, marker="s", ms=5,
                          mec="white", mew=0.4, capsize=2.5, zorder=3, ls="", label="" if place else "reference")
            axes.annotate(f"{axis.scale*own:.3g}", (axis.scale*own, place), xytext=(0, 7), fontsize=8,
                          textcoords="offset points", ha="center")
    axes.set_yticks(range(len(measures)), [fill(axis.words, 30) for axis in axes_], fontsize=8)
    axes.set_ylim(len(measures) - 0.5, -0.6)
    axes.tick_params(axis="y", length=0)
    symbols = ", ".join(dict.fromkeys(axis.symbol for axis in axes_))
    axes.set_xlabel(symbols + (f" [{axes_[0].valueUnit}]" if axes_[0].valueUnit else ""))
    axes.legend(frameon=False, fontsize=8, ncols=3, loc="lower left", bbox_to_anchor=(0, 1))
    return figures.save(fig, folder/"moments")


def map_(grid, measure, target, folder):
    """Cells of equal size, the value in each; between their middles the target's contour, by straight lines."""
    choices, axis = grid.choices, Axis(grid.choices, measure)
    points = grid.points(measure)
    z = axis.scale*np.array([[point.y for point in row] for row in points])
    error = axis.scale*np.array([[point.error or 0 for point in row] for row in points])
    fig, axes = plt.subplots(figsize=(1.4 + 0.95*len(grid.x), 1.3 + 0.55*len(grid.y)), layout="constrained")
    image = axes.imshow(z, origin="lower", aspect="auto", cmap="Blues", zorder=0)
    bright = z < z.min() + 0.6*(z.max() - z.min())
    for (j, i), value in np.ndenumerate(z):
        words = f"{value:.3g}" + (f"\n± {error[j, i]:.2g}" if error[j, i] else "")
        axes.text(i, j, words, ha="center", va="center", fontsize=7, color=figures.ink if bright[j, i] else "white")
    if target is not None and all(map(isNumber, grid.x + grid.y)) and min(z.shape) > 1:
        contours(axes, axis, z, error, axis.scale*target)
    written = [[choices.table.written(key, value, superscripts) for value in values]
               for key, values in zip(grid.keys, (grid.x, grid.y))]
    axes.set_xticks(range(len(grid.x)), written[0], fontsize=8)
    axes.set_yticks(range(len(grid.y)), written[1], fontsize=8)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.set(xlabel=grid.keys[0], ylabel=grid.keys[1])
    bar = fig.colorbar(image, ax=axes, pad=0.02)
    bar.set_label(axis.symbol + (f" [{axis.valueUnit}]" if axis.valueUnit else ""))
    bar.outline.set_visible(False)
    return figures.save(fig, folder/f"{measure}.map")


def contours(axes, axis, z, error, target):
    """Of the target, and where the measure is two of its errors off."""
    x, y = np.meshgrid(range(z.shape[1]), range(z.shape[0]))
    for off, width, dashes in ((0, 1.8, "-"), (-2, 0.9, "--"), (2, 0.9, "--")):
        level = z - target + off*error
        if level.min() < 0 < level.max() and (off == 0 or error.any()):
            axes.contour(x, y, level, [0], colors=ORANGE, linewidths=width, linestyles=dashes, zorder=2)
            word = f"target {target:.4g} {axis.valueUnit}".rstrip() if off == 0 else "2 errors off" if off < 0 else ""
            axes.plot([], [], color=ORANGE, lw=width, ls=dashes, label=word or "_")
    axes.legend(frameon=False, fontsize=8, ncols=2, loc="lower left", bbox_to_anchor=(0, 1))
