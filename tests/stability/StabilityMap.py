# SPDX-License-Identifier: GPL-3.0-or-later
"""A coarse selection of the points of the stability map (map/README.md): the corners of its slices and
some of their middle. Each must be what it is on the map.

What is stable ends by itself, loses nothing, is nowhere faster than three times what physics allows
(free fall, or the speed at which drag carries the plug; for the air the flow that the powder
displaces), and its swing from step to step does not grow. What is refused says so by its rule. With the
refusal lifted the plug must be seen to blow up: the refusal is needed. So must one that is stable, if
the carried momentum counts as given (numerics of the coupling): the verdict sees what swings.
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE/"map")]

from hardCase import main  # noqa: E402
from slices import CHOSEN, slices  # noqa: E402
from verdict import MARGIN, judge  # noqa: E402

STABLE = (("density", CHOSEN, 10), ("density", 0.1, 10000), ("density", 0.9, 1000),
          ("density", 0.3, 1.1), ("density", 0.9, 2.5),
          ("density", CHOSEN, 1.1), ("densityFree", CHOSEN, 1.5),
          ("densityFree", 0.3, 100), ("void", 0.9, 0.26), ("void", CHOSEN, 0.6), ("void", 0.3, 0.999),
          ("k", 0.3, 1), ("k", CHOSEN, 20), ("size", 0.1, 0.4), ("size", 1, 0.4), ("size", 1, 0.26),
          ("sizeSmoothed", 1, 0.26), ("sizeSmoothed", 4, 0.4), ("box", CHOSEN, 1),
          ("shoe", 0.5, 0.01), ("shoe", CHOSEN, 0.15), ("shoe", 2, 5), ("shoeFilled", 0.6, 5))
STEP, WALL = "The fixed coupling step is unstable", "A solid must be at least two cells thick"
LARGE = "A parcel larger than two cells must be smoothed"
REFUSED = (("density", 1.5, 10000, STEP), ("density", 30, 10, STEP), ("void", 3, 0.26, STEP),
           ("void", 10, 0.999, STEP), ("k", 30, 20, STEP), ("size", 4, 0.4, LARGE),
           ("shoeFilled", 1.2, 0.15, WALL))
BEYOND = (("density", 3, 1000), ("void", 3, 0.26), ("k", 10, 20))
ACCURATE = 0.05


class Point:
    """A point of a slice that was run, and what Bench prints of it."""

    def __init__(self, bench, parts, where, solver=None, **options):
        name, x, y = where
        self.name = f"{name} {x} {y}{' lifted' if options else ''}{' naive' if solver else ''}"
        self.case = parts[name].make(self.name, x, y, **options)
        self.found = judge(self.case, bench.folder(self.case), bench.ranks,
                           solver or bench.solver)
        self.seconds = self.found["seconds"]

    def requires(self, bench, word):
        if self.found["word"] != word:
            print(f"    {self.name} {self.found['word']}: {self.found['reason']}")
        bench.equal(self, f"{word}: 1", 1, int(self.found["word"] == word), 0)


def verify(bench):
    parts = {part.name: part for part in slices()}
    for where in STABLE:
        point = Point(bench, parts, where)
        point.requires(bench, "stable")
        for what in ("powder", "air"):
            if what in point.found:
                bench.atMost(point, f"fastest {what}, of what physics allows", MARGIN,
                             point.found[what])
        if "end" in point.found:
            bench.near(point, "end speed, of that of the formula", 1, point.found["end"], ACCURATE)
    for *where, rule in REFUSED:
        point = Point(bench, parts, where)
        point.requires(bench, "refused")
        bench.equal(point, "names the rule: 1", 1, int(rule in point.found["reason"]), 0)
    for where in BEYOND:
        Point(bench, parts, where, lifted=True).requires(bench, "blew up")
    naive = str(pathlib.Path(bench.naiveFolder).resolve()/"carryOfCarry")
    Point(bench, parts, ("density", 0.9, 1000), solver=naive).requires(bench, "blew up")


if __name__ == "__main__":
    main(verify)
