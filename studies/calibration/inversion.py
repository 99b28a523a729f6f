# SPDX-License-Identifier: GPL-3.0-or-later
"""Which friction and rolling friction give two angles, and how well these determine them; a coefficient that was
measured otherwise is one number more that they have to give.

The region of 95 % confidence holds all pairs whose angles, on the surfaces, differ from the given ones
by no more than the errors of both allow together:

    S = sum over all given numbers of (what the pair has - given)^2/(error of surface^2 + error of given^2)
    S - least S <= 2 F(2, nu)

The least S is 0 for two angles, which a pair can give exactly; that of three numbers must not exceed F(1, nu), or they
contradict. The region is scanned over the whole grid, so that it needs no linearisation, and must lie inside. Standard
errors are from the slopes there (delta method); the intervals are quantiles of answers to given numbers and
surfaces drawn at random within their errors.
"""
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from badInput import BadInput
from responseSurface import AXES, TERMS

CELLS, DRAWS, SEED = 101, 2000, 20260
CONFIDENCE = 0.95


@dataclass
class Answer:
    value: np.ndarray  # friction, rolling friction
    error: np.ndarray
    correlation: float
    low: np.ndarray  # of their intervals, each for itself
    high: np.ndarray
    regionLow: np.ndarray  # around the region, for both together
    regionHigh: np.ndarray
    outside: float  # share of the draws without an answer on the grid
    holds: object  # whether a pair lies in the region


class Question:
    """Two surfaces, two angles and their errors; and of coefficients that are known besides: (axis, value, error)."""

    def __init__(self, surfaces, angles, errors, low, high, known=()):
        self.surfaces, self.low, self.high = surfaces, np.asarray(low, float), np.asarray(high, float)
        self.axes = [axis for axis, _, _ in known]
        self.given = np.array([*angles, *(value for _, value, _ in known)], float)
        self.errors = np.array([*errors, *(error for _, _, error in known)], float)
        self.freedom = np.array([*(one.freedom for one in surfaces), *(np.inf for _ in known)])

    @property
    def names(self):
        return "two angles" + "".join(f" and the {AXES[axis]}" for axis in self.axes)

    def all(self, x, coefficients=(None, None)):
        """What a pair has of the given: angles, then the coefficients that are known."""
        angles = [one.at(x, c) for one, c in zip(self.surfaces, coefficients)]
        return np.stack([*angles, *(np.asarray(x)[..., axis] for axis in self.axes)], axis=-1)

    def slopes(self, x, coefficients=(None, None)):
        angles = [one.slopes(x, c) for one, c in zip(self.surfaces, coefficients)]
        return np.stack([*angles, *(np.broadcast_to(np.eye(2)[axis], angles[0].shape) for axis in self.axes)], axis=-2)

    def variance(self, x):
        """Of each difference between a pair and what is given."""
        fit = [one.error(x) for one in self.surfaces]
        return np.stack([*fit, *(np.zeros_like(fit[0]) for _ in self.axes)], axis=-1)**2 + self.errors**2

    def distance(self, x):
        """The sum S, and its limits 2 F(2, nu), which has a closed form, and F(1, nu); nu after Welch and
        Satterthwaite, the smallest of all."""
        variance = self.variance(x)
        distance = np.sum((self.all(x) - self.given)**2/variance, axis=-1)
        nu = np.min(variance**2*self.freedom/np.maximum((variance - self.errors**2)**2, 1e-300), axis=-1)
        nu = np.minimum(nu, 1e6)
        return distance, nu*((1 - CONFIDENCE)**(-2/nu) - 1), stdtrit(nu, 0.5*(1 + CONFIDENCE))**2

    def solved(self, start, given, coefficients=(None, None)):
        """Least squares by Gauss and Newton for many at a time, kept near the grid; and which of them arrived on it."""
        x = np.array(start, float)
        reach = self.high - self.low
        floor = np.maximum(self.low - 0.3*reach, 0.2*self.low)
        weight = 1/np.sqrt(self.variance(x))
        for _ in range(40):
            left = (given - self.all(x, coefficients))*weight
            slopes = self.slopes(x, coefficients)*reach*weight[..., None]
            step = solve2(np.swapaxes(slopes, -1, -2)@slopes, np.einsum("...ij,...i->...j", slopes, left))
            longest = np.max(np.abs(step), axis=-1, keepdims=True)
            x = np.clip(x + step*reach/np.maximum(1, longest/0.2), floor, self.high + 0.3*reach)
            if longest.max() < 1e-9:
                break
        near = np.max(np.abs(step), axis=-1) < 1e-5
        if not self.axes:
            near &= np.abs(given - self.all(x, coefficients)).max(axis=-1) < 1e-5
        return x, near & self.onGrid(x)

    def onGrid(self, x):
        """Between the rows of both tables, and not in a corner that none of them has."""
        slack = 1e-9*(self.high - self.low)
        inside = ((x >= self.low - slack) & (x <= self.high + slack)).all(axis=-1)
        x = np.clip(x, self.low, self.high)
        return inside & self.surfaces[0].holds(x) & self.surfaces[1].holds(x)


def solve2(a, b):
    """Of 2 x 2 equations, many at a time; what is singular gets a long step."""
    det = a[..., 0, 0]*a[..., 1, 1] - a[..., 0, 1]*a[..., 1, 0]
    det = np.where(np.abs(det) < 1e-12, 1e-12, det)
    return np.stack([a[..., 1, 1]*b[..., 0] - a[..., 0, 1]*b[..., 1],
                     a[..., 0, 0]*b[..., 1] - a[..., 1, 0]*b[..., 0]], axis=-1)/det[..., None]


def grown(seed, mask):
    """The part of a mask that hangs together with the seed."""
    part = seed & mask
    while True:
        more = part.copy()
        more[1:] |= part[:-1]
        more[:-1] |= part[1:]
        more[:, 1:] |= more[:, :-1]
        more[:, :-1] |= more[:, 1:]
        more &= mask
        if (more == part).all():
            return part
        part = more


def pair(x):
    return ", ".join(f"{key} {value:.3g}" for key, value in zip(AXES, x))


def tooLoose(q, how):
    another = "" if q.axes else ", or friction as it was measured otherwise (--friction)"
    return BadInput(f"The {q.names} do not determine both {AXES[0]} and {AXES[1]}: {how}; give them "
                    f"with smaller errors{another}, run more packings, or take a wider grid.")


def contradiction(q, x):
    has = q.all(x)
    told = f"{has[0]:.3g} and {has[1]:.3g} degrees, wanted are {q.given[0]:.3g} and {q.given[1]:.3g}"
    if q.axes:
        return BadInput(f"No {AXES[0]} and {AXES[1]} of the grid give the {q.names}: the closest, {pair(x)}, give {told}, "
                        f"and {AXES[q.axes[0]]} {q.given[2]:.3g}; look at what was measured, or take a wider grid.")
    return BadInput(f"No {AXES[0]} and {AXES[1]} of the grid give both angles: the closest, {pair(x)}, give {told}; "
                    "take a wider grid.")


def checkWhole(q, grid, mask, distance):
    """The region must lie inside the grid and hang together."""
    best = np.unravel_index(np.argmin(distance), distance.shape)
    border = np.ones_like(mask)
    border[1:-1, 1:-1] = False
    border |= ~q.onGrid(grid)
    if (mask & border).any():
        ends = [(grid[mask][:, i].min(), grid[mask][:, i].max()) for i in (0, 1)]
        raise tooLoose(q, "the region of 95 % confidence leaves the grid, where it reaches over "
                       + " and ".join(f"{key} {low:.3g} to {high:.3g}"
                                      for key, (low, high) in zip(AXES, ends)))
    start = np.zeros_like(mask)
    start[best] = True
    rest = mask & ~grown(start, mask)
    if rest.any():
        other = grid[rest][np.argmin(distance[rest])]
        raise BadInput(f"Two pairs give both angles, {pair(grid[best])} and {pair(other)}: take a smaller "
                       "grid, around one of them.")


def answer(question, draws=DRAWS, cells=CELLS):
    """The pair, or a sentence why there is none."""
    q = question
    axes = [np.linspace(low, high, cells) for low, high in zip(q.low, q.high)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    distance, limit, agreement = q.distance(grid)
    best = np.unravel_index(np.argmin(distance), distance.shape)
    value, arrived = q.solved(grid[best], q.given)
    least = 0.0
    if q.axes:
        least = min(distance[best], q.distance(value)[0] if arrived else np.inf)
        if least > agreement[best]:
            raise contradiction(q, value if arrived else grid[best])
    mask = distance - least <= limit
    if not (mask.any() or arrived):
        raise contradiction(q, grid[best])
    mask[best] = True
    checkWhole(q, grid, mask, distance)
    if not arrived:
        raise tooLoose(q, f"at {pair(grid[best])} all depend on them in the same way")
    return withErrors(q, value, grid[mask], draws)


def withErrors(q, value, region, draws):
    slopes = q.slopes(value)
    covariance = np.linalg.inv(slopes.T@(slopes/q.variance(value)[:, None]))
    error = np.sqrt(np.diag(covariance))
    random = np.random.default_rng(SEED)
    given = q.given + q.errors*random.standard_normal((draws, len(q.given)))
    coefficients = []
    for one in q.surfaces:
        spread = np.sqrt(one.freedom/random.chisquare(one.freedom, (draws, 1)))
        root = np.linalg.cholesky(one.covariance + 1e-30*np.eye(len(one.covariance)))
        coefficients.append(one.coefficients + spread*(random.standard_normal((draws, TERMS))@root.T))
    drawn, arrived = q.solved(np.tile(value, (draws, 1)), given, coefficients)
    outside = 1 - arrived.mean()
    if outside > 1 - CONFIDENCE:
        raise tooLoose(q, f"with angles and surfaces drawn within their errors, {100*outside:.0f} % of the "
                       "answers lie outside the grid")
    low, high = np.quantile(drawn[arrived], [0.5*(1 - CONFIDENCE), 0.5*(1 + CONFIDENCE)], axis=0)
    around = np.vstack([region, value])
    return Answer(value, error, covariance[0, 1]/np.prod(error), low, high, around.min(axis=0),
                  around.max(axis=0), outside, lambda x: holds(q, value, x))


def holds(q, value, x):
    """Whether a pair lies in the region."""
    distance, limit, _ = q.distance(x)
    return distance - q.distance(value)[0]*bool(q.axes) <= limit
