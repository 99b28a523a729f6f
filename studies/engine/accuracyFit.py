# SPDX-License-Identifier: GPL-3.0-or-later
"""What a measure tends to as a knob of the numerics gets finer, and how far off a value is.

    y = y0 + C h^p            h the knob's value, p known: Richardson's extrapolation

by least squares, weighted by the standard errors of y. Both y0 and C are linear in y, so that their
errors follow from those of y. With more points than two, how well the law holds is told as well.
"""
import math
from dataclasses import dataclass

# Orders of this project's methods. cellSize: upwind convection, and walls in steps of cells.
ORDERS = {"cellSize": 1, "maxDeltaT": 1, "couplingNumber": 1}
LEAST = 3  # points; two fit any law
BENDS = 4  # chi^2 per degree of freedom above which the law is not seen


@dataclass
class Fit:
    order: float
    limit: float  # y0
    limitError: float  # standard error; None if those of the points are not known
    coefficient: float  # C
    coefficientError: float
    chiSquare: float  # per degree of freedom; None without errors
    points: int

    @property
    def holds(self):
        return self.chiSquare is None or self.chiSquare <= BENDS

    def errorOf(self, h):
        """How far y lies from y0 at h, and the standard error of that."""
        size = h**self.order
        error = None if self.coefficientError is None else self.coefficientError*size
        return self.coefficient*size, error

    def between(self, one, other):
        """By how much the distance from y0 shrinks from one value to another, and its error."""
        sizes = one**self.order - other**self.order
        error = None if self.coefficientError is None else self.coefficientError*abs(sizes)
        return abs(self.coefficient)*sizes, error


def fit(points, order):
    """Of (h, y, standard error or None); None if they are fewer than three values of h."""
    if len({h for h, _, _ in points}) < LEAST:
        return None
    known = all(error is not None and error > 0 for _, _, error in points)
    weights = [1/error**2 if known else 1.0 for _, _, error in points]
    # Scaled, since h^p may be 1e-10 and y 1; heights above a first one, so that y0 keeps its digits.
    scale = max(h for h, _, _ in points)**order
    base = points[0][1]
    x = [h**order/scale for h, _, _ in points]
    y = [value - base for _, value, _ in points]
    total = math.fsum(weights)
    meanX = math.fsum(w*a for w, a in zip(weights, x))/total
    meanY = math.fsum(w*b for w, b in zip(weights, y))/total
    spread = math.fsum(w*(a - meanX)**2 for w, a in zip(weights, x))
    slope = math.fsum(w*(a - meanX)*(b - meanY) for w, a, b in zip(weights, x, y))/spread
    limit = meanY - slope*meanX
    chi = math.fsum(w*(b - limit - slope*a)**2 for w, a, b in zip(weights, x, y))/(len(points) - 2)
    worse = math.sqrt(chi) if known and chi > BENDS else 1.0
    return Fit(order, base + limit,
               worse*math.sqrt(1/total + meanX**2/spread) if known else None,
               slope/scale, worse/math.sqrt(spread)/scale if known else None,
               chi if known else None, len(points))
