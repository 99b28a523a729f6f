# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels of the calibration scenes, drawn."""
import numpy as np
from matplotlib.collections import EllipseCollection
from picture import mm


def parcels(axes, grains, some=None, **colours):
    """Parcels seen along y, the ones in front last; of `some` only (a mask), by speed unless told otherwise."""
    order = np.argsort(grains["y"])
    if some is not None:
        order = order[some[order]]
    size = 2*mm*grains["radius"][order]
    colours = colours or dict(array=np.hypot(grains["vx"], grains["vz"])[order], cmap="viridis")
    return axes.add_collection(EllipseCollection(
        size, size, 0*size, units="xy", offsets=mm*np.column_stack([grains["x"], grains["z"]])[order],
        offset_transform=axes.transData, edgecolors="white", linewidths=0.15, **colours))
