# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws how much of what is allowed each number uses, and how far it is from what is expected."""
import io
import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from contents import Figure
from swarm import swarm

ink, close, bound, bad = "#22303c", "#2166ac", "#9aa5af", "#b2182b"
plt.rcParams.update({"font.size": 10, "axes.edgecolor": ink, "axes.labelcolor": ink,
                     "axes.spines.top": False, "axes.spines.right": False, "text.color": ink,
                     "xtick.color": ink, "ytick.color": ink, "savefig.dpi": 160})
LEAST, MOST = 1e-5, 10.0  # shares of what is allowed, at the ends of the axis
GUTTER = LEAST/8  # room on its left for the number of those below
SMALL, FAR = 1e-4, 10.0  # deviations: linear below, at the edge beyond


def draw(tests):
    some = [test for test in tests if any(map(compared, test.lines))]
    return [margins(tests)] + ([deviations(some)] if some else [])


def strips(tests, right):
    """Axes with a strip for each test, room on the right for words."""
    fig, axes = plt.subplots(figsize=(9, 1.4 + 0.48*len(tests)))
    fig.subplots_adjust(left=0.2, right=right, top=1 - 0.45/fig.get_figheight(),
                        bottom=0.65/fig.get_figheight())
    axes.set_yticks(range(len(tests)), [test.name for test in tests])
    axes.set_ylim(len(tests) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    for y in range(0, len(tests), 2):
        axes.axhspan(y - 0.5, y + 0.5, color="0.96", lw=0, zorder=0)
    return fig, axes


def points(axes, y, lines, value, place):
    """The lines of one test; `place` of a value is where it lies along the strip, 0 .. 1."""
    heights = swarm([place(value(line.row)) for line in lines])
    for line, height in zip(lines, heights):
        axes.plot(value(line.row), y + height, clip_on=False, **look(line.row))


def look(row):
    if not row.good:
        return dict(marker="X", ms=8, color=bad, mec="white", mew=0.4, zorder=4)
    if row.kind == "shown":
        return dict(marker="o", ms=4.5, color="white", mec=ink, mew=0.9, zorder=3)
    return dict(marker="o", ms=5, color=close if row.kind == "within" else bound, mec="white",
                mew=0.4, zorder=2)


def margins(tests):
    fig, axes = strips(tests, 0.67)
    axes.set(xscale="log", xlim=(GUTTER, MOST), xlabel="share of what is allowed that is used")
    axes.axvspan(1, MOST, color=bad, alpha=0.08, lw=0, zorder=0.5)
    axes.axvline(1, color=bad, lw=1.2)
    axes.axvline(LEAST, color="0.75", lw=0.8, ls=":")
    axes.set_xticks([10**n for n in range(-5, 2)])
    axes.minorticks_off()
    share = lambda row: min(max(row.used, LEAST), MOST)
    place = lambda x: math.log(x/GUTTER)/math.log(MOST/GUTTER)
    words = dict(xycoords=("axes fraction", "data"), va="center", fontsize=8)
    for y, test in enumerate(tests):
        lines = [line for line in test.lines if line.row.verdict != "shown"]
        seen = [line for line in lines if line.row.used >= LEAST or not line.row.good]
        points(axes, y, seen, share, place)
        if len(lines) > len(seen):
            axes.annotate(f"{len(lines) - len(seen)}", (place(LEAST)/2, y), ha="center", **words)
        if test.missing:
            axes.axhspan(y - 0.5, y + 0.5, color=bad, alpha=0.2, lw=0, zorder=0.4)
        text, colour = nearest(seen, test.missing)
        axes.annotate(text, (1.03, y), color=colour, annotation_clip=False, **words)
    top = dict(xycoords="axes fraction", va="bottom", fontsize=8)
    axes.annotate("less", (place(LEAST)/2, 1.01), ha="center", **top)
    axes.annotate("missed", (place(1) + 0.015, 1.01), color=bad, **top)
    axes.annotate("nearest to its limit", (1.03, 1.01), **top)
    axes.annotate("error, of the tolerance", (place(LEAST) + 0.02, 1.01), color=close, **top)
    axes.annotate("number, of its bound", (place(LEAST) + 0.36, 1.01), color=bound, **top)
    return Figure("margins.png", "Each number of each test by the share of what is allowed that it "
                  "uses: blue, its error over the tolerance; grey, a number over its bound (or a "
                  "bound from below over the number). Above one it is missed: a red cross. The "
                  "counts on the left are of numbers that use less than the axis shows.", png(fig))


def nearest(lines, missing):
    """What to write beside a test."""
    if missing:
        wrong = sum(not line.row.good for line in lines)
        return ("no result: " + ", ".join(run.variant for run in missing)
                + (f"\nand {wrong} missed" if wrong else "")), bad
    if not lines:
        return "", ink
    row = max((line.row for line in lines), key=lambda row: (not row.good, row.used))
    used = f"{row.used:.2g}" if math.isfinite(row.used) else "missed"
    return f"{used}   {row.case}\n{shortened(row.quantity)}", ink if row.good else bad


def shortened(text):
    return text if len(text) <= 42 else text[:40].rstrip() + " …"


def deviations(tests):
    """Numbers with an expected value, signed, those that are shown only among them."""
    fig, axes = strips(tests, 0.97)
    far = [abs(held(line.row)) for test in tests for line in test.lines if compared(line)]
    edge = max(0.1, 2*max(far))
    axes.set_xscale("symlog", linthresh=SMALL, linscale=0.6)
    axes.set(xlim=(-edge, edge), xlabel="measured over expected, less one")
    axes.axvline(0, color=ink, lw=0.8)
    decades = [10.0**n for n in range(-4, 2) if 10.0**n <= edge]
    ticks = [-x for x in reversed(decades)] + [0] + decades
    axes.set_xticks(ticks, [f"{100*x:+g} %" if x else "0" for x in ticks])
    axes.minorticks_off()
    axes.annotate("hollow: shown, not judged", (1, 1.01), xycoords="axes fraction", ha="right",
                  va="bottom", fontsize=8)
    place = lambda x: axes.transAxes.inverted().transform(axes.transData.transform((x, 0)))[0]
    for y, test in enumerate(tests):
        points(axes, y, [line for line in test.lines if compared(line)], held, place)
    return Figure("deviations.png", "How far the numbers are from those expected, where these are "
                  "not zero and no bounds; linear within 0.01 %, logarithmic beyond. Hollow: "
                  "shown, not judged. Red cross: missed.", png(fig))


def compared(line):
    return line.row.kind in ("within", "shown") and line.row.expected != 0


def held(row):
    """Deviation from the expected number, no further than the axis goes."""
    ratio = (row.measured - row.expected)/abs(row.expected)
    return min(max(ratio, -FAR), FAR) if math.isfinite(ratio) else FAR


def png(fig):
    buffer = io.BytesIO()
    fig.savefig(buffer, format="png", metadata={"Software": None})
    plt.close(fig)
    return buffer.getvalue()
