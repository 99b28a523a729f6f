# SPDX-License-Identifier: GPL-3.0-or-later
"""Which friction and rolling friction give two angles, and how well the angles determine them.

The region of 95 % confidence holds all pairs whose angles, on the surfaces, differ from the given ones
by no more than the errors of both allow together:

    sum over both angles (surface - given)^2/(error of surface^2 + error of given^2) <= 2 F(2, nu)

It is scanned over the whole grid, so that it needs no linearisation, and must lie inside. Standard
errors are from the slopes there (delta method); the intervals are quantiles of answers to angles and
surfaces drawn at random within their errors.
"""
from dataclasses import dataclass

import numpy as np

from badInput import BadInput
from responseSurface import AXES

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
    """Two surfaces, two angles and their errors."""

    def __init__(self, surfaces, angles, errors, low, high):
        self.surfaces, self.low, self.high = surfaces, np.asarray(low, float), np.asarray(high, float)
        self.angles, self.errors = np.asarray(angles, float), np.asarray(errors, float)

    def both(self, x, coefficients=(None, None)):
        return np.stack([one.at(x, c) for one, c in zip(self.surfaces, coefficients)], axis=-1)

    def slopes(self, x, coefficients=(None, None)):
        return np.stack([one.slopes(x, c) for one, c in zip(self.surfaces, coefficients)], axis=-2)

    def fitErrors(self, x):
        return np.stack([one.error(x) for one in self.surfaces], axis=-1)

    def distance(self, x):
        """The sum above, and its limit 2 F(2, nu), which has a closed form; nu after Welch and
        Satterthwaite, the smaller one of both angles."""
        fit = self.fitErrors(x)**2
        distance = np.sum((self.both(x) - self.angles)**2/(fit + self.errors**2), axis=-1)
        freedom = np.array([one.freedom for one in self.surfaces])
        nu = np.min((fit + self.errors**2)**2*freedom/np.maximum(fit**2, 1e-300), axis=-1)
        nu = np.minimum(nu, 1e6)
        return distance, nu*((1 - CONFIDENCE)**(-2/nu) - 1)

    def holds(self, x):
        distance, limit = self.distance(x)
        return distance <= limit

    def solved(self, start, angles, coefficients=(None, None)):
        """Newton's method for many at a time, kept near the grid; and which of them arrived on it."""
        x = np.array(start, float)
        reach = self.high - self.low
        floor = np.maximum(self.low - 0.3*reach, 0.2*self.low)
        for _ in range(40):
            left = angles - self.both(x, coefficients)
            slopes = self.slopes(x, coefficients)*reach
            step = solve2(slopes, left)
            longest = np.max(np.abs(step), axis=-1, keepdims=True)
            x = x + step*reach/np.maximum(1, longest/0.2)
            x = np.clip(x, floor, self.high + 0.3*reach)
            if np.abs(left).max() < 1e-9:
                break
        near = np.abs(angles - self.both(x, coefficients)).max(axis=-1) < 1e-5
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


def tooLoose(how):
    return BadInput(f"The two angles do not determine both {AXES[0]} and {AXES[1]}: {how}; give the angles "
                    "with smaller errors, run more packings, or take a wider grid.")


def answer(question, draws=DRAWS, cells=CELLS):
    """The pair, or a sentence why there is none."""
    q = question
    axes = [np.linspace(low, high, cells) for low, high in zip(q.low, q.high)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    distance, limit = q.distance(grid)
    best = np.unravel_index(np.argmin(distance), distance.shape)
    mask = distance <= limit
    value, arrived = q.solved(grid[best], q.angles)
    if not (mask.any() or arrived):
        raise BadInput(f"No {AXES[0]} and {AXES[1]} of the grid give both angles: the closest, "
                       f"{pair(grid[best])}, give {q.both(grid[best])[0]:.3g} and "
                       f"{q.both(grid[best])[1]:.3g} degrees, wanted are {q.angles[0]:.3g} and "
                       f"{q.angles[1]:.3g}; take a wider grid.")
    mask[best] = True
    border = np.ones_like(mask)
    border[1:-1, 1:-1] = False
    border |= ~q.onGrid(grid)
    if (mask & border).any():
        ends = [(grid[mask][:, i].min(), grid[mask][:, i].max()) for i in (0, 1)]
        raise tooLoose("the region of 95 % confidence leaves the grid, where it reaches over "
                       + " and ".join(f"{key} {low:.3g} to {high:.3g}"
                                      for key, (low, high) in zip(AXES, ends)))
    start = np.zeros_like(mask)
    start[best] = True
    rest = mask & ~grown(start, mask)
    if rest.any():
        other = grid[rest][np.argmin(distance[rest])]
        raise BadInput(f"Two pairs give both angles, {pair(grid[best])} and {pair(other)}: take a smaller "
                       "grid, around one of them.")
    if not arrived:
        raise tooLoose(f"at {pair(grid[best])} both angles depend on them in the same way")
    return withErrors(q, value, grid[mask], draws)


def withErrors(q, value, region, draws):
    slopes = np.linalg.inv(q.slopes(value))
    covariance = slopes@np.diag(q.fitErrors(value)**2 + q.errors**2)@slopes.T
    error = np.sqrt(np.diag(covariance))
    random = np.random.default_rng(SEED)
    angles = q.angles + q.errors*random.standard_normal((draws, 2))
    coefficients = []
    for one in q.surfaces:
        spread = np.sqrt(one.freedom/random.chisquare(one.freedom, (draws, 1)))
        root = np.linalg.cholesky(one.covariance + 1e-30*np.eye(len(one.covariance)))
        coefficients.append(one.coefficients + spread*(random.standard_normal((draws, 6))@root.T))
    drawn, arrived = q.solved(np.tile(value, (draws, 1)), angles, coefficients)
    outside = 1 - arrived.mean()
    if outside > 1 - CONFIDENCE:
        raise tooLoose(f"with angles and surfaces drawn within their errors, {100*outside:.0f} % of the "
                       "answers lie outside the grid")
    low, high = np.quantile(drawn[arrived], [0.5*(1 - CONFIDENCE), 0.5*(1 + CONFIDENCE)], axis=0)
    around = np.vstack([region, value])
    return Answer(value, error, covariance[0, 1]/np.prod(error), low, high, around.min(axis=0),
                  around.max(axis=0), outside, q.holds)
