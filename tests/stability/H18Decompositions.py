# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh and powder cut in every way, each by itself: the same fields as on one rank.

Grains fall through air in a closed box, at random, with some on the very faces, edges and corners at
which ranks meet. Without contacts nothing amplifies a last digit, so what is left of a difference
after ten steps is the order of sums. Codes that share a grain's volume only among the cells of its
own rank are wrong here by per cents.
"""
import itertools
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent/"verification"))

from harness.bench import main  # noqa: E402
from harness.case import Box, Case  # noqa: E402
from harness.laws import Air, Powder  # noqa: E402

CELL = 1e-3  # [m]
CELLS = (8, 8, 8)
EQUAL = 1e-10  # largest difference of a field, of its largest value
CUTS = {1: ["1 1 1"], 2: ["2 1 1", "1 2 1", "1 1 2"],
        4: ["4 1 1", "1 4 1", "1 1 4", "2 2 1", "2 1 2", "1 2 2"]}


class CutCase(Case):
    """A case whose mesh is cut in any two directions."""

    def __init__(self, name, cut, **options):
        super().__init__(name, **options)
        self.cut = cut

    def values(self, ranks):
        return dict(super().values(ranks), slices=self.cut)


def grains(box):
    chance = random.Random(11)
    inside = [tuple(chance.uniform(0, length) for length in box.size) for _ in range(1500)]
    # Quarters and the middle are where two or four ranks meet.
    planes = [0.25*box.size[0], 0.5*box.size[0], 0.75*box.size[0]]
    return inside + list(itertools.product(planes, repeat=3))


def falling(mesh, powder):
    box = Box(tuple(CELL*n for n in CELLS), CELLS, ("noSlip", "noSlip", "noSlip"))
    return CutCase(f"mesh ({mesh}), powder ({powder})", mesh, box=box,
                   powder=Powder(0.5e-3, 2600.0, Air()), positions=grains(box),
                   gravity=(0, 0, -9.81), processors=powder, smoothingWidth=1e-3, deltaT=2e-4,
                   subSteps=10, endTime=2e-3)


def difference(run, reference, name):
    cells = list(zip(run.field(name), reference.field(name)))
    size = max(norm(b) for _, b in cells)
    return max(norm(tuple(x - y for x, y in zip(many(a), many(b)))) for a, b in cells)/size


def pairs(cuts):
    """Each cut of the mesh with three of the powder, the same one among them."""
    count = len(cuts)
    return sorted({(mesh, cuts[(i + shift) % count]) for i, mesh in enumerate(cuts)
                   for shift in (0, 1, count//2)})


def many(value):
    return value if isinstance(value, tuple) else (value,)


def norm(value):
    return math.hypot(*many(value))


def verify(bench):
    ranks, bench.ranks = bench.ranks, 1
    reference = bench.run(falling("1 1 1", "1 1 1"), impulse=math.inf)
    bench.atMost(reference, "lowest void fraction, so that there is a bed", 0.8,
                 min(reference.field("voidFraction")))
    bench.ranks = ranks
    for mesh, powder in pairs(CUTS[ranks]):
        run = bench.run(falling(mesh, powder), impulse=math.inf)
        for name in ("voidFraction", "U", "p"):
            bench.equal(run, f"difference of {name} from one rank", 0,
                        difference(run, reference, name), EQUAL)


if __name__ == "__main__":
    main(verify)
