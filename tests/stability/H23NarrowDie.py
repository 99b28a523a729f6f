# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels of 0.6 mm (60 um, k = 10) fill a die 6 mm long and 5 mm deep, without air: ten parcels in
length, eight in depth. Coarse parcels can bridge what the grains they stand for would not. A bridge
that lasts is told from slow filling by two measures, of the filling table and of the parcels at the
end:

lull    the longest time in which no further parcel's volume gets in, while the shoe is over the
        whole mouth, powder lies in it, and the die is not full (below 90 %). The mouth passes a
        parcel that falls its own diameter in sqrt(2 d/g) = 11 ms; what keeps all of them back for
        three times as long stands still. A permanent one lasts until the rear wall closes the
        mouth.

hole    the largest sphere that fits between the parcels at rest and the die's walls with one of
        them above it. Gaps of a packing are smaller than the parcels, below a bridge there is room
        for several. More than one parcel and a half is an arch.

The ratio refers to the die over which powder was poured at rest: that may be bridged just as well,
and no ratio would tell, so its holes are measured, too. Then the die is full when the rear wall
arrives. DF4 expects 95 % without air; runs scatter by a per cent, so that the number is shown and
90 % judged.

Both measures must find an arch where there is one. Powder poured at rest over a slot of two parcels
bridges it, in three packings of three; of two and a half, in two (openings below 3 to 5 diameters jam: To,
Lai & Pak, Phys. Rev. Lett. 86 (2001) 71): the hole. A filling table that stands still from half full
on: the lull.
"""
import math
import os
import re

from hardCase import GRAVITY, main

from A12DieFilling import Slice

K, GRAIN, DENSITY = 10, 60e-6, 7360.0  # [m], [kg/m3]
PARCEL = K*GRAIN
LENGTH, DEPTH, WIDTH = 6e-3, 5e-3, 2.4e-3  # of the die [m]
SLOT = 2*PARCEL
FULL, EXPECTED = 0.9, 0.95
LULL = 3*math.sqrt(2*PARCEL/GRAVITY)  # [s]
HOLE = 1.5  # of a parcel's diameter
STILL = 0.02  # [m/s]: falling for a tenth of a parcel's diameter makes it faster
SHOE, WALL, CLEAR = 12e-3, 1.5e-3, 1e-3  # inside, its wall, and from it to the die at the start [m]


def vectors(path):
    """Of a list of them, one a line."""
    return [tuple(map(float, row)) for row in
            re.findall(r"^\((\S+) (\S+) (\S+)\)", path.read_text(), re.M)]


class Rig(Slice):
    """With `atRest` powder is only poured: for the start, and over the die."""

    def __init__(self, bench, name, atRest=False, **changes):
        self.atRest = atRest
        super().__init__(bench, name, bench.ranks, air="off", particleDiameter=GRAIN, **changes)

    def command(self, words, folder):
        control = folder/"system/controlDict"
        control.write_text(control.read_text().replace("binary;", "ascii; "))
        if words[0].parent.name == "dieFilling" and words[0].name == "prepare":
            return  # the bed of the case as it stands is of no use here
        if self.atRest and words[0].name == "run":
            words = [words[0].parent/"prepare"]
        super().command(words, folder)

    def conserves(self):
        if not self.atRest:
            super().conserves()

    def numbers(self, name):
        return [[float(x) for x in row] for row in self.table(f"{name}/0/{name}")]

    def resting(self):
        """Centres of those that lie still at the last time that was written: a bridge does."""
        folders = [path.parent for path in self.folder.rglob("lagrangian/powder/positions")]
        last = max((folder.parents[1].name for folder in folders), key=float)
        return [centre for folder in folders if folder.parents[1].name == last
                for centre, velocity in zip(vectors(folder/"positions"), vectors(folder/"U"))
                if math.hypot(*velocity) < STILL]

    def poured(self):
        """Centres in the die that is filled at rest, and above it."""
        lines = (self.folder/"preparation/full.dump").read_text().splitlines()[9:]
        return [tuple(map(float, line.split()[1:4])) for line in lines]

    def filled(self):
        """Rows of time, filling ratio and the shoe's travel."""
        return [(row[0], row[1], row[4]) for row in self.numbers("fillingRatio")]

    def parcelRatio(self):
        """What one parcel adds to the filling ratio."""
        text = (self.folder/"preparation/fullMass").read_text()
        full = float(re.search(r"fullMass (\S+);", text)[1])
        return math.pi/6*PARCEL**3*DENSITY/full


def longestLull(rows, length, parcel):
    """Of rows (time, filling ratio, shoe's travel): its seconds, and whether it lasted to the end.
    `parcel`: what one adds to the ratio."""
    whole = [row for row in rows if length + WALL + CLEAR <= row[2] <= WALL + CLEAR + SHOE]
    longest, lasted, start = 0.0, False, whole[0]
    for row in whole:
        if row[1] >= FULL:
            break
        if row[1] > start[1] + parcel:
            start = row
        if row[0] - start[0] > longest:
            longest, lasted = row[0] - start[0], row is whole[-1]
    return longest, lasted


def largestHole(centres, length, step=0.15e-3):
    """Diameter of the largest sphere between parcels and walls that has a parcel above it."""
    counts = [round(side/step) for side in (length, WIDTH, DEPTH)]
    low, radius, reach = (0.0, -WIDTH/2, -DEPTH), PARCEL/2, 2*PARCEL
    room = {}
    for i in range(counts[0]):
        for k in range(counts[2]):
            x, z = (i + 0.5)*step, (k + 0.5)*step
            for j in range(counts[1]):
                # The walls; farther than the reach no parcel is looked for.
                room[i, j, k] = min(x, length - x, z, reach - radius)
    roofs = {}
    for centre in centres:
        cell = [math.floor((x - corner)/step) for x, corner in zip(centre, low)]
        span = math.ceil(reach/step)
        for i in range(max(0, cell[0] - span), min(counts[0], cell[0] + span + 1)):
            for j in range(cell[1] - span, cell[1] + span + 1):
                across = [low[0] + (i + 0.5)*step - centre[0], low[1] + (j + 0.5)*step - centre[1]]
                column = i, j % counts[1]  # periodic in y
                if math.hypot(*across) < radius:
                    roofs[column] = max(roofs.get(column, -DEPTH), centre[2])
                for k in range(max(0, cell[2] - span), min(counts[2], cell[2] + span + 1)):
                    gap = math.hypot(*across, low[2] + (k + 0.5)*step - centre[2]) - radius
                    if gap < room[(*column, k)]:
                        room[(*column, k)] = gap
    return 2*max((gap for (i, j, k), gap in room.items()
                  if roofs.get((i, j), -DEPTH) > low[2] + (k + 0.5)*step), default=0.0)


def halted(rows, ratio):
    """The table of a die into which nothing more falls."""
    return [(time, min(value, ratio), travel) for time, value, travel in rows]


def verify(bench):
    os.environ["OMPI_MCA_mpi_yield_when_idle"] = "1"  # where ranks share cores
    rig = Rig(bench, "narrow", dieLength=LENGTH)
    rows, parcel = rig.filled(), rig.parcelRatio()

    def row(name, quantity, bound, value, beyond, seconds=0.0):
        bench.row(name, quantity, bound, value, beyond, 0, seconds)

    def hole(name, centres, length):
        diameter = largestHole(centres, length)/PARCEL
        row(name, "largest hole below a parcel, of a parcel", HOLE, diameter,
            max(0.0, diameter - HOLE))

    lull, lasted = longestLull(rows, LENGTH, parcel)
    row("narrow", "longest lull [s]", LULL, lull, max(0.0, lull - LULL), rig.seconds)
    row("narrow", "a lull until the mouth closed", 0, int(lasted), float(lasted))
    hole("narrow", rig.resting(), LENGTH)
    hole("narrow, filled at rest", rig.poured(), LENGTH)
    arrived = next(ratio for _, ratio, travel in rows if travel >= WALL + CLEAR + SHOE)
    row("narrow", "filling ratio when the rear wall arrives", FULL, arrived,
        min(0.0, arrived - FULL))
    bench.row("narrow", "the same, of that expected", EXPECTED, arrived, arrived - EXPECTED,
              math.inf, 0)

    lull, lasted = longestLull(halted(rows, 0.5), LENGTH, parcel)
    row("halted", "longest lull that is found [s]", LULL, lull, min(0.0, lull - LULL))
    row("halted", "a lull until the mouth closed is found", 1, int(lasted), lasted - 1.0)
    slot = Rig(bench, "slot", atRest=True, dieLength=SLOT, powderHeight=3e-3)
    diameter = largestHole(slot.poured(), SLOT)/PARCEL
    row("slot, filled at rest", "largest hole that is found, of a parcel", HOLE, diameter,
        min(0.0, diameter - HOLE), slot.seconds)


if __name__ == "__main__":
    main(verify)
