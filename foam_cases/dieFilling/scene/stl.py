# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles: STL files, what they enclose, and cutting and splitting surfaces as LIGGGHTS needs them."""
import math
import re

import numpy as np

SAME = 1e-8     # points closer than this are one [m]


def read(path):
    data = path.read_bytes()
    if data[:5] == b"solid" and b"facet" in data[:1000]:
        numbers = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)
        return np.array(numbers, float).reshape(-1, 3, 3)
    if len(data) < 134 or len(data) != 84 + 50*int.from_bytes(data[80:84], "little"):
        return np.empty((0, 3, 3))
    kind = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("colour", "<u2")])
    return np.frombuffer(data[84:], kind)["points"].astype(float)


def openEdges(triangles):
    """Edges that are not shared by just two triangles which agree on where outside is: [ends]. Closed: none."""
    points, number = np.unique(np.round(triangles.reshape(-1, 3)/SAME).astype(np.int64), axis=0,
                               return_inverse=True)
    corners = number.reshape(-1, 3)
    ends = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    way = lambda a, b: a*len(points) + b
    ways, times = np.unique(way(*ends.T), return_counts=True)
    single = ways[times == 1]
    partners = np.isin(way(*ends.T), single) & np.isin(way(*ends.T[::-1]), single)
    return SAME*points[ends[~partners]]


def volume(triangles):
    """Enclosed by a closed surface [m3]; negative if its normals point inwards."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))/6)


def plan(triangles):
    """Area of each in plan [m2], positive if it faces up."""
    a, b, c = np.moveaxis(triangles, 1, 0)
    return 0.5*np.cross(b - a, c - a)[:, 2]


def cavity(triangles, d):
    """Volume [m3] of a die and area of its mouth [m2], of a body of table and die whose table is z = 0. Over each
    place of the mouth there is ground below: each triangle bounds a column up to the table."""
    if d["rig"] == "slice":
        triangles = np.array(cut(triangles.tolist(), d["dieYLow"], d["dieYHigh"]))
    middle = triangles.mean(axis=1)
    inside = ((middle[:, 0] > -SAME) & (middle[:, 0] < d["dieXHigh"] + SAME)
              & (np.abs(middle[:, 1]) < d["dieYHigh"] + SAME) & (middle[:, 2] < -SAME)
              & (triangles[:, :, 2].min(axis=1) > d["dieZLow"] - SAME))
    area = plan(triangles[inside])
    return float(-np.sum(area*middle[inside, 2])), float(np.sum(area))


def cut(triangles, low, high):
    """What lies between two planes in y: LIGGGHTS loses triangles whose centre leaves the box."""
    kept = []
    for triangle in triangles:
        points = list(triangle)
        for side, plane in ((1, low), (-1, high)):
            inside = lambda q: side*(q[1] - plane) >= 0
            result = []
            for a, b in zip(points, points[1:] + points[:1]):
                if inside(a):
                    result.append(a)
                if inside(a) != inside(b):
                    s = (plane - a[1])/(b[1] - a[1])
                    result.append(tuple(a[k] + s*(b[k] - a[k]) for k in range(3)))
            points = result
        fan = [(points[0], points[i], points[i + 1]) for i in range(1, len(points) - 1)]
        kept += [t for t in fan if np.linalg.norm(np.cross(np.subtract(t[1], t[0]),
                                                           np.subtract(t[2], t[0]))) > 1e-14]
    return kept


def split(triangles, longest):
    """The same surface in smaller pieces, as LIGGGHTS cannot insert powder beside large ones. An
    edge is halved or not by its length alone, so that triangles on both sides of it still meet."""
    done, left = [], list(triangles)
    while left:
        a, b, c = left.pop()
        middle = lambda u, v: tuple(0.5*(x + y) for x, y in zip(u, v))
        length = [math.dist(a, b), math.dist(b, c), math.dist(c, a)]
        long = [s > longest for s in length]
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        if all(long):
            left += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        elif any(long):
            i = length.index(max(length))
            p, q, r = ((a, b, c), (b, c, a), (c, a, b))[i]
            m = (ab, bc, ca)[i]
            left += [(p, m, r), (m, q, r)]
        else:
            done.append((a, b, c))
    return done


def write(path, triangles):
    lines = [f"solid {path.stem}"]
    for t in triangles:
        n = np.cross(np.subtract(t[1], t[0]), np.subtract(t[2], t[0]))
        n = n/np.linalg.norm(n)
        lines.append("facet normal {:.6g} {:.6g} {:.6g}\n outer loop".format(*n))
        lines += ["  vertex {:.9g} {:.9g} {:.9g}".format(*point) for point in t]
        lines.append(" endloop\nendfacet")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + f"\nendsolid {path.stem}\n")
