# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows from the parameters: where things stand, how many cells and parcels there are.

Origin: on the table, at the die's near edge, in the middle of its width.
"""
import math

import numpy as np

import resolution
import shoePath
import stl
from wrong import refuse


def rig(p, path=None):
    """Key -> number or vector, for every other dictionary: where things stand. path: the shoe's, if not by its speed."""
    path = path or shoePath.Ramped(p)
    d = {"rig": "full" if p["sliceWidth"] <= 0 else "slice"}
    d["boundaryY"] = "f" if d["rig"] == "full" else "p"
    shoe(p, d, path)
    mesh(p, d)
    measured(p, d)
    d["hertzFraction"] = 0.75*p["rayleighFraction"]
    d["kinematicViscosity"] = p["airViscosity"]/p["airDensity"]
    return d


def powder(p, d, given, sizes):
    """The same of the powder. given: triangles of surfaces that are not made as usual; sizes: None if all particles
    have the same."""
    particlesBox(p, d, given)
    parcels(p, d, given["die"], sizes)


def shoe(p, d, path):
    """The shoe starts short of the die and stops beyond it, clear by a few parcels."""
    clear, wall = 1e-3, p["shoeWallThickness"]
    if p["powderHeight"] >= p["shoeHeight"]:
        refuse("The powder must not be higher than the shoe, or it would run over its walls.",
               f"powderHeight {p['powderHeight']:g} m   system/caseParameters",
               f"less than shoeHeight, {p['shoeHeight']:g} m", "Pour less powder, or make the shoe higher.")
    d["shoeXHigh"] = -(wall + clear)
    d["shoeXLow"] = d["shoeXHigh"] - p["shoeLength"]
    d["shoeYHigh"] = 0.5*(p["shoeWidth"] if d["rig"] == "full" else p["sliceWidth"])
    d["shoeYLow"] = -d["shoeYHigh"]
    d["travel"] = p["dieLength"] + wall + clear - d["shoeXLow"]
    d["endTime"] = endTime(p, d, path)
    d["pictureInterval"] = d["endTime"]/p["pictures"]
    d["overDie"] = 0.5*p["dieLength"] - 0.5*(d["shoeXLow"] + d["shoeXHigh"])


def endTime(p, d, path):
    """When the shoe has passed, or its table ends; in the room that there is."""
    if isinstance(path, shoePath.Ramped):
        return round(path.when(d["travel"]), 4)
    low, high = path.farthest()
    if low < -1e-9 or high > d["travel"] + 1e-9:
        refuse("The shoe must stay in the room that it crosses.",
               f"from {low:.6g} to {high:.6g} m   shoePath {p['shoePath']}",
               f"0 to {d['travel']:.6g} m, from where it stands to beyond the die", "Correct the table.")
    return path.end


def mesh(p, d):
    """The shoe on all its way, and room for the air beside it and above the powder."""
    full, room, wall = d["rig"] == "full", p["room"], p["shoeWallThickness"]
    d["xLow"] = d["shoeXLow"] - wall - room
    d["xHigh"] = d["shoeXHigh"] + d["travel"] + wall + room
    d["dieYHigh"] = 0.5*(p["dieWidth"] if full else p["sliceWidth"])
    d["yHigh"] = d["shoeYHigh"] + wall + room if full else d["dieYHigh"]
    d["yLow"], d["dieYLow"] = -d["yHigh"], -d["dieYHigh"]
    d["zHigh"] = 1.1*p["powderHeight"] + room
    d["dieXHigh"], d["dieZLow"] = p["dieLength"], -p["dieDepth"]
    cells = {"nUpstream": -d["xLow"], "nDie": p["dieLength"],
             "nDownstream": d["xHigh"] - p["dieLength"], "nAcross": 2*d["dieYHigh"],
             "nBeside": d["yHigh"] - d["dieYHigh"], "nAbove": d["zHigh"], "nDeep": p["dieDepth"]}
    cells.update(nAlong=d["xHigh"] - d["xLow"], nWide=2*d["yHigh"])
    d.update({key: max(1, round(length/p["cellSize"])) for key, length in cells.items()})
    d["nBelow"] = d["nDeep"] + 2
    d["backgroundZLow"] = d["dieZLow"]*d["nBelow"]/d["nDeep"]
    d["inTheAir"] = point(0.5*p["dieLength"] + 0.123*p["cellSize"], 0.217*p["cellSize"], 0.319*p["cellSize"])


def measured(p, d):
    """Boxes of what is measured: the cavity, and the room in the shoe where it starts."""
    d["cavityLow"] = point(0, d["dieYLow"], d["dieZLow"])
    d["cavityHigh"] = point(p["dieLength"], d["dieYHigh"], 0)
    d["floorProbe"] = point(0.5*p["dieLength"] + 0.123*p["cellSize"], 0.217*p["cellSize"],
                            d["dieZLow"] + 0.3*p["cellSize"])
    d["shoeLow"] = point(d["shoeXLow"], d["shoeYLow"], 0)
    d["shoeHigh"] = point(d["shoeXHigh"], d["shoeYHigh"], p["shoeHeight"])


def particlesBox(p, d, given):
    """LIGGGHTS' box: all that the shoe sweeps, whatever the mesh of the air. Its sides are walls."""
    full, around = d["rig"] == "full", 8e-3
    d["demXLow"], d["demXHigh"] = d["shoeXLow"] - around, d["shoeXHigh"] + d["travel"] + around
    d["demYHigh"] = d["shoeYHigh"] + (around if full else 0)
    d["demYLow"] = -d["demYHigh"]
    # The column from which dieFillingPour.in pours may be higher than the shoe.
    column = 0.58/0.25*p["powderHeight"] + 4*p["coarseGraining"]*p["particleDiameter"]
    d["demZLow"], d["demZHigh"] = -1.2*p["dieDepth"], max(p["shoeHeight"], 1.1*column) + around
    for corner in np.concatenate(list(given.values())).reshape(-1, 3):
        d["demXLow"], d["demXHigh"] = reach(d["demXLow"], d["demXHigh"], corner[0])
        d["demZLow"], d["demZHigh"] = reach(d["demZLow"], d["demZHigh"], corner[2])
        if full:
            d["demYLow"], d["demYHigh"] = reach(d["demYLow"], d["demYHigh"], corner[1])


def parcels(p, d, die, sizes):
    """How many in the shoe; and, for the die that is completely filled, in the die and 2 mm above. Of
    several sizes, the parcel's diameter is the Sauter mean."""
    k = p["coarseGraining"]
    d["parcelDiameter"] = k*(sizes.sauter() if sizes else p["particleDiameter"])
    parcel = math.pi/6*(k*sizes.meanVolume() if sizes else d["parcelDiameter"])**3
    base = p["shoeLength"]*2*d["shoeYHigh"]
    d["bedParcels"] = round(0.58*p["powderHeight"]*base/parcel)
    cavity = stl.cavity(die, d)[0] if len(die) else p["dieLength"]*2*d["dieYHigh"]*p["dieDepth"]
    d["cavityVolume"] = cavity
    d["airVolume"] = (d["xHigh"] - d["xLow"])*(d["yHigh"] - d["yLow"])*d["zHigh"] + cavity
    d["referenceParcels"] = round(0.58*(2e-3*base + cavity)/parcel)
    d["smoothingWidth"] = p["smoothingDiameters"]*d["parcelDiameter"]
    d["parcelShare"] = resolution.parcelShare(p, d["parcelDiameter"])
    resolution.tell(p, d)
    if sizes:
        d["sauterDiameter"] = sizes.sauter()
        d["meanVolumeDiameter"] = sizes.meanVolume()
        d["meanVolumeRadius"] = 0.5*k*sizes.meanVolume()
        d["smallestRadius"], d["largestRadius"] = 0.5*k*sizes.diameters[[0, -1]]


def point(*x):
    return "({:.9g} {:.9g} {:.9g})".format(*x)


def reach(low, high, x):
    """An interval that holds x as well, not at its very end."""
    margin = 1e-4
    return min(low, x - margin), max(high, x + margin)
