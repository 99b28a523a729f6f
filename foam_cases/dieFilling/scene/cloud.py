# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the parcels of a run lie at its last time, as OpenFOAM wrote them."""
import re
import struct

import numpy as np

LIST = re.compile(rb"\n(\d+)\s*\(\s?")


class NoPowder(Exception):
    """One sentence for the user."""


def parcels(home):
    """Positions at the last time, of all ranks."""
    last, folders = lastTime(home)
    points = [point for folder in folders for point in positions(folder/"positions")]
    if not points:
        raise NoPowder(f"The folder {home} holds no powder at its last time "
                       f"({last or 'there is none'}): run that variant again.")
    return points


def diameters(home):
    """The same of their diameters [m], in the same order."""
    return np.concatenate([numbers(folder/"d") for folder in lastTime(home)[1]])


def lastTime(home):
    """Its name, and the folders of powder there; a rank without any has none."""
    ranks = sorted(home.glob("processor[0-9]*")) or [home]
    times = [path.name for path in ranks[0].iterdir() if isTime(path.name)]
    last = max(times, key=float, default=None)
    folders = [rank/last/"lagrangian/powder" for rank in ranks] if last else []
    return last, [folder for folder in folders if (folder/"positions").is_file()]


def isTime(name):
    try:
        return float(name) > 0
    except ValueError:
        return False


def positions(path):
    """Of OpenFOAM's list '(x y z) cell', written in binary or as text."""
    content = path.read_bytes()
    start = content.find(b"// * *")
    found = LIST.search(content, start) if start >= 0 else None
    if found is None:
        return []
    count, at = int(found[1]), found.end()
    try:
        if re.search(rb"format\s+binary", content[:start]):
            return binary(content, at, count)
        lines = content[at:].decode().split("\n")[:count]
        return [tuple(map(float, line[1:line.index(")")].split())) for line in lines]
    except (ValueError, struct.error):
        raise NoPowder(f"The file {path} is torn: run that variant again.")


def numbers(path):
    """Of OpenFOAM's list of numbers, written in binary or as text; a list of one value may be short, N{value}."""
    if not path.is_file():
        return np.empty(0)  # of a rank without powder
    content = path.read_bytes()
    start = content.find(b"// * *")
    same = re.compile(rb"\n(\d+)\s*{([^}]*)}").search(content, start)
    found = LIST.search(content, start)
    try:
        if same:
            return np.full(int(same[1]), float(same[2]))
        if not found:
            return np.empty(0)
        if re.search(rb"format\s+binary", content[:start]):
            return np.frombuffer(content, "<f8", int(found[1]), content.index(b"(", found.start()) + 1)
        return np.array(content[found.end():].split(b")")[0].split(), float)
    except ValueError:
        raise NoPowder(f"The file {path} is torn: run that variant again.")


def binary(content, at, count):
    """Three doubles and a label in brackets, each on a line of its own."""
    points = []
    for _ in range(count):
        at = content.index(b"(", at) + 1
        points.append(struct.unpack_from("<3d", content, at))
        at = content.index(b")", at + 28)
    return points
