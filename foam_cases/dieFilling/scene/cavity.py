# SPDX-License-Identifier: GPL-3.0-or-later
"""The cavity of a die in small cubes, from its surface, and how uniformly powder fills it.

A vertical ray through each column of cubes tells which of them are in the body of table and die. Parcels are shared
to cubes by points spread evenly in a sphere, so that no bin gains or loses a parcel because a centre lies just so.
"""
from dataclasses import dataclass

import numpy as np

CUBES = 81      # along the longest side of the box
LAYERS = 3      # of equal height; and thirds of length and width end between cubes, too
SPHERE = 8      # points across a parcel: 280 in it, within 5 % of its volume


@dataclass
class Cavity:
    """room[i, j, k]: whether powder can be in the cube; periodic: along y."""
    low: np.ndarray
    size: np.ndarray
    room: np.ndarray
    periodic: bool

    @classmethod
    def of(cls, d, triangles=()):
        """Of the box of a die, less the closed body of table and die if there is one."""
        low = np.array([0, d["dieYLow"], d["dieZLow"]])
        span = np.array([d["dieXHigh"], d["dieYHigh"], 0]) - low
        count = LAYERS*np.ceil(CUBES/LAYERS*span/span.max() - 1e-9).astype(int)
        cavity = cls(low, span/count, np.ones(count, bool), d["rig"] == "slice")
        if len(triangles):
            cavity.room = ~cavity.within(triangles)
        return cavity

    def centres(self, axis):
        return self.low[axis] + self.size[axis]*(np.arange(self.room.shape[axis]) + 0.5)

    def cube(self):
        """Volume of one [m3]."""
        return float(np.prod(self.size))

    def within(self, triangles):
        """Cubes inside a closed surface: as many faces up as down above those outside."""
        nx, ny, nz = self.room.shape
        # A little aside, so that no ray runs along an edge.
        x, y = (self.centres(axis) + shift*self.size[axis] for axis, shift in ((0, 6.18e-4), (1, 4.14e-4)))
        above = np.zeros((nx, ny, nz + 1), int)
        for a, b, c in triangles:
            twice = (b[0] - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(b[1] - a[1])
            i, j = (slice(*np.searchsorted(at, (min(a[n], b[n], c[n]), max(a[n], b[n], c[n]))))
                    for n, at in enumerate((x, y)))
            if abs(twice) < 1e-18 or i.start >= i.stop or j.start >= j.stop:
                continue
            u, v = np.meshgrid(x[i] - a[0], y[j] - a[1], indexing="ij")
            s = (u*(c[1] - a[1]) - v*(c[0] - a[0]))/twice
            t = (v*(b[0] - a[0]) - u*(b[1] - a[1]))/twice
            hit = (s >= 0) & (t >= 0) & (s + t <= 1)
            z = a[2] + s*(b[2] - a[2]) + t*(c[2] - a[2])
            k = np.clip(np.ceil((z - self.low[2])/self.size[2] - 0.5), 0, nz).astype(int)
            p, q = np.nonzero(hit)
            np.add.at(above, (p + i.start, q + j.start, k[p, q]), 1 if twice > 0 else -1)
        return np.cumsum(above[:, :, ::-1], axis=2)[:, :, nz - 1::-1] > 0

    def filled(self, points, diameters):
        """Volume of powder in each cube [m3], of parcels around points."""
        n = (np.arange(SPHERE) + 0.5)/SPHERE - 0.5
        ball = np.stack(np.meshgrid(n, n, n, indexing="ij"), axis=-1).reshape(-1, 3)
        ball = ball[np.sum(ball**2, axis=1) <= 0.25]
        high = self.low + self.size*self.room.shape
        points = np.asarray(points, float).reshape(-1, 3)
        d = np.broadcast_to(diameters, len(points))[:, None]
        near = np.flatnonzero(np.all((points > self.low - d/2) & (points < high + d/2), axis=1))
        powder = np.zeros(self.room.size)
        for some in np.array_split(near, 1 + len(near)//2000):
            spread = (points[some, None] + d[some, None]*ball).reshape(-1, 3)
            cube = np.floor((spread - self.low)/self.size).astype(int)
            below = cube[:, 2] < self.room.shape[2]
            cube = cube[below]
            share = np.repeat(np.pi/6*d[some, 0]**3/len(ball), len(ball))[below]
            if self.periodic:
                cube[:, 1] %= self.room.shape[1]
            cube = np.clip(cube, 0, np.array(self.room.shape) - 1)  # pressed into a wall
            powder += np.bincount(np.ravel_multi_index(cube.T, self.room.shape), share, powder.size)
        return powder.reshape(self.room.shape)

    def core(self, distance):
        """Cubes whose distance from the side walls is larger, in their own layer."""
        nx, ny, _ = self.room.shape
        reach = [int(distance/s) for s in self.size[:2]]
        around = np.pad(self.room, ((reach[0],)*2, (0, 0), (0, 0)))
        around = np.pad(around, ((0, 0), (reach[1],)*2, (0, 0)),
                        mode="wrap" if self.periodic else "constant")
        inside = self.room.copy()
        for i in range(-reach[0], reach[0] + 1):
            for j in range(-reach[1], reach[1] + 1):
                if np.hypot(i*self.size[0], j*self.size[1]) <= distance:
                    inside &= around[reach[0] + i:reach[0] + i + nx, reach[1] + j:reach[1] + j + ny]
        return inside
