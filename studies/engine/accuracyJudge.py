# SPDX-License-Identifier: GPL-3.0-or-later
"""What of the differences is more than scatter, which choices are not beaten, what to refine first.

All numbers here are in the measure's own unit. Errors are standard errors; *resolved* is what is
larger than twice its error.
"""
import math
from dataclasses import dataclass

import accuracyFit
from shownAs import isNumber

SLOWER = 1.05  # over the reference's time; less, or less than two errors of it, may be the machine's mood


@dataclass
class Number:
    value: float
    error: float = None  # standard error, None if not known

    @property
    def verdict(self):
        if self.value is None:
            return "no value"
        if self.error is None:
            return "error not known"
        if self.value == 0 and self.error == 0:
            return "equal"
        return "resolved" if abs(self.value) > 2*self.error else "not resolved"

    @property
    def resolved(self):
        return self.verdict == "resolved"


def combined(*errors):
    return None if None in errors else math.hypot(*errors)


def difference(choices, variant, measure):
    """To the reference."""
    one, other = variant.values[measure], choices.reference.values[measure]
    if one is None or other is None:
        return Number(None)
    return Number(one - other, combined(variant.errors[measure],
                                        choices.reference.errors[measure]))


def offExact(choices, variant, measure):
    """From the exact answer, which must be known."""
    value = variant.values[measure]
    if value is None:
        return Number(None)
    return Number(value - choices.exact[measure], variant.errors[measure])


def fits(choices, measure, orders):
    """Knob -> what the measure tends to, of knobs whose order is known and that have enough values."""
    found = {}
    for key, variants in choices.knobs.items():
        own = choices.reference.parameters[key]
        if key not in orders or not isNumber(own):
            continue
        points = [(variant.parameters[key], variant.values[measure], variant.errors[measure])
                  for variant in [choices.reference, *variants]
                  if variant.values[measure] is not None and isNumber(variant.parameters[key])
                  and variant.parameters[key] > 0]
        fit = accuracyFit.fit(points, orders[key])
        if fit:
            found[key] = fit
    return found


def errorOfReference(choices, fit, key):
    return Number(*fit.errorOf(choices.reference.parameters[key]))


def truth(choices, measure, found):
    """The exact answer; or else the best known value: the reference, less those of its errors that
    are resolved."""
    if measure in choices.exact:
        return Number(choices.exact[measure], 0.0)
    errors = [error for error in (errorOfReference(choices, fit, key) for key, fit in found.items()
                                  if fit.holds) if error.resolved]
    value = choices.reference.values[measure] - math.fsum(error.value for error in errors)
    return Number(value, combined(*[error.error for error in errors]) if errors else 0.0)


@dataclass
class Choice:
    """A variant as a way to spend time; `error` is not below `noise`, which nobody can tell from 0."""
    variant: object
    name: str
    time: float
    distance: float  # from the best known value
    noise: float  # twice its standard error; 0 if not known
    best: bool = False

    @property
    def error(self):
        return max(abs(self.distance), self.noise)


def front(choices, measure, found):
    """All variants but those that change a word, which is another model, and no error; `best` are
    those that no other beats: none is at least as fast and as accurate, and better in one."""
    best = truth(choices, measure, found)
    all_ = []
    for variant in choices.variants:
        time, value = choices.timeRatio(variant), variant.values[measure]
        if value is None or time is None or not all(map(isNumber, variant.changes.values())):
            continue
        error = combined(variant.errors[measure], best.error)
        all_.append(Choice(variant, choices.nameOf(variant), time, value - best.value, 2*(error or 0)))
    for one in all_:
        one.best = not any(beats(other, one) for other in all_)
    return all_


def beats(one, other):
    return (one.time <= other.time and one.error <= other.error
            and (one.time < other.time or one.error < other.error))


@dataclass
class Step:
    """From the reference to a finer value of one knob."""
    knob: str
    value: object
    minutes: float  # it takes more
    gain: Number  # by which the error shrinks
    how: str  # "order p", "finest value", or "exact answer"

    @property
    def perMinute(self):
        return Number(self.gain.value/self.minutes,
                      None if self.gain.error is None else self.gain.error/self.minutes)


def nextMinute(choices, measure, found):
    """The best step of each knob that has a slower value, best first; those that are resolved lead."""
    steps = []
    for key, variants in choices.knobs.items():
        slower = [v for v in variants if v.values[measure] is not None and v.seconds
                  and isNumber(v.parameters[key])
                  and choices.timeRatio(v) > max(SLOWER, 1 + 2*(choices.timeRatioError(v) or 0))]
        if not slower or choices.reference.values[measure] is None:
            continue
        own = [step(choices, measure, key, variant, slower, found.get(key)) for variant in slower]
        steps.append(max(filter(None, own), key=lambda s: s.perMinute.value, default=None))
    return sorted(filter(None, steps), key=lambda s: (not s.gain.resolved, -s.perMinute.value))


def step(choices, measure, key, variant, slower, fit):
    """By the exact answer; or by the law if it is known and holds; else the slowest value is taken for
    the truth, and the error that is removed is all that separates it from the reference."""
    minutes = (variant.seconds - choices.reference.seconds)/60
    if measure in choices.exact:
        own, new = (offExact(choices, one, measure).value for one in (choices.reference, variant))
        return Step(key, variant.parameters[key], minutes,
                    Number(abs(own) - abs(new), difference(choices, variant, measure).error), "exact answer")
    if fit and fit.holds:
        own, new = choices.reference.parameters[key], variant.parameters[key]
        return Step(key, new, minutes, Number(*fit.between(own, new)), f"order {fit.order:g}")
    if variant is not max(slower, key=lambda v: v.seconds):
        return None
    change = difference(choices, variant, measure)
    return Step(key, variant.parameters[key], minutes, Number(abs(change.value), change.error),
                "finest value")
