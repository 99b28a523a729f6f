# SPDX-License-Identifier: GPL-3.0-or-later
"""An angle as a smooth function of friction and rolling friction, fitted to a study's table.

    angle = c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2 + c6 s^2 t + c7 s t^2

s and t are friction and rolling friction, or their logarithms, or the reciprocal of friction (as grains
roll before they slide, angles level off at high friction) and rolling friction, brought to -1 .. 1 over
the table. A row that is a mean over n packings has the weight n. The scatter of one run is taken from the packings and
from the rows' distances to the surface together, or from the latter alone if that is clearly more: then
the surface does not fit, which `misfit` tells.
"""
import numpy as np

from badInput import BadInput

AXES = "friction", "rollingFriction"
TERMS = 8
# What s and t are: a function of friction, one of rolling friction, each with its derivative.
PLAIN, LOG, RECIPROCAL = (lambda x: x, np.ones_like), (np.log, lambda x: 1/x), (lambda x: 1/x, lambda x: -1/x**2)
OVER = {"plain": (PLAIN, PLAIN), "logs": (LOG, LOG), "saturating": (RECIPROCAL, PLAIN)}
LACK = 2.0  # ratio of the variances about the surface and among packings that is a misfit


class Points:
    """Rows of a table that have an angle."""

    def __init__(self, table, rows, angle):
        self.name, self.angle = table.name, angle
        for key in (*AXES, angle):
            if key not in table.columns:
                raise BadInput(f"{table.name} has no column '{key}': it must be the table.csv of a study "
                               f"over {AXES[0]} and {AXES[1]} that measures {angle}.")
        self.constants = self.readConstants(rows)
        good = [row for row in rows if row[angle] not in ("", None)]
        self.leftOut = len(rows) - len(good)
        number = lambda row, key, default: float(row.get(key) or default)
        try:
            self.x = np.array([[float(row[key]) for key in AXES] for row in good]).reshape(-1, 2)
            self.y = np.array([float(row[angle]) for row in good])
            self.error = np.array([number(row, angle + ".error", "nan") for row in good])
            self.packings = np.array([number(row, "packings", 1) for row in good])
        except ValueError as reason:
            raise BadInput(f"{table.name}: there is a word where a number is wanted, {reason}.")
        self.checkGrid()

    def readConstants(self, rows):
        """All other parameters, which stand left of `status`, must be the same in all rows."""
        keys = list(rows[0])
        keys = keys[:keys.index("status")] if "status" in keys else []
        keys = [key for key in keys if key not in (*AXES, "variant")]
        for key in keys:
            values = sorted({row[key] for row in rows})
            if len(values) > 1:
                raise BadInput(f"The rows of {self.name} differ in {key}, which is {', '.join(values)}: "
                               f"choose one by --where {key}=VALUE.")
        return {key: rows[0][key] for key in keys}

    def checkGrid(self):
        if len(self.y) < TERMS + 1:
            raise BadInput(f"{self.name} has {len(self.y)} rows with {self.angle}; {TERMS + 1} or more are "
                           f"wanted for a surface over {AXES[0]} and {AXES[1]}.")
        for axis, key in enumerate(AXES):
            if len(set(self.x[:, axis])) < 3:
                raise BadInput(f"{self.name} has fewer than 3 values of {key}: a curved surface wants 3.")
        if np.linalg.matrix_rank(terms(scaled(self.x, *ends(self.x)))) < TERMS:
            raise BadInput(f"The rows of {self.name} lie so that they do not make a surface over "
                           f"{AXES[0]} and {AXES[1]}: take all combinations of both.")


def ends(x):
    return x.min(axis=0), x.max(axis=0)


def scaled(x, low, high):
    return (2*x - low - high)/(high - low)


def terms(s):
    s, t = s[..., 0], s[..., 1]
    return np.stack([np.ones_like(s), s, t, s*s, s*t, t*t, s*s*t, s*t*t], axis=-1)


def slopesOfTerms(s):
    """With respect to s, and to t."""
    s, t = s[..., 0], s[..., 1]
    one, zero = np.ones_like(s), np.zeros_like(s)
    return (np.stack([zero, one, zero, 2*s, t, zero, 2*s*t, t*t], axis=-1),
            np.stack([zero, zero, one, zero, s, 2*t, s*s, 2*s*t], axis=-1))


class Surface:
    """The fit; `over`: what s and t are, a key of OVER."""

    def __init__(self, points, over):
        self.over = over
        self.low, self.high = ends(self.own(points.x))
        design = self.terms(points.x)
        root = np.sqrt(points.packings)
        self.coefficients, *_ = np.linalg.lstsq(design*root[:, None], points.y*root, rcond=None)
        left = points.y - design@self.coefficients
        self.setVariance(points, np.sum(points.packings*left**2))
        inverse = np.linalg.inv(design.T@(design*points.packings[:, None]))
        self.covariance = self.variance*inverse
        self.furthest = np.max(np.sum(design@inverse*design, axis=1))
        self.inverse = inverse

    def setVariance(self, points, aboutSurface):
        """Of one run. `freedom`: how many independent numbers it is from."""
        free = len(points.y) - TERMS
        about = aboutSurface/free
        known = np.isfinite(points.error) & (points.packings > 1)
        n, error = points.packings[known], points.error[known]
        among, freeAmong = np.sum((n - 1)*n*error**2), np.sum(n - 1)
        self.scatterAbout, self.scatterAmong = np.sqrt(about), None
        self.misfit = False
        if freeAmong > 0 and among > 0:
            self.scatterAmong = np.sqrt(among/freeAmong)
            self.misfit = about > LACK*among/freeAmong
        if self.misfit or self.scatterAmong is None:
            self.variance, self.freedom = about, free
        else:
            self.variance, self.freedom = (aboutSurface + among)/(free + freeAmong), free + freeAmong

    def own(self, x):
        x = np.asarray(x, float)
        return np.stack([function(x[..., i]) for i, (function, _) in enumerate(OVER[self.over])], axis=-1)

    def terms(self, x):
        return terms(scaled(self.own(x), self.low, self.high))

    def at(self, x, coefficients=None):
        return np.sum(self.terms(x)*(self.coefficients if coefficients is None else coefficients), axis=-1)

    def slopes(self, x, coefficients=None):
        """Derivatives with respect to friction and rolling friction."""
        c = self.coefficients if coefficients is None else coefficients
        x = np.asarray(x, float)
        both = slopesOfTerms(scaled(self.own(x), self.low, self.high))
        inner = np.stack([slope(x[..., i]) for i, (_, slope) in enumerate(OVER[self.over])], axis=-1)
        return np.stack([np.sum(rows*c, axis=-1) for rows in both], axis=-1)*inner*2/(self.high - self.low)

    def error(self, x):
        """Standard error of the surface itself."""
        rows = self.terms(x)
        return np.sqrt(np.sum(rows@self.covariance*rows, axis=-1))

    def holds(self, x):
        """Whether this is no further from the rows than the furthest of them."""
        rows = self.terms(x)
        return np.sum(rows@self.inverse*rows, axis=-1) <= 1.0001*self.furthest


def fit(points, axes="best"):
    """Over what `axes` says, a key of OVER, or over what fits best."""
    positive = (points.x > 0).all()
    if axes not in ("best", "plain") and not positive:
        raise BadInput(f"{points.name} has a coefficient of zero, which has no logarithm and no reciprocal: leave out "
                       f"--axes {axes}.")
    choices = (OVER if positive else ["plain"]) if axes == "best" else [axes]
    return min((Surface(points, over) for over in choices), key=lambda one: one.scatterAbout)
