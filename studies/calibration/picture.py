# SPDX-License-Identifier: GPL-3.0-or-later
"""How pictures of the calibration scenes look."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection

ink, blue, red = "#22303c", "#2166ac", "#b2182b"
mm = 1e3
plt.rcParams.update({"font.size": 10, "axes.edgecolor": ink, "axes.labelcolor": ink,
                     "axes.spines.top": False, "axes.spines.right": False, "text.color": ink,
                     "xtick.color": ink, "ytick.color": ink, "savefig.dpi": 160})


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
