# SPDX-License-Identifier: GPL-3.0-or-later
"""The slices of the map: pairs of parameters, each over its range, all else as in the die filling study
(grains of 40 um, 6000 times as dense as the air, void fraction 0.4)."""
import collections

from boxes import box
from plugs import plug
from shoes import Shoe

Axis = collections.namedtuple("Axis", "label values")
Slice = collections.namedtuple("Slice", "name title x y make")

CHOSEN = "chosen"  # by the solver, instead of a fixed value
STIFFNESS = Axis("fixed step over the response time of the powder",
                 (CHOSEN, 0.1, 0.3, 0.9, 1.5, 3, 10, 30))
DENSITY = Axis("density of the powder over that of the air", (1.1, 1.5, 2.5, 5, 10, 100, 1000, 10000))
VOID = Axis("void fraction", (0.26, 0.36, 0.4, 0.5, 0.6, 0.8, 0.95, 0.999))
K = Axis("coarse graining k", (1, 2, 4, 10, 20))
SIZE = Axis("parcel size over cell size", (0.1, 0.25, 0.5, 1, 2, 4))
SPEED = Axis("speed of the shoe [m/s]", (0.01, 0.05, 0.15, 0.5, 1.5, 5))


def step(x):
    """A step of so many response times, or the solver's own, as options of a scene."""
    return {"chosen": True} if x == CHOSEN else {"stiffness": x}


def slices():
    return [
        Slice("density", "plug in one piece over closed air", STIFFNESS, DENSITY,
              lambda name, x, y, **o: plug(name, density=y, **step(x), **o)),
        Slice("densityFree", "plug of free grains over closed air", STIFFNESS, DENSITY,
              lambda name, x, y, **o: plug(name, density=y, tied=False, width=2, **step(x), **o)),
        Slice("void", "plug in one piece over closed air", STIFFNESS, VOID,
              lambda name, x, y, **o: plug(name, void=y, **step(x), **o)),
        Slice("k", "plug of free grains, cells of two parcels", STIFFNESS, K,
              lambda name, x, y, **o: plug(name, k=y, tied=False, width=2, **step(x), **o)),
        Slice("size", "plug of free grains, not smoothed, step chosen", SIZE,
              Axis(VOID.label, (0.26, 0.36, 0.4, 0.6, 0.8)),
              lambda name, x, y, **o: plug(name, ratio=x, void=y, tied=False, chosen=True, **o)),
        Slice("sizeSmoothed", "the same, smoothed over two parcels", SIZE,
              Axis(VOID.label, (0.26, 0.36, 0.4, 0.6, 0.8)),
              lambda name, x, y, **o: plug(name, ratio=x, void=y, tied=False, chosen=True,
                                           smoothing=2, **o)),
        Slice("box", "parcels with contacts settle in a closed box, not smoothed",
              Axis(STIFFNESS.label, (CHOSEN, 0.1, 0.3, 0.9, 1.5, 3)),
              Axis(SIZE.label, (0.5, 1, 2, 4)),
              lambda name, x, y, **o: box(name, ratio=y, **step(x), **o)),
        Slice("shoe", "empty shoe", Axis("cells that it crosses in a fixed step",
                                         (CHOSEN, 0.05, 0.2, 0.5, 1, 2)), SPEED,
              lambda name, x, y, **o: Shoe(name, y, **({"chosen": True} if x == CHOSEN else
                                                       {"step": x}), **o)),
        Slice("shoeFilled", "filled shoe, step chosen", Axis("cell [mm]", (0.4, 0.6, 1.2)), SPEED,
              lambda name, x, y, **o: Shoe(name, y, cell=x, filled=True, chosen=True, **o))]
