# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels side by side with the same axes: a measure against a group, or against another measure."""
from textwrap import fill
from types import SimpleNamespace

import matplotlib.pyplot as plt

import figures as engine
import shownAs
import tableFile
from badInput import BadInput
from groups import GROUPS

ACROSS, WIDE = 3, 7.2  # panels in a row; width of a printed page [in]
FULL = 90  # [%], what counts as full
TICKS = 4  # values of a study that are written at the axis
# What must vary along an axis.
ALONG = {"dpOverHd": ("particleDiameter",), "shoeReynolds": ("shoeSpeed",),
         "densityRatio": ("particleDensity",), "LdOverHd": ("dieLength", "dieDepth")}


def draw(table, figure, where):
    needColumns(table, figure, [figure.y])
    rows = usable(table, where, figure.y)
    needVariation(table, figure, rows)
    lines = figure.lines if varies(rows, figure.lines) else None
    panels = figure.panels if varies(rows, figure.panels) else None
    nothingElseVaries(table, rows, figure)
    chosen = SimpleNamespace(x=figure.x, y=figure.y, lines=lines, where=where)
    names = [""] if not panels else sorted({table.value(row, panels) for row in rows})
    all_ = sorted({table.value(row, lines) for row in rows}) if lines else [""]

    fig, axes, top = sheet(len(names))
    for name, panel in zip(names, axes):
        here = where + [f"{panels}={shownAs.text(name)}"] if panels else where
        found = dict(tableFile.lines(table, SimpleNamespace(**{**vars(chosen), "where": here})))
        engine.plot(panel, table, chosen, [(line, found.get(line, [])) for line in all_])
        if panels:
            panel.set_title(table.nameOf(panels, name), fontsize=9)
    finish(fig, axes, top, table, figure, rows)
    return fig


def sheet(count):
    """A figure with as many panels, and one low one above for the legend."""
    across = min(count, ACROSS)
    down = -(-count//across)
    fig = plt.figure(figsize=(engine.WIDTH if count == 1 else WIDE/ACROSS*max(across, 2),
                              0.3 + 2.4*down), layout="constrained")
    grid = fig.add_gridspec(down + 1, across, height_ratios=[0.1] + [1]*down)
    top = fig.add_subplot(grid[0, :])
    top.axis("off")
    axes = []
    for i in range(count):
        axes.append(fig.add_subplot(grid[1 + i//across, i % across],
                                    sharex=axes[0] if axes else None,
                                    sharey=axes[0] if axes else None))
    return fig, axes, top


def finish(fig, axes, top, table, figure, rows):
    across = min(len(axes), ACROSS)
    for i, panel in enumerate(axes):
        panel.tick_params(labelleft=i % across == 0, labelbottom=i + across >= len(axes))
        if i % across == 0:
            panel.set_ylabel(fill(table.label(figure.y), 32) + ofWhat(table, figure.y, rows))
        if i + across >= len(axes):
            panel.set_xlabel(table.label(figure.x))
        if figure.y.startswith("fillingRatio"):
            panel.axhline(FULL, color="0.7", lw=0.8, zorder=0)
    axes[0].margins(0.08)
    axes[0].ticklabel_format(axis="both", scilimits=(-3, 4), useMathText=True)
    axes[0].locator_params(axis="x", nbins=4 if across > 1 else 6)
    values = sorted({table.value(row, figure.x) for row in rows})
    if len(values) <= TICKS and figure.x in GROUPS:
        axes[0].set_xticks(values, [f"{value:.4g}" for value in values])
    if getattr(figure, "fromZero", True):
        axes[0].set_ylim(bottom=0)
    handles = {}
    for panel in axes:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    if handles:
        columns = len(handles) if len(axes) > 1 else min(len(handles), 3)
        top.legend(list(handles.values()), list(handles), loc="center", ncol=columns,
                   frameon=False, fontsize=8, handlelength=2.8, columnspacing=1.2)


def ofWhat(table, y, rows):
    """A slice's flow is not that of the die."""
    widths = {table.value(row, "sliceWidth") for row in rows} if "sliceWidth" in table.columns else ()
    if "FlowRate" not in y or len(widths) != 1 or not min(widths) > 0:
        return ""
    return f"\ninto a slice of {1e3*min(widths):g} mm"


def scatter(table, figure, where):
    needColumns(table, figure, [figure.y, figure.x])
    rows = [row for row in usable(table, where, figure.y) if row[figure.x] != ""]
    if len({row[figure.x] for row in rows}) < 2:
        raise BadInput(f"{table.name} has fewer than two values of {figure.x}; the study "
                       f"{figure.study} gives it.")
    marks = figure.marks if varies(rows, figure.marks) else None
    names = sorted({table.value(row, marks) for row in rows}) if marks else [""]
    fig, axes, top = sheet(1)
    for i, name in enumerate(names):
        own = [row for row in rows if not marks or table.value(row, marks) == name]
        (x, dx), (y, dy) = (numbers(table, own, key) for key in (figure.x, figure.y))
        axes[0].errorbar(x, y, dy, dx, color=engine.COLOURS[i % 7], marker=engine.MARKERS[i % 7],
                         ls="", ms=4.5, mec="white", mew=0.4, capsize=2, elinewidth=0.8,
                         clip_on=False, label=table.nameOf(marks, name) if marks else None)
    finish(fig, axes, top, table, figure, rows)
    x = numbers(table, rows, figure.x)[0]
    if min(x) > 0 and max(x) > 10*min(x):
        axes[0].set_xscale("log")
    else:
        axes[0].set_xlim(left=0)
    return fig


def numbers(table, rows, key):
    scale = shownAs.scale(table.about.get(key, {}))
    values = [table.value(row, key) for row in rows]
    wrong = next((value for value in values if isinstance(value, str) or value != value), None)
    if wrong is not None:
        raise BadInput(f"'{key}' is no number in {table.name}, it is '{wrong}': choose other rows by "
                       "--where, or empty that cell.")
    errors = [tableFile.number(row.get(f"{key}.error") or "0") for row in rows]
    return [scale*value for value in values], [scale*error for error in errors]


def needColumns(table, figure, measures):
    parameters = GROUPS[figure.x][1] if figure.x in GROUPS else ()
    for key in [*measures, *parameters]:
        if key not in table.columns:
            raise BadInput(f"{table.name} has no column '{key}'; the study {figure.study} gives it.")


def usable(table, where, y):
    rows = [row for row in table.chosen(where) if row[y] != ""]
    if not rows:
        raise BadInput(f"{table.name} has no number '{y}' to draw: see the column 'status'.")
    return rows


def varies(rows, key):
    return key in rows[0] and len({row[key] for row in rows}) > 1


def needVariation(table, figure, rows):
    along = ALONG[figure.x]
    if not any(varies(rows, key) for key in along):
        raise BadInput(f"{' and '.join(along)} {'has' if len(along) == 1 else 'have'} one value in "
                       f"{table.name}; the study {figure.study} varies what is needed.")


def nothingElseVaries(table, rows, figure):
    known = {*ALONG[figure.x], figure.lines, figure.panels}
    keys = list(table.columns)
    keys = keys[keys.index("variant") + 1:keys.index("status")] if "status" in keys else []
    if sameParcels(table, rows):
        known.add("coarseGraining")
    others = [key for key in keys if key not in known and varies(rows, key)]
    if others:
        raise BadInput(f"{', '.join(others)} {'varies' if len(others) == 1 else 'vary'} too in "
                       f"{table.name}: choose by --where {others[0]}=VALUE.")


def sameParcels(table, rows):
    """As large in all rows, to a thousandth: grains of 40 and 60 um in parcels of k = 10 and 6.6667, as the studies of size have."""
    if not {"coarseGraining", "particleDiameter"} <= set(rows[0]):
        return False
    sizes = [table.value(row, "coarseGraining")*table.value(row, "particleDiameter") for row in rows]
    return max(sizes) < 1.001*min(sizes)
