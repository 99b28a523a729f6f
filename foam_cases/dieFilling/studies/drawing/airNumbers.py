# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast the air in the die is, and how much it turns: numbers to the figure airSections.

In the cavity, where air is free: outside the powder's bulk and outside of solids. The vorticity is
OpenFOAM's curl of the interstitial velocity; its y component is positive where the air turns clockwise
in the figure, with the shoe. Clockwise and counter are told apart: at walls that hold the air, all
circulation together is only what moves along the die's mouth, whatever turns below.
"""
import csv

import numpy as np

from tables import meanAndError

BULK = 0.7  # void fraction below which powder lies packed or nearly so
NAMES = ("meanVorticity", "peakVorticity", "circulationClockwise", "circulationCounter", "meanAirSpeed",
         "peakAirSpeed", "freeAirShare")


def of(d, centres, data):
    """Of one run at one instant. Vorticity [1/s], circulation [m2/s], speed [m/s], share of the cavity."""
    cavity = ((centres[:, 0] > 0) & (centres[:, 0] < d["dieLength"]) & (centres[:, 2] < 0)
              & (centres[:, 2] > d["dieZLow"]) & (np.abs(centres[:, 1]) < d["dieYHigh"]))
    free = cavity & (data["voidFraction"][:, 0] >= BULK) & (data["solid"][:, 0] < 0.5)
    if not free.any():
        return {**dict.fromkeys(NAMES), "freeAirShare": 0.0}
    turning = data["vorticity"][free, 1]
    speed = np.linalg.norm(data["U"][free], axis=1)
    # All cells of the cavity are alike, and the mean over its width is meant.
    area = d["dieLength"]*d["dieDepth"]/np.count_nonzero(cavity)
    return dict(zip(NAMES, map(float, (
        np.abs(turning).mean(), np.abs(turning).max(), turning[turning > 0].sum()*area,
        -turning[turning < 0].sum()*area, speed.mean(), speed.max(),
        np.count_nonzero(free)/np.count_nonzero(cavity)))))


def averaged(packings):
    """Means over packings and their standard errors, as in table.csv."""
    row = {}
    for name in NAMES:
        row[name], row[f"{name}.error"] = meanAndError([one[name] for one in packings])
    return row


def write(path, rows):
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value
                             for key, value in row.items()})
    return path
