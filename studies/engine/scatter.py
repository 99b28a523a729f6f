# SPDX-License-Identifier: GPL-3.0-or-later
"""How far off the mean of few packings may be.

A standard error of few packings is hardly known itself, so that rows which scatter alike are taken together. One that
scatters more would spoil that for all others, and is set apart: Cochran's test, as in ISO 5725-2, for rows of any
number of packings (R. U. E. 't Lam, Anal. Chim. Acta 659 (2010) 68-84). Of rows that are alike, none is so different
from all others in 99 of 100 tables. Set apart, it keeps its own error, times Student's t over 2, so that twice of it is
exceeded as seldom as two standard errors that are known.
"""
import math
from dataclasses import dataclass, field

from scipy.special import fdtrc, stdtrit

ENOUGH = 10  # packings from which on a row's own error is trusted
ONCE = 0.01  # tables of rows that are alike, in which one is set apart
BEYOND = math.erfc(math.sqrt(2))/2  # that a normal number lies above two deviations


@dataclass
class Scatter:
    onePacking: float  # standard deviation, of all rows that are alike; None if each row is trusted alone
    errors: list  # standard error of each row's mean, or None
    apart: list = field(default_factory=list)  # numbers of the rows that scatter more


def together(rows):
    """Of rows (packings, standard error of their mean or None)."""
    alike = {i: row for i, row in enumerate(rows) if row[1] is not None and row[0] > 1}
    if all(packings >= ENOUGH for packings, _ in alike.values()):
        return Scatter(None, [error for _, error in rows])
    apart = []
    while len(alike) > 1:
        chance, worst = min((chanceOf(i, alike), i) for i in alike)
        if chance*len(alike) >= ONCE:
            break
        del alike[worst]
        apart.append(worst)
    one = deviation(alike.values())
    errors = [error*-stdtrit(packings - 1, BEYOND)/2 if i in apart else one/math.sqrt(packings) if packings else error
              for i, (packings, error) in enumerate(rows)]
    return Scatter(one, errors, sorted(apart))


def deviation(rows):
    """Of one packing."""
    freedom = math.fsum(packings - 1 for packings, _ in rows)
    return math.sqrt(math.fsum((packings - 1)*packings*error**2 for packings, error in rows)/freedom)


def chanceOf(i, rows):
    """That a row which is like all others scatters by so much more than they do."""
    others = [row for j, row in rows.items() if j != i]
    here, there = deviation([rows[i]]), deviation(others)
    if here <= there:
        return 1.0
    return fdtrc(rows[i][0] - 1, sum(packings - 1 for packings, _ in others), (here/there)**2) if there > 0 else 0.0
