# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in the folder of a run: its numbers, and air and powder at the instants that were kept."""
import re
from xml.etree import ElementTree

import numpy as np

TIME = re.compile(rb"TimeValue 1 1 \w+\s+(\S+)")


def derived(folder):
    """Parameters and what follows from them: key -> number or word."""
    return {**numbers(folder/"system/caseParameters"), **numbers(folder/"system/caseDerived")}


def numbers(dictionary):
    found = {}
    for line in dictionary.read_text().splitlines():
        words = line.split("//")[0].replace(";", " ").split()
        if len(words) == 2:
            try:
                found[words[0]] = float(words[1])
            except ValueError:
                found[words[0]] = words[1]
    return found


def shoeAt(d, t):
    """Travel [m]: half a cosine of ramp, then full speed."""
    v, ramp = d["shoeSpeed"], d["rampTime"]
    s = min(t, ramp)
    risen = 0.5*(s - ramp/np.pi*np.sin(np.pi*s/ramp)) if ramp > 0 else 0
    return v*(risen + max(0, t - ramp))


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
            centres, at = points[take(size, int).reshape(-1, 9)[:, 1:]].mean(axis=1), at + size
        elif word == "FIELD":
            count, at = int(words[at + 2]), at + 3
            for _ in range(count):
                name, width, n, at = words[at], int(words[at + 1]), int(words[at + 2]), at + 4
                data[name], at = take(width*n).reshape(-1, width), at + width*n
        else:
            at += 1
    return float(data["TimeValue"][0, 0]), centres, data


def parcels(path):
    """Positions and named data of a cloud in VTK's XML format, ASCII."""
    data = {}
    for array in ElementTree.parse(path).iter("DataArray"):
        values = np.array(array.text.split(), float)
        data[array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents", 1)))
    return data["Points"], data
