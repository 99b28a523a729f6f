# SPDX-License-Identifier: GPL-3.0-or-later
"""accuracy.csv and accuracy.md: what each value of a knob changes and takes."""
import shownAs
from accuracyFit import LEAST
from accuracyJudge import difference, errorOfReference, fits, front, nextMinute, offExact
from badInput import BadInput
from shownAs import text
from tables import sheet


def write(choices, orders, folder):
    return save({"accuracy.csv": sheet(rows(choices)), "accuracy.md": markdown(choices, orders)}, folder)


def save(content, folder):
    """Files of a report, name -> words; their paths."""
    paths = []
    for name, words in content.items():
        path = folder/name
        try:
            folder.mkdir(parents=True, exist_ok=True)
            path.write_text(words)
        except OSError as reason:
            raise BadInput(f"{path} cannot be written: {reason.strerror}; name another folder by "
                           "--out.")
        paths.append(path)
    return paths


def rows(choices):
    """In the measures' own units, as table.csv."""
    found = []
    for key, variants in choices.knobs.items():
        for variant in variants:
            row = {"knob": key, "value": text(variant.changes[key]),
                   "timeRatio": choices.timeRatio(variant), "timeRatio.error": choices.timeRatioError(variant),
                   **variant.times}
            for measure in choices.measures:
                change = difference(choices, variant, measure)
                row[f"{measure}.difference"] = change.value
                row[f"{measure}.error"] = change.error
                row[f"{measure}.verdict"] = change.verdict
                if measure in choices.exact:
                    row[f"{measure}.offExact"] = offExact(choices, variant, measure).value
            found.append(row)
    return found


def markdown(choices, orders):
    parts = ["# What accuracy costs in time", introduction(choices)]
    for measure in choices.measures:
        if choices.reference.values[measure] is None:
            parts.append(f"## {measure}\n\nThe reference has no value of it.")
            continue
        found = fits(choices, measure, orders)
        parts += [f"## {heading(choices, measure)}", ownValue(choices, measure),
                  changes(choices, measure), limits(choices, measure, found),
                  tooFew(choices, measure, found, orders),
                  notBeaten(choices, measure, found), next_(choices, measure, found)]
    return "\n\n".join(filter(None, parts)) + "\n"


def introduction(choices):
    reference = choices.reference
    common = ", ".join(f"{key} {text(reference.parameters[key])}" for key in choices.knobs)
    where = "" if choices.clock == "seconds" else " in the solver, which is what counts as time here"
    words = (f"The reference has {common}; it takes {reference.seconds:.3g} s{where}. Differences are to it, "
             "with the standard error of both. *Resolved* is more than twice that error; what is not "
             "resolved may be scatter of the packings alone.")
    if choices.pooled:
        words += (" The errors of few packings are hardly known themselves: the scatter of all rows that scatter "
                  "alike is taken together.")
    return words


def heading(choices, measure):
    about = choices.table.about.get(measure, {})
    return f"{measure}: {about['text']}" if about.get("text") else measure


class Shown:
    """Numbers of a measure as people read them; differences of percent are percentage points."""

    def __init__(self, choices, measure):
        self.about = choices.table.about.get(measure, {})
        self.scale = shownAs.scale(self.about)
        unit = shownAs.unit(self.about)
        self.unit = "" if not unit else f" {unit}"
        self.differenceUnit = " percentage points" if unit == "%" else self.unit

    def value(self, number, error):
        return self.pair(number, error) + self.unit

    def difference(self, number, error):
        return self.pair(number, error, "+") + self.differenceUnit

    def pair(self, number, error, sign=""):
        words = f"{self.scale*number:{sign}.3g}" if sign else f"{self.scale*number:.4g}"
        return words if error is None else f"{words} ± {self.scale*error:.2g}"


def ownValue(choices, measure):
    shown = Shown(choices, measure)
    words = "The reference: " + shown.value(choices.reference.values[measure],
                                            choices.reference.errors[measure]) + "."
    if measure in choices.pooled:
        words += (f" Scatter of one packing: {shown.scale*choices.pooled[measure]:.2g}"
                  f"{shown.differenceUnit}.")
    if choices.apart.get(measure):
        words += (" Set apart, with their own errors, as they scatter more (Cochran's test): "
                  + ", ".join(map(choices.nameOf, choices.apart[measure])) + ".")
    if measure in choices.exact:
        off = offExact(choices, choices.reference, measure)
        words += (f" The exact answer is {shown.value(choices.exact[measure], None)}: it is "
                  f"{shown.difference(off.value, off.error)} off, {off.verdict}.")
    return words


def table(head, lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, ["---"]*len(head), *lines])


def changes(choices, measure):
    shown, lines, exact = Shown(choices, measure), [], measure in choices.exact
    for key, variants in choices.knobs.items():
        for variant in variants:
            change = difference(choices, variant, measure)
            words = "" if change.value is None else shown.pair(change.value, change.error, "+")
            lines.append([key, text(variant.changes[key]), timeOf(choices, variant),
                          f"**{words}**" if change.resolved else words, change.verdict])
            if exact:
                off = offExact(choices, variant, measure)
                lines[-1].append("" if off.value is None else shown.pair(off.value, off.error, "+"))
    unit = shown.differenceUnit.strip()
    return table(["knob", "value", "time over the reference's", "difference" + (f" [{unit}]" if unit
                 else ""), "verdict"] + ["off the exact answer"]*exact, lines)


def timeOf(choices, variant):
    ratio, error = choices.timeRatio(variant), choices.timeRatioError(variant)
    return "" if ratio is None else f"{ratio:.3g}" if error is None else f"{ratio:.2f} ± {error:.2f}"


def limits(choices, measure, found):
    """Richardson."""
    if not found:
        return ""
    shown, lines = Shown(choices, measure), []
    for key, fit in found.items():
        error = errorOfReference(choices, fit, key)
        verdict = error.verdict if fit.holds else f"order {fit.order:g} is not seen"
        lines.append([key, f"{fit.order:g}", str(fit.points), shown.pair(fit.limit, fit.limitError),
                      shown.pair(error.value, error.error, "+"),
                      "" if fit.chiSquare is None else f"{fit.chiSquare:.2g}", verdict])
    return ("Where it tends to (y = y0 + C h^p, p given), and how far off the reference is:\n\n"
            + table(["knob", "order p", "values", "y0", "error of the reference",
                     "chi^2 per freedom", "verdict"], lines)
            + "\n\nEach knob was varied alone. Where two act together, as cells and smoothing do by which a parcel's volume is "
            "spread, one by itself may tend to somewhere else than both do: vary them together before you pay for its limit.")


def tooFew(choices, measure, found, orders):
    keys = [key for key in choices.knobs if key in orders and key not in found]
    return "" if not keys else (f"Not extrapolated, as {LEAST} numbers greater than 0 are needed, the "
                                f"reference's included: {', '.join(keys)}.")


def notBeaten(choices, measure, found):
    shown = Shown(choices, measure)
    best = sorted((choice for choice in front(choices, measure, found) if choice.best),
                  key=lambda choice: choice.time)
    listed = "; ".join(f"{choice.name} ({choice.time:.3g} of the time, "
                       + (f"{shown.scale*choice.error:.2g}{shown.differenceUnit} off)"
                          if choice.error > choice.noise else
                          f"within the scatter of {shown.scale*choice.noise:.2g}"
                          f"{shown.differenceUnit})") for choice in best)
    return f"Not beaten in both time and error: {listed}."


def next_(choices, measure, found):
    steps = nextMinute(choices, measure, found)
    if not steps:
        return "No knob has a value that takes longer than the reference."
    shown = Shown(choices, measure)
    return ("Where the next minute is best spent:\n\n"
            + table(["knob", "from the reference to", "added minutes",
                     f"error less, per minute [{shown.differenceUnit.strip() or '1'}]", "by", "verdict"],
                    [[step.knob, text(step.value), f"{step.minutes:.3g}",
                      shown.pair(step.perMinute.value, step.perMinute.error), step.how,
                      step.gain.verdict] for step in steps]))
