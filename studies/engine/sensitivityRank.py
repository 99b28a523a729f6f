# SPDX-License-Identifier: GPL-3.0-or-later
"""How strongly a measure depends on each parameter that is varied alone, and where it meets a target.

The *swing* of a measure is its largest less its smallest value while one parameter takes all of its values, the
reference's among them. The more values, the larger it is by scatter alone: of n values of standard error s the range
exceeds q(n) s once in 22 times, with q(2) = 2 sqrt(2), which is the rule of twice the combined errors for two.
"""
import math
from dataclasses import dataclass
from functools import lru_cache
from statistics import NormalDist

import accuracyFit
from accuracyJudge import Number, combined
from shownAs import isNumber

NORMAL = NormalDist()
ONCE_IN = 1/(2*NORMAL.cdf(-2))  # 22: how seldom scatter alone is called resolved


@dataclass
class Point:
    """What was found at one value of a parameter."""
    x: object  # number or word
    y: float
    error: float  # standard error, None if not known

    def meets(self, target):
        return self.error is not None and abs(self.y - target) <= 2*self.error


@dataclass
class Crossing:
    """A target between two neighbours."""
    low: Point
    high: Point
    at: Number
    resolved: bool  # the neighbours differ


class Influence:
    """Of one parameter on one measure; points in the order of the parameter, the reference among them."""

    def __init__(self, parameter, points, reference):
        self.parameter, self.points = parameter, inOrder(points)
        self.lowest = min(points, key=lambda point: point.y)
        self.highest = max(points, key=lambda point: point.y)
        self.swing = Number(self.highest.y - self.lowest.y, combined(self.lowest.error, self.highest.error))
        changes = [(point, Number(point.y - reference.y, combined(point.error, reference.error)))
                   for point in points if point is not reference]
        self.largest, self.change = max(changes, key=lambda pair: abs(pair[1].value))
        self.elasticity, self.powerLaw = elasticity(self.points)

    @property
    def scatter(self):
        """The swing that scatter alone exceeds once in 22 times; None if errors are not known."""
        errors = [point.error for point in self.points]
        if None in errors:
            return None
        return rangeOfScatter(len(errors))*math.sqrt(math.fsum(error**2 for error in errors)/len(errors))

    @property
    def verdict(self):
        if self.scatter is None:
            return "error not known"
        return "resolved" if self.swing.value > self.scatter else "not resolved"

    def crossings(self, target):
        return crossings(self.points, target)

    def bothSides(self, target):
        return self.lowest.y < target < self.highest.y


def ranking(choices, measure):
    """Strongest first; a parameter without any value is left out."""
    own = choices.reference.values[measure]
    if own is None:
        return []
    found = []
    for key, variants in choices.knobs.items():
        reference = Point(choices.reference.parameters[key], own, choices.reference.errors[measure])
        points = [Point(variant.parameters[key], variant.values[measure], variant.errors[measure])
                  for variant in variants if variant.values[measure] is not None]
        if points:
            found.append(Influence(key, [reference, *points], reference))
    return sorted(found, key=lambda one: -one.swing.value)


def inOrder(points):
    return sorted(points, key=lambda point: (isinstance(point.x, str), point.x))


def crossings(points, target):
    """Between neighbours in the order of a parameter, by a straight line between them."""
    found = []
    for a, b in zip(points, points[1:]):
        if not (isNumber(a.x) and isNumber(b.x)) or not (a.y - target)*(b.y - target) < 0:
            continue
        share = (target - a.y)/(b.y - a.y)
        wide, rise = b.x - a.x, b.y - a.y
        known = a.error is not None and b.error is not None
        error = abs(wide/rise)*math.hypot((1 - share)*a.error, share*b.error) if known else None
        found.append(Crossing(a, b, Number(a.x + share*wide, error),
                              known and Number(rise, combined(a.error, b.error)).resolved))
    return found


def elasticity(points):
    """d ln y/d ln x by least squares, and whether a power law fits; None where a logarithm is missing. A parameter
    that is zero has no logarithm and is left out."""
    some = [point for point in points if isNumber(point.x) and point.x > 0]
    if len(some) < 2 or not all(point.y > 0 for point in some):
        return None, True
    logs = [(math.log(point.x/some[0].x), math.log(point.y), point.error and point.error/point.y)
            for point in some]
    if len(logs) < accuracyFit.LEAST:
        (_, y0, e0), (x1, y1, e1) = logs
        error = combined(e0, e1)
        return Number((y1 - y0)/x1, None if error is None else error/x1), True
    fit = accuracyFit.fit(logs, 1)
    return Number(fit.coefficient, fit.coefficientError), fit.holds


@lru_cache
def rangeOfScatter(n):
    """q(n): the range of n normal numbers of deviation 1 that is exceeded once in 22 times."""
    low, high = 0.0, 10.0
    while high - low > 1e-6:
        middle = 0.5*(low + high)
        low, high = (middle, high) if 1 - rangeBelow(n, middle) > 1/ONCE_IN else (low, middle)
    return high


def rangeBelow(n, r):
    """Probability that the range of n normal numbers is below r: the smallest at x, the others above it."""
    step = 0.02
    return n*step*math.fsum(NORMAL.pdf(x)*(NORMAL.cdf(x + r) - NORMAL.cdf(x))**(n - 1)
                            for x in (-8 + step*i for i in range(800)))
