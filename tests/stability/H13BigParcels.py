# SPDX-License-Identifier: GPL-3.0-or-later
"""A bed of parcels four times as large as the cells. Each has the volume of 38 cells, deposited in eight:
they would be full and the others empty, and the air would find channels that no powder has.

Smoothing over two parcel diameters has to make a bed of it again: nowhere below a void fraction of 0.3,
with all the powder, and with the same flow through and past it as if the parcels were as large as a cell.
The bed fills two thirds of a channel's width, so that air chooses its way. Without smoothing the solver
refuses (the void fraction then fell below 0.3, and the air was off by more than the 5 % allowed).
"""
import math

from hardCase import Box, Case, Powder, main, volumeError

VOID = 0.4
SPEED = 0.05  # superficial [m/s]
K = 10  # of parcels as large as a cell
DIAMETER = K*Powder().diameter
EDGE = (math.pi/6/(1 - VOID))**(1/3)*DIAMETER  # of a cell: 0.956 diameters
CELLS = (24, 4, 32)
BED = ((0, 16), (0, 4), (8, 24))  # in cells
WIDTH = 8*DIAMETER  # of smoothing: two diameters of the large parcels
ALIKE = 0.05


def channel(name, ratio, width=WIDTH):
    """ratio: parcel size over cell size."""
    box = Box(tuple(n*EDGE for n in CELLS), CELLS, ("slip", "periodic", ("inlet", "outlet")))
    sites = [[first + ratio*(i + 0.5) for i in range((last - first)//ratio)] for first, last in BED]
    positions = [(x*EDGE, y*EDGE, z*EDGE) for z in sites[2] for y in sites[1] for x in sites[0]]
    return Case(name, box, Powder(), k=K*ratio, positions=positions, motion="frozen",
                U=(0, 0, SPEED), deltaT=2e-3, subSteps=200, endTime=0.1, smoothingWidth=width,
                timeStep="stabilityLimit 100;")


def difference(run, other):
    """Largest of the air's velocities, of the fastest."""
    ours, theirs = run.field("U"), other.field("U")
    return max(math.dist(a, b) for a, b in zip(ours, theirs))/max(math.hypot(*u) for u in theirs)


def verify(bench):
    small = bench.run(channel("d = dx", 1), impulse=math.inf)
    large = bench.run(channel("d = 4 dx", 4), impulse=math.inf)
    for run in (small, large):
        bench.atLeast(run, "lowest void fraction", 0.3, min(run.field("voidFraction")))
        bench.atMost(run, "powder on the mesh less of all", 1e-12, abs(volumeError(run)))
    bench.atMost(large, "air, off that among small parcels", ALIKE, difference(large, small))
    drops = [p[0] - p[-1] for p in (small.pressureLayers(), large.pressureLayers())]
    bench.near(large, "pressure drop, of small parcels [Pa]", drops[0], drops[1], ALIKE)

    case = channel("d = 4 dx, not smoothed", 4, width=0)
    bench.refused(case, "A parcel larger than two cells must be smoothed", "smoothingWidth")


if __name__ == "__main__":
    main(verify)
