# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in the folder of a run: its numbers and tables, and air and powder at the instants that were kept."""
import re
from xml.etree import ElementTree

import numpy as np

import parameters
import runTables
import shoePath

TIME = re.compile(rb"TimeValue 1 1 \w+\s+(\S+)")


def derived(folder):
    """Parameters and what follows from them: key -> number or word; and path, the shoe's (scene/shoePath.py)."""
    d = parameters.read(folder/"system/caseParameters", folder/"system/caseDerived")
    return {**d, "path": shoePath.read(folder, d)}


def shoeAt(d, t):
    """Travel [m]."""
    return (d.get("path") or shoePath.Ramped(d)).at(t)


def stations(d):
    """When the shoe's walls pass the edges of the die."""
    length, front, rear = d["dieLength"], d["shoeXHigh"], d["shoeXLow"]
    passed = ((-front, "front wall reaches the die"), (length - front, "front wall has crossed"),
              (-rear, "rear wall reaches the die"), (length - rear, "rear wall has crossed"))
    moments = [(d["path"].when(travel), text) for travel, text in passed]
    return [(time, text) for time, text in moments if time is not None]


def table(folder, name):
    """Columns of a function object's table, or None."""
    rows = runTables.joined(folder, f"{name}/*/{name}.dat")
    return np.array(rows, float) if rows else None


def instants(folder, name="VTK"):
    """Files of cells and parcels that foamToVTK wrote, in order of time, the start left out."""
    found = []
    for file in (folder/name).glob("*_*.vtk"):
        number = file.stem.split("_")[-1]
        cloud = file.parent/f"lagrangian/powder/powder_{number}.vtp"
        if cloud.is_file():
            found.append((int(number), file, cloud))
    return [files for _, *files in sorted(found)]


def timeOf(path):
    """Of an ASCII file of VTK's old format."""
    with open(path, "rb") as file:
        return float(TIME.search(file.read(1000))[1])


def cells(path):
    """Time, centre of each cell, and named cell data of an ASCII file of VTK's old format."""
    words = path.read_text().split()
    at, time, points, centres, data = 0, None, None, None, {}
    take = lambda n, kind=float: np.array(words[at:at + n], dtype=kind)
    while at < len(words) and words[at] != "POINT_DATA":
        word = words[at]
        if word == "POINTS":
            n, at = int(words[at + 1]), at + 3
            points, at = take(3*n).reshape(-1, 3), at + 3*n
        elif word == "CELLS":
            size, at = int(words[at + 2]), at + 3
            centres, at = middles(points, take(size, int)), at + size
        elif word == "FIELD":
            count, at = int(words[at + 2]), at + 3
            for _ in range(count):
                name, width, n, at = words[at], int(words[at + 1]), int(words[at + 2]), at + 4
                data[name], at = take(width*n).reshape(-1, width), at + width*n
        else:
            at += 1
    return float(data["TimeValue"][0, 0]), centres, data


def middles(points, lists):
    """Of cells, each a count and as many points: those at a die's slanting walls have fewer than eight."""
    heads, at = [], 0
    while at < len(lists):
        heads.append(at)
        at += lists[at] + 1
    heads = np.array(heads)
    mine = np.delete(lists, heads)
    starts = heads - np.arange(len(heads))
    return np.add.reduceat(points[mine], starts)/lists[heads][:, None]


def parcels(path):
    """Positions and named data of a cloud in VTK's XML format, ASCII."""
    data = {}
    for array in ElementTree.parse(path).iter("DataArray"):
        values = np.array(array.text.split(), float)
        data[array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents", 1)))
    return data["Points"], data
