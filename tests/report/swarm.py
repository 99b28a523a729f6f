# SPDX-License-Identifier: GPL-3.0-or-later
"""Lays points out side by side in a strip."""

WIDTH = 0.016  # of a point, of the length of the strip


def swarm(places):
    """Heights within a strip for points at these places (0 .. 1 along it), so that all are seen."""
    levels = [0] + [sign*n for n in range(1, len(places)) for sign in (1, -1)]
    taken = []
    for place in places:
        beside = {level for other, level in taken if abs(other - place) < WIDTH}
        taken.append((place, next(level for level in levels if level not in beside)))
    highest = max((abs(level) for _, level in taken), default=0)
    return [level*min(0.13, 0.4/max(highest, 1)) for _, level in taken]
