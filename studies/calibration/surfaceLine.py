# SPDX-License-Identifier: GPL-3.0-or-later
"""How steep the free surface of a powder is, from the places of its particles.

The surface above a square of one particle diameter is the highest point of a particle whose centre
lies there; of the squares side by side across the slice the median is taken, so that a particle in
the air does not count. What "highest" adds to the height is the same all along, and leaves no mark
on the slope. A line is fitted to these heights over x; scatter and correlation of the heights about
it make its standard error.

Angles in degrees. A slope that rises with x is positive.
"""
import math

import numpy as np

FEWEST = 6  # heights that a line wants


class NoSurface(Exception):
    """The particles have no surface to measure, one sentence."""


def profile(x, y, z, radius):
    """Places and heights of the surface along x."""
    width = 2*float(np.median(radius))
    column = np.floor((x - x.min())/width).astype(int)
    row = np.floor((y - y.min())/width).astype(int)
    heights = np.full((column.max() + 1, row.max() + 1), -np.inf)
    np.maximum.at(heights, (column, row), z + radius)
    heights[np.isneginf(heights)] = np.nan
    known = np.isfinite(heights).any(axis=1)
    places = x.min() + (np.arange(len(heights)) + 0.5)*width
    return places[known], np.nanmedian(heights[known], axis=1)


def line(x, z):
    """Slope, height at x = 0, and standard error of the slope."""
    n = len(x)
    if n < FEWEST:
        raise NoSurface(f"The surface is {n} particles long where it is measured; {FEWEST} or more "
                        "are wanted: take more powder.")
    slope, height = np.polyfit(x, z, 1)
    left = z - height - slope*x
    # Heights side by side are alike: as many fewer of them are independent.
    alike = max(0.0, min(0.9, np.sum(left[1:]*left[:-1])/max(np.sum(left**2), 1e-300)))
    variance = np.sum(left**2)/(n - 2)*(1 + alike)/(1 - alike)
    return slope, height, math.sqrt(variance/np.sum((x - x.mean())**2))


def inDegrees(slope, error):
    return math.degrees(math.atan(slope)), math.degrees(error/(1 + slope**2))


def flank(x, z, low, high):
    """Line between two heights. What is fitted is chosen by where the line crosses them, not by the
    single heights: that would take the higher ones at one end and the lower ones at the other."""
    near = (z > low) & (z < high)
    for _ in range(30):
        slope, height, error = line(x[near], z[near])
        if slope == 0:
            break
        ends = sorted(((low - height)/slope, (high - height)/slope))
        chosen = (x >= ends[0]) & (x <= ends[1])
        if (chosen == near).all():
            break
        near = chosen
    return slope, height, error


def heap(x, y, z, radius, base=0.0):
    """Of a heap on a table at z = base: both flanks, between 20 and 80 % of its height.

    The standard error is the larger one of that of the two fits and of half the difference between
    left and right."""
    places, heights = profile(x, y, z, radius)
    heights = heights - base
    top = np.argmax(np.convolve(heights, np.ones(3)/3, "same"))
    height = heights[max(0, top - 1):top + 2].mean()
    lines = [flank(places[side], heights[side], 0.2*height, 0.8*height)
             for side in (slice(0, top + 1), slice(top, None))]
    (left, leftError), (right, rightError) = (inDegrees(one[0], one[2]) for one in lines)
    right = -right
    return {"angle": 0.5*(left + right),
            "error": max(0.5*math.hypot(leftError, rightError), 0.5*abs(left - right)),
            "left": left, "right": right, "height": float(height),
            "lines": [(one[0], one[1] + base) for one in lines]}


def inDrum(x, y, z, radius, drumRadius):
    """Slope and height at x = 0 of the surface in the middle half of a drum about the y axis."""
    places, heights = profile(x, y, z, radius)
    reach = 0.5*drumRadius
    near = np.abs(places) < 0.7*reach
    for _ in range(30):
        slope, height, _ = line(places[near], heights[near])
        # From the point of the line that is closest to the axis, along the line.
        foot = -slope*height/(1 + slope**2)
        chosen = np.abs(places - foot) < reach/math.sqrt(1 + slope**2)
        if (chosen == near).all():
            break
        near = chosen
    return slope, height


def meanInTime(values):
    """Mean of a series and its standard error: neighbours are put together into ever longer blocks,
    eight at least, until their means are independent; the largest error counts."""
    values = np.asarray(values, float)
    if len(values) < 8:
        raise NoSurface(f"There are {len(values)} frames of the drum; 8 or more are wanted: raise "
                        "'frames' in system/caseParameters.")
    mean, error, blocks = values.mean(), 0.0, values
    while len(blocks) >= 8:
        error = max(error, blocks.std(ddof=1)/math.sqrt(len(blocks)))
        blocks = blocks[:len(blocks)//2*2].reshape(-1, 2).mean(axis=1)
    return float(mean), float(error)
