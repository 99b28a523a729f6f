# SPDX-License-Identifier: GPL-3.0-or-later
"""The middle of die and shoe, seen from the side: parcels and walls, in mm."""
import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.colors import ListedColormap
from matplotlib.patches import Circle, Rectangle

from cavity import Cavity
from runFolder import shoeAt

MM = 1e3
FLOOR = 0.8  # thickness in which table and floor are drawn [mm]


def parcels(axes, x, data, fastest, **looks):
    """Those that lie along the middle, the nearest in front, coloured by speed up to the fastest."""
    diameter = data["d"][:, 0]
    speed = np.linalg.norm(data["U"], axis=1)
    cut = np.abs(x[:, 1]) < 0.75*diameter.max()
    order = np.argsort(-np.abs(x[cut, 1]))
    patches = [Circle((MM*p[0], MM*p[2]), MM*r/2)
               for p, r in zip(x[cut][order], diameter[cut][order])]
    dots = PatchCollection(patches, **{**dict(cmap="YlOrBr", edgecolor="#5a4632", lw=0.15), **looks})
    dots.set_array(speed[cut][order])
    dots.set_clim(0, fastest)
    axes.add_collection(dots)
    return dots


def walls(axes, d, t):
    """Table, die, and shoe where it stands at a time."""
    looks = dict(color="0.55", lw=0, zorder=2)
    low, deep = MM*d["xLow"], MM*d["dieDepth"]
    length, right = MM*d["dieLength"], MM*d["xHigh"]
    axes.add_patch(Rectangle((low, -deep - FLOOR), -low, deep + FLOOR, **looks))
    axes.add_patch(Rectangle((length, -deep - FLOOR), right - length, deep + FLOOR, **looks))
    axes.add_patch(Rectangle((0, -deep - FLOOR), length, FLOOR, **looks))
    height, wall = MM*d["zHigh"], MM*d["shoeWallThickness"]
    for face, side in ((d["shoeXLow"], -wall), (d["shoeXHigh"], wall)):
        axes.add_patch(Rectangle((MM*(face + shoeAt(d, t)), 0), side, height, alpha=0.8, **looks))


def die(axes, d, triangles):
    """What of the die's box is no cavity, in the middle of the width. triangles: of a die that is no box."""
    cavity = Cavity.of(d, triangles)
    solid = ~cavity.room[:, cavity.room.shape[1]//2]
    extent = (0, MM*d["dieXHigh"], MM*d["dieZLow"], 0)
    axes.imshow(np.where(solid, 1, np.nan).T, extent=extent, origin="lower", zorder=2,
                cmap=ListedColormap(["0.55"]))
