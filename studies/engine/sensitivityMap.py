# SPDX-License-Identifier: GPL-3.0-or-later
"""A measure over two parameters that are varied together: the grid, and where it meets a target, in words."""
from accuracyReport import Shown, heading, table
from badInput import BadInput
from sensitivityRank import Point, crossings, inOrder
from sensitivityReport import withError


class Grid:
    """All combinations of two parameters, their values in order."""

    def __init__(self, choices, keys):
        self.choices, self.keys = choices, keys
        self.variants = {tuple(variant.parameters[key] for key in keys): variant for variant in choices.variants}
        x, y = ({pair[i] for pair in self.variants} for i in (0, 1))
        self.x, self.y = ([point.x for point in inOrder([Point(value, 0, None) for value in values])]
                          for values in (x, y))

    def points(self, measure):
        """Rows along the first parameter, one for each value of the second; nothing may be missing."""
        missing = [(x, y) for y in self.y for x in self.x if (x, y) not in self.variants
                   or self.variants[x, y].values[measure] is None]
        if missing:
            raise BadInput(f"A map of {measure} needs all {len(self.x)*len(self.y)} combinations of "
                           f"{' and '.join(self.keys)}, and {self.choices.table.name} has no value for "
                           + "; ".join(self.named(*pair) for pair in missing[:4])
                           + (f" and {len(missing) - 4} more" if len(missing) > 4 else "")
                           + ": run those (studies/study, --retry).")
        return [[self.point(x, x, y, measure) for x in self.x] for y in self.y]

    def point(self, at, x, y, measure):
        variant = self.variants[x, y]
        return Point(at, variant.values[measure], variant.errors[measure])

    def named(self, *pair):
        return ", ".join(f"{key} {self.choices.table.written(key, value)}" for key, value in zip(self.keys, pair))


def pair(choices):
    """The two parameters that vary together, or None: then each is varied alone."""
    varied = [key for key in choices.reference.parameters
              if len({variant.parameters[key] for variant in choices.variants}) > 1]
    together = any(len(variant.changes) > 1 for variant in choices.variants)
    return tuple(varied) if together and len(varied) == 2 else None


def markdown(grid, measures, targets):
    parts = [f"# {grid.keys[0]} and {grid.keys[1]} together"]
    for measure in measures:
        shown, lines, written = Shown(grid.choices, measure), [], grid.choices.table.written
        points = grid.points(measure)
        for y, row in zip(grid.y, points):
            lines.append([written(grid.keys[1], y)] + [shown.pair(point.y, point.error) for point in row])
        head = [f"{grid.keys[1]} \\ {grid.keys[0]}"] + [written(grid.keys[0], x) for x in grid.x]
        parts += [f"## {heading(grid.choices, measure)}" + (f" [{shown.unit.strip()}]" if shown.unit else ""),
                  table(head, lines)]
        if measure in targets:
            parts.append(meets(grid, measure, points, targets[measure], shown))
    return "\n\n".join(parts) + "\n"


def meets(grid, measure, points, target, shown):
    """Along the first parameter at each value of the second, and the other way round."""
    goal, lines = f"{shown.scale*target:.4g}{shown.unit}", []
    along = [(0, grid.keys[1], y, row) for y, row in zip(grid.y, points)]
    along += [(1, grid.keys[0], x, [grid.point(y, x, y, measure) for y in grid.y]) for x in grid.x]
    for which, fixed, value, line in along:
        key = grid.keys[which]
        for crossing in crossings(line, target):
            lines.append([fixed + " " + grid.choices.table.written(fixed, value), key,
                          withError(grid.choices.table, key, crossing.at),
                          "" if crossing.resolved else "neighbours do not differ by more than scatter"])
        for point in line:
            if which == 0 and point.meets(target):
                lines.append([fixed + " " + grid.choices.table.written(fixed, value), key,
                              grid.choices.table.written(key, point.x), "within two errors"])
    if not lines:
        return f"{goal} is met nowhere in this grid."
    return f"{goal} is met, by straight lines between neighbours:\n\n" + table(
        ["at", "parameter", "value", ""], lines)
