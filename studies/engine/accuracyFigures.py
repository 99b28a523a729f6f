# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of what accuracy costs: changes against time, choices that are not beaten, what next."""
import re
import string
from textwrap import fill

import matplotlib.pyplot as plt

import figures
import shownAs
from accuracyJudge import difference, errorOfReference, fits, front, nextMinute
from shownAs import labelled
from tableFile import mathematics, readable, superscripts

BLUE, ORANGE, GREEN = figures.COLOURS[:3]
GREY = "0.6"
ACROSS, WIDE = 3, 7.2
LETTERS = string.ascii_lowercase


def draw(choices, measure, orders, folder):
    """Paths; what a table does not give is not drawn."""
    if choices.reference.values[measure] is None:
        return []
    found = fits(choices, measure, orders)
    steps = nextMinute(choices, measure, found)
    paths = figures.save(changes(choices, measure, found), folder/f"{measure}.changes")
    paths += figures.save(pareto(choices, measure, found), folder/f"{measure}.pareto")
    if steps:
        paths += figures.save(next_(choices, measure, steps), folder/f"{measure}.nextMinute")
    return paths


class Axis:
    """How a measure, and a difference of it, is written and scaled."""

    def __init__(self, choices, measure):
        about = choices.table.about.get(measure, {})
        self.scale, unit = shownAs.scale(about), shownAs.unit(about)
        self.valueUnit = superscripts(unit)
        self.unit = "percentage points" if unit == "%" else self.valueUnit
        symbol = mathematics(about.get("symbol", ""))
        self.symbol = symbol or readable(measure)
        self.words = about.get("text") or readable(measure)

    def label(self, what):
        return what + (f" [{self.unit}]" if self.unit else "")


def changes(choices, measure, found):
    """A panel a knob: change against the reference over time; grey is what scatter makes, dashed
    where the law tends to, green the exact answer."""
    axis = Axis(choices, measure)
    count = len(choices.knobs)
    across = min(count, ACROSS)
    down = -(-count//across)
    fig, panels = plt.subplots(down, across, figsize=(WIDE/ACROSS*max(across, 1.5), 0.35 + 2*down),
                               squeeze=False, layout="constrained")
    for panel in panels.flat[count:]:
        panel.axis("off")
    marks = []
    for i, (panel, key) in enumerate(zip(panels.flat, choices.knobs)):
        marks.append(onePanel(panel, choices, measure, axis, key, found.get(key)))
        if i + across >= count:
            panel.set_xlabel("time, over the reference's")
    fig.supylabel(axis.label(f"change of {axis.symbol}"), fontsize=9, color=figures.ink)
    fig.draw_without_rendering()  # else it is not known where the marks are
    for panel, own in zip(panels.flat, marks):
        label(panel, own, 7)
    return fig


def onePanel(panel, choices, measure, axis, key, fit):
    """Its marks, to be labelled: time, change, words."""
    own = [(choices.timeRatio(variant), choices.timeRatioError(variant), difference(choices, variant, measure),
            valueText(choices, key, variant.changes[key])) for variant in choices.knobs[key]]
    own = [one for one in own if one[0] is not None and one[2].value is not None]
    noise = axis.scale*max((2*change.error for _, _, change, _ in own if change.error is not None),
                           default=0)
    panel.axhspan(-noise, noise, color="0.92", lw=0, zorder=0)
    panel.axhline(0, color="0.7", lw=0.8, zorder=1)
    panel.set_title(key, fontsize=9)
    panel.plot(1, 0, marker="s", color=figures.ink, ms=4.5, ls="", zorder=4)
    for time, timeError, change, _ in own:
        colour = BLUE if change.resolved else GREY
        panel.errorbar(time, axis.scale*change.value, axis.scale*(change.error or 0), timeError, color=colour,
                       marker="o", ms=4.5, mec="white", mew=0.4, capsize=2.5, elinewidth=0.9, zorder=3)
    if measure in choices.exact:
        off = choices.exact[measure] - choices.reference.values[measure]
        panel.axhline(axis.scale*off, color=GREEN, lw=1, zorder=2)
    if fit and fit.holds:
        tendsTo(panel, axis, errorOfReference(choices, fit, key))
    marks = [(1, 0, 0, valueText(choices, key, choices.reference.parameters[key]))]
    marks += [(time, axis.scale*change.value, axis.scale*(change.error or 0), word)
              for time, _, change, word in own]
    low, high = min(time for time, *_ in marks), max(time for time, *_ in marks)
    spread = max(high - low, 0.4)
    panel.set_xlim((low + high)/2 - 0.68*spread, (low + high)/2 + 0.85*spread)
    panel.margins(y=0.12)
    return marks


def tendsTo(panel, axis, error):
    middle, half = -axis.scale*error.value, 2*axis.scale*(error.error or 0)
    panel.axhline(middle, color=ORANGE, lw=1, ls="--", zorder=2)
    panel.axhspan(middle - half, middle + half, color=ORANGE, alpha=0.15, lw=0, zorder=0.5)


def valueText(choices, key, value):
    """0.5 mm rather than 0.0005"""
    words = labelled(choices.table.about.get(key, {}), key, value).partition("=")[2]
    return re.sub(r"(\d)([mun]?m)$", r"\1 \2", words).replace(" um", " µm")


def label(axes, marks, size):
    """Words beside marks (x, y, error, word), where they lie on no other word, mark or error bar."""
    place = lambda x, y: axes.transData.transform((x, y))/(axes.figure.dpi/72)
    points = [place(x, y) for x, y, _, _ in marks]
    taken = []
    for (x, y, error, _), (left, _) in zip(marks, points):
        taken.append((left - 3, place(x, y - error)[1] - 3, left + 3, place(x, y + error)[1] + 3))
    for (x, y), (*at, _, word) in zip(points, marks):
        if not word:
            continue
        width, height = 0.6*size*len(word), size
        places = [(4, 3), (4, -height - 4), (-width - 4, 3), (-width - 4, -height - 4), (6, -height/2),
                  (-width/2, 7), (-width/2, -height - 7), (4, 12), (4, -height - 12), (4, 20)]
        boxes = [(x + dx, y + dy, x + dx + width, y + dy + height) for dx, dy in places]
        free = next((i for i, box in enumerate(boxes) if not any(overlap(box, b) for b in taken)), 0)
        taken.append(boxes[free])
        axes.annotate(word, at, xytext=places[free], textcoords="offset points", fontsize=size,
                      va="bottom", zorder=5).set_in_layout(False)


def overlap(one, other):
    return (one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3])


def pareto(choices, measure, found):
    """Distance from the exact or the best known value over time. What is below the scatter counts as the scatter:
    the front ends at the fastest choice that cannot be told from the truth."""
    axis = Axis(choices, measure)
    all_ = front(choices, measure, found)
    fig, axes = plt.subplots(figsize=(1.6*figures.WIDTH, 0.95*figures.WIDTH), layout="constrained")
    noise = axis.scale*next(choice.noise for choice in all_ if choice.variant is choices.reference)
    axes.axhspan(0, noise, color="0.92", lw=0, zorder=0, label="not told from 0")
    for best, colour, marker, words in ((False, GREY, "o", "beaten"), (True, BLUE, "D", "not beaten")):
        some = [choice for choice in all_ if choice.best == best]
        if some:
            own = [choice.variant.errors[measure] or 0 for choice in some]
            axes.errorbar([c.time for c in some], [axis.scale*abs(c.distance) for c in some],
                          [axis.scale*error for error in own], color=colour, marker=marker, ls="",
                          ms=5, mec="white", mew=0.4, capsize=2, elinewidth=0.8, label=words,
                          zorder=3 + best)
    some = sorted((c for c in all_ if c.best), key=lambda c: c.time)
    axes.step([c.time for c in some], [axis.scale*c.error for c in some], where="post", color=BLUE,
              lw=1, zorder=2)
    for letter, choice in zip(LETTERS, some):
        axes.plot([], [], ls="", label=fill(f"{letter}  {named(choices, choice.variant)}", 28))
    timeAxis(axes, [choice.time for choice in all_])
    axes.set_ylim(bottom=0)
    truth = "exact answer" if measure in choices.exact else "best known value"
    axes.set(xlabel="time, over the reference's",
             ylabel=fill(axis.label(f"distance of {axis.symbol} from the {truth}"), 36))
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    fig.draw_without_rendering()
    label(axes, [(c.time, axis.scale*abs(c.distance),
                  axis.scale*(c.variant.errors[measure] or 0),
                  LETTERS[some.index(c) % 26] if c.best else "")
                 for c in sorted(all_, key=lambda c: c.time)], 7)
    return fig


def named(choices, variant):
    return ", ".join(f"{key} {valueText(choices, key, value)}"
                     for key, value in variant.changes.items()) or "reference"


def timeAxis(axes, times):
    low, high = min(times), max(times)
    spread = max(high - low, 0.4)
    if not high > 5*low:
        axes.set_xlim(low - 0.08*spread, high + 0.12*spread)
        return
    axes.set_xscale("log")
    axes.set_xlim(low/1.15, high*1.15)
    ticks = [m*10.0**n for n in range(-4, 5) for m in (1, 2, 5)]
    ticks = [tick for tick in ticks if low/1.15 <= tick <= high*1.5]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)


def next_(choices, measure, steps):
    axis = Axis(choices, measure)
    fig, axes = plt.subplots(figsize=(1.5*figures.WIDTH, 0.8 + 0.36*len(steps)), layout="constrained")
    for i, step in enumerate(steps):
        rate = step.perMinute
        axes.barh(i, axis.scale*rate.value, 0.6, color=GREEN if step.gain.resolved else "0.82",
                  xerr=None if rate.error is None else axis.scale*rate.error,
                  error_kw=dict(elinewidth=0.9, capsize=2.5, ecolor=figures.ink))
    axes.set_yticks(range(len(steps)), [words(choices, step) for step in steps], fontsize=8)
    axes.invert_yaxis()
    axes.axvline(0, color=figures.ink, lw=0.8)
    axes.set_xlabel(f"error of {axis.symbol} less, per added minute\n[{axis.unit or '1'}/min]")
    if not all(step.gain.resolved for step in steps):
        axes.set_title("grey: not resolved", loc="right", fontsize=7, color="0.4")
    return fig


def words(choices, step):
    own = choices.reference.parameters[step.knob]
    old, new = (valueText(choices, step.knob, value) for value in (own, step.value))
    return f"{step.knob} {old} → {new}, {step.minutes:+.2g} min"
