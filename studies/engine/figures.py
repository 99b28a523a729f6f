# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what a study found: a measure against a parameter or a group, with standard errors, one
line for each value of another parameter. For print: one column wide, told apart in grey too."""
from pathlib import Path
from textwrap import fill

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import shownAs
from badInput import BadInput

ink = "#22303c"
# Okabe and Ito's colours, but yellow, which is lost on paper.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
MARKERS, DASHES = "osD^vPX", ("-", "--", "-.", ":", (0, (5, 1)), (0, (3, 1, 1, 1, 1, 1)), (0, (1, 1)))
WIDTH = 3.5  # of a printed column [in]
plt.rcParams.update({"font.size": 9, "axes.edgecolor": ink, "axes.labelcolor": ink,
                     "axes.spines.top": False, "axes.spines.right": False, "text.color": ink,
                     "xtick.color": ink, "ytick.color": ink, "savefig.dpi": 300,
                     "svg.hashsalt": "study", "mathtext.default": "it"})


def draw(table, chosen, lines):
    fig, axes = plt.subplots(figsize=(WIDTH, 0.75*WIDTH), layout="constrained")
    plot(axes, table, chosen, lines)
    axes.set(xlabel=table.label(chosen.x), ylabel=fill(table.label(chosen.y), 32))
    axes.ticklabel_format(axis="both", scilimits=(-3, 4), useMathText=True)
    axes.margins(0.06)
    if chosen.lines:
        axes.legend(frameon=False, fontsize=8, handlelength=2.8)
    return fig


def plot(axes, table, chosen, lines):
    """Lines with error bars, in the order that they have: the same colour and mark in any panel."""
    scale = shownAs.scale(table.about.get(chosen.y, {}))
    for i, (name, points) in enumerate(lines):
        if not points:
            continue
        x, y, error = zip(*points)
        colour, marker = COLOURS[i % len(COLOURS)], MARKERS[i % len(MARKERS)]
        axes.errorbar(x, [scale*value for value in y], [scale*value for value in error],
                      color=colour, marker=marker, ls=DASHES[i % len(DASHES)], lw=1.1, ms=4.5,
                      mec="white", mew=0.4, capsize=2.5, elinewidth=0.9, clip_on=False,
                      label=table.nameOf(chosen.lines, name) if chosen.lines else None)


def save(fig, name):
    """NAME.png and NAME.svg, the same bytes from the same numbers."""
    paths = []
    for kind, metadata in (("png", {"Software": None}), ("svg", {"Date": None})):
        path = Path(f"{name}.{kind}")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            fig.savefig(path, metadata=metadata)
        except OSError as reason:
            raise BadInput(f"The figure cannot be written to {path}: {reason.strerror}; name another "
                           "place by -o.")
        paths.append(path)
    plt.close(fig)
    return paths
