# SPDX-License-Identifier: GPL-3.0-or-later
"""ranking.csv and ranking.md: what a measure depends on, and which values bring it to a target."""
import math

from accuracyJudge import Number, combined
from accuracyReport import Shown, heading, ownValue, table
from sensitivityRank import ONCE_IN, ranking
from shownAs import PREFIXES, isNumber, text
from tables import sheet


def files(choices, measures, targets, moments):
    """Name -> content."""
    return {"ranking.csv": sheet(rows(choices, measures, targets)),
            "ranking.md": markdown(choices, measures, targets, moments)}


def rows(choices, measures, targets):
    """In the measures' own units, as table.csv."""
    found = []
    for measure in measures:
        for rank, one in enumerate(ranking(choices, measure), 1):
            row = {"measure": measure, "rank": rank, "parameter": one.parameter,
                   "values": " ".join(text(point.x) for point in one.points),
                   "lowest.at": text(one.lowest.x), "lowest": one.lowest.y,
                   "highest.at": text(one.highest.x), "highest": one.highest.y,
                   "swing": one.swing.value, "swing.error": one.swing.error, "swing.scatter": one.scatter,
                   "swing.verdict": one.verdict, "change.at": text(one.largest.x),
                   "change": one.change.value, "change.error": one.change.error,
                   "change.verdict": one.change.verdict,
                   "elasticity": one.elasticity and one.elasticity.value,
                   "elasticity.error": one.elasticity and one.elasticity.error,
                   "powerLaw": "" if one.elasticity is None else "yes" if one.powerLaw else "no"}
            target = targets.get(measure)
            crossings = [] if target is None else one.crossings(target)
            row.update({"target": target, "target.between": " ".join(
                            f"{text(c.low.x)}..{text(c.high.x)}" for c in crossings),
                        "target.at": " ".join(f"{c.at.value:.4g}" for c in crossings),
                        "target.at.error": " ".join(f"{c.at.error:.2g}" for c in crossings
                                                    if c.at.error is not None),
                        "target.met": "" if target is None else " ".join(
                            text(point.x) for point in one.points if point.meets(target))})
            found.append(row)
    return found


def markdown(choices, measures, targets, moments):
    parts = ["# What the results depend on", introduction(choices, measures)]
    for measure in measures:
        parts.append(f"## {heading(choices, measure)}")
        ranks = ranking(choices, measure)
        if not ranks:
            parts.append("The reference has no value of it, or no other variant has.")
            continue
        parts += [ownValue(choices, measure), ranked(choices, measure, ranks), withoutValue(choices, measure)]
        if measure in targets:
            parts += aimed(choices, measure, ranks, targets[measure])
    if moments:
        parts += ["## Moment of reading", momentsOf(choices, moments, targets)]
    return "\n\n".join(filter(None, parts)) + "\n"


def introduction(choices, measures):
    reference, count = choices.reference, sum(map(len, choices.knobs.values()))
    words = ("The reference has " + ", ".join(f"{key} {choices.table.written(key, reference.parameters[key])}"
                                              for key in choices.knobs) + ".")
    words += (" *Swing*: largest less smallest value while one parameter takes its values, the reference's among "
              "them. It is resolved if scatter alone would make a larger one less than once in "
              f"{ONCE_IN:.0f} times, which depends on how many values there are. *Largest change*: from the reference; "
              f"bold: more than twice its error. Of {count} changes, scatter alone makes {count/ONCE_IN:.1f} that "
              "large. *Elasticity*: d ln y/d ln x, of parameters that are numbers; zero has no logarithm and is left "
              "out.")
    if choices.pooled:
        words += (" Errors are of the scatter of all rows together that scatter alike: those of few packings are hardly "
                  "known themselves.")
    left = [variant for variant in choices.variants if len(variant.changes) > 1]
    if left:
        words += f" Left out, as they change more than one parameter: {len(left)} variants."
    return words


def ranked(choices, measure, ranks):
    shown, lines = Shown(choices, measure), []
    written = choices.table.written
    for rank, one in enumerate(ranks, 1):
        change = shown.pair(one.change.value, one.change.error, "+")
        lines.append([str(rank), one.parameter, valuesOf(choices, one),
                      shown.pair(one.swing.value, one.swing.error),
                      "" if one.scatter is None else f"{shown.scale*one.scatter:.2g}", one.verdict,
                      (f"**{change}**" if one.change.resolved else change)
                      + f" at {written(one.parameter, one.largest.x)}", elasticityOf(one)])
    unit = shown.differenceUnit.strip()
    unit = f" [{unit}]" if unit else ""
    return table(["rank", "parameter", "values", f"swing{unit}", "by scatter", "verdict",
                  f"largest change{unit}", "elasticity"], lines)


def valuesOf(choices, one):
    first, last = one.points[0].x, one.points[-1].x
    written = [choices.table.written(one.parameter, point.x) for point in one.points]
    if isNumber(first) and isNumber(last) and len(written) > 2:
        return f"{written[0]} to {written[-1]} ({len(written)})"
    return ", ".join(written)


def elasticityOf(one):
    found = one.elasticity
    if found is None:
        return ""
    words = f"{found.value:+.2g}" + ("" if found.error is None else f" ± {found.error:.1g}")
    return words + (f", {found.verdict}" if one.powerLaw else ", no power law")


def withoutValue(choices, measure):
    lacking = [choices.nameOf(variant) for variants in choices.knobs.values() for variant in variants
               if variant.values[measure] is None]
    return f"Without a value: {', '.join(lacking)}." if lacking else ""


def aimed(choices, measure, ranks, target):
    """Plain words: which values reach the target, which parameters cannot do it alone."""
    shown = Shown(choices, measure)
    goal = f"{shown.scale*target:.4g}{shown.unit}"
    own = Number(choices.reference.values[measure] - target, choices.reference.errors[measure])
    parts = [f"### {goal}", "The reference is "
             + shown.pair(abs(own.value), own.error) + (shown.differenceUnit or "")
             + (" above it." if own.value > 0 else " below it.")
             + ("" if own.error is None or own.resolved else " That is within two errors: it is there already.")]
    reaching, failing = [], []
    for one in ranks:
        words = reached(choices, one, target, goal, shown)
        (reaching if words else failing).append(f"- {one.parameter}: " + (words or short(choices, one, target, shown)))
    if reaching:
        parts += [f"{goal} is reached by one parameter alone:", "\n".join(reaching)]
    if failing:
        parts += [f"{goal} is not reached alone, within the values of the study, by:", "\n".join(failing)]
    return parts


def reached(choices, one, target, goal, shown):
    """Empty if it is not."""
    written = lambda point: choices.table.written(one.parameter, point.x)
    words = []
    for crossing in one.crossings(target):
        words.append(f"{goal} lies between {written(crossing.low)} and {written(crossing.high)}, at "
                     + withError(choices.table, one.parameter, crossing.at)
                     + ("" if crossing.resolved else ", but these two do not differ by more than scatter"))
    met = [point for point in one.points if point.meets(target)]
    if met:
        words.append("within two errors of it: " + ", ".join(
            f"{written(point)} ({shown.value(point.y, point.error)})" for point in met))
    if not words and one.bothSides(target):
        words.append("on both sides of it: " + ", ".join(
            f"{written(point)} ({shown.value(point.y, point.error)})" for point in one.points))
    if words and one.verdict == "not resolved":
        words.append("but its swing is not resolved")
    return "; ".join(words)


def withError(table, key, number):
    """5.49 ± 0.17 mm: a parameter's value, with two digits of its error."""
    unit = table.about.get(key, {}).get("unit", "")
    scale = 1
    if unit == "m":
        scale, unit = next((pair for pair in PREFIXES if abs(number.value) >= pair[0]), PREFIXES[-1])
    words = f"{number.value/scale:.4g}"
    if number.error:
        digits = max(0, 1 - math.floor(math.log10(number.error/scale)))
        words = f"{number.value/scale:.{digits}f} ± {number.error/scale:.{digits}f}"
    return words if unit in ("", "1", "-") else f"{words} {unit}".replace(" um", " µm")


def short(choices, one, target, shown):
    nearest = min(one.points, key=lambda point: abs(point.y - target))
    away = shown.pair(abs(nearest.y - target), nearest.error) + shown.differenceUnit
    return (f"from {shown.value(one.lowest.y, one.lowest.error)} to {shown.value(one.highest.y, one.highest.error)}; "
            f"nearest at {choices.table.written(one.parameter, nearest.x)}, {away} away")


def momentsOf(choices, moments, targets):
    """One quantity, read at several moments: at the reference, and the range over all variants."""
    lines, own = [], []
    target = next((targets[measure] for measure in moments if measure in targets), None)
    for measure in moments:
        shown, value = Shown(choices, measure), choices.reference.values[measure]
        error = choices.reference.errors[measure]
        some = [variant.values[measure] for variant in choices.variants if variant.values[measure] is not None]
        away = "" if target is None or value is None else shown.pair(value - target, error, "+") + shown.differenceUnit
        lines.append([measure, "" if value is None else shown.value(value, error),
                      f"{shown.scale*min(some):.4g} to {shown.scale*max(some):.4g}{shown.unit}" if some else "", away])
        own += [] if value is None else [(value, error)]
    shown = Shown(choices, moments[0])
    low, high = min(own, default=(0, None)), max(own, default=(0, None))
    words = ("The same run, read at another moment, gives another number. The moment alone has a swing of "
             + shown.pair(high[0] - low[0], combined(low[1], high[1])) + shown.differenceUnit
             + ". Readings of one run rather scatter together, so that this error is no smaller than the true one.")
    head = ["read as", "at the reference", "over all variants"]
    goal = [] if target is None else [f"above {shown.scale*target:.4g}{shown.unit}"]
    return words + "\n\n" + table(head + goal, [line[:len(head + goal)] for line in lines])
