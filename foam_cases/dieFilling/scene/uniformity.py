# SPDX-License-Identifier: GPL-3.0-or-later
"""How uniformly the cavity of a run is filled at its end, in layers and parts of the plan."""
from dataclasses import dataclass

import numpy as np

import cloud
import dies
import parameters
import stl
from cavity import LAYERS, Cavity


@dataclass
class Fill:
    """Of each bin, [layer, sector], the bottom first: volume of room and of powder [m3]."""
    cavity: Cavity
    sector: np.ndarray      # of each column of cubes
    powder: np.ndarray      # of each cube [m3]
    parcel: float           # diameter [m]

    def binned(self, values):
        nx, ny, nz = self.cavity.room.shape
        layer = np.arange(nz)*LAYERS//nz
        count = self.sector.max() + 1
        number = layer*count + self.sector[:, :, None]
        return np.bincount(number.ravel(), np.ravel(values), LAYERS*count).reshape(LAYERS, count)

    def density(self):
        """Solid fraction of each bin; none where it has no room for a parcel. And the room of each [m3]."""
        room = self.binned(self.cavity.room)*self.cavity.cube()
        enough = room > np.pi/6*self.parcel**3
        return np.where(enough, self.binned(self.powder)/np.where(enough, room, 1), np.nan), room

    def numbers(self):
        """For measure; nothing if there is no powder."""
        density, room = self.density()
        there = np.isfinite(density)
        if not np.nansum(density) > 0:
            return {}
        rho, weight = density[there], room[there]
        mean = np.average(rho, weights=weight)
        worst = np.unravel_index(np.nanargmin(density), density.shape)
        return {"uniformity": np.sqrt(np.average((rho - mean)**2, weights=weight))/mean,
                "worstCorner": density[worst]/mean, **self.place(*worst), "wallGap": self.wallGap()}

    def place(self, layer, sector):
        """Middle of a bin's room [m]."""
        room = self.cavity.room & (self.sector == sector)[:, :, None]
        nz = room.shape[2]
        room[:, :, np.arange(nz)*LAYERS//nz != layer] = False
        share = [room.sum(axis=tuple({0, 1, 2} - {axis}))/room.sum() for axis in range(3)]
        return {f"worst{name}": float(share[axis] @ self.cavity.centres(axis)) for axis, name in enumerate("XYZ")}

    def wallGap(self):
        """Solid fraction within a parcel's diameter of the side walls, over that of the core at the same heights: a
        narrow part of the die has more walls, and may be fuller as it lies lower."""
        core = self.cavity.core(self.parcel)
        level = lambda values: values.sum(axis=(0, 1))
        room, beside = level(core), level(self.cavity.room & ~core)
        both = (room > 0) & (beside > 0)
        expected = np.sum(level(np.where(core, self.powder, 0))[both]*beside[both]/room[both])
        return float(level(np.where(core, 0, self.powder))[both].sum()/expected) if expected > 0 else None


def of(case):
    """Fill at the last time of a run; raises cloud.NoPowder."""
    points = cloud.parcels(case)
    numbers = parameters.read(case/"system/caseParameters", case/"system/caseDerived")
    return between(numbers, points, triangles(case, numbers), cloud.diameters(case))


def triangles(case, numbers):
    """Of the body of table and die, if it is not the usual box."""
    usual = numbers["airMesh"] == "blocks"
    return () if usual else stl.read(case/"constant/triSurface/dieSolid.stl")


def between(numbers, points, body, diameters=None):
    """Of parcels around points; all of one diameter if none are given."""
    cavity = Cavity.of(numbers, body)
    x, y = np.meshgrid(cavity.centres(0), cavity.centres(1), indexing="ij")
    parcel = numbers["parcelDiameter"]
    powder = cavity.filled(points, parcel if diameters is None else diameters)
    return Fill(cavity, dies.sectors(numbers, numbers["rig"], x, y), powder, parcel)
