# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the parcels of a run lie at its last time, as OpenFOAM wrote them."""
import re
import struct

LIST = re.compile(rb"\n(\d+)\s*\(\s?")


class NoPowder(Exception):
    """One sentence for the user."""


def parcels(home):
    """Positions at the last time, of all ranks."""
    ranks = sorted(home.glob("processor[0-9]*")) or [home]
    times = [path.name for path in ranks[0].iterdir() if isTime(path.name)]
    last = max(times, key=float, default=None)
    files = [rank/last/"lagrangian/powder/positions" for rank in ranks if last]
    points = [point for path in files if path.is_file() for point in positions(path)]
    if not points:
        raise NoPowder(f"The folder {home} holds no powder at its last time "
                       f"({last or 'there is none'}): run that variant again.")
    return points


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


def binary(content, at, count):
    """Three doubles and a label in brackets, each on a line of its own."""
    points = []
    for _ in range(count):
        at = content.index(b"(", at) + 1
        points.append(struct.unpack_from("<3d", content, at))
        at = content.index(b")", at + 28)
    return points
