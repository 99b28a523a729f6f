# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the shoe is at which time: by shoeSpeed and rampTime, or by a table.

    time, position          or speed: [s], and [m] along x from where it stands, or [m/s]
    0,    0                 positions: constant speed from row to row
    0.1,  0.015             speeds: changing evenly from row to row
    0.15, 0.015
    0.2,  0.03

Lines that begin with # are left out. The run ends with the last row.
"""
import numpy as np

import csvLines
from wrong import refuse, word

MOST = 25  # rows: a line of LIGGGHTS holds no more, and it evaluates all of them in every step
KINDS = ("position", "speed")


class Ramped:
    """From rest to full speed along half a cosine, then on."""

    def __init__(self, p):
        self.speed, self.ramp = p["shoeSpeed"], p["rampTime"]

    def at(self, t):
        """Travel [m]"""
        s = min(t, self.ramp)
        risen = 0.5*(s - self.ramp/np.pi*np.sin(np.pi*s/self.ramp)) if self.ramp > 0 else 0
        return self.speed*(risen + max(0, t - self.ramp))

    def when(self, travel):
        """Time [s] at which it has gone so far, after the ramp."""
        return travel/self.speed + 0.5*self.ramp


class Tabled:
    """By rows of time and position or speed."""

    def __init__(self, kind, rows):
        self.times, values = np.array(rows).T
        steps = np.diff(self.times)
        speeds = 0.5*(values[1:] + values[:-1]) if kind == "speed" else np.diff(values)/steps
        self.starts = values[:-1] if kind == "speed" else speeds
        self.rates = np.diff(values)/steps if kind == "speed" else np.zeros(len(steps))
        self.positions = np.concatenate([[0], np.cumsum(speeds*steps)])
        self.end = float(self.times[-1])

    def at(self, t):
        i = int(np.clip(np.searchsorted(self.times, t, "right") - 1, 0, len(self.starts) - 1))
        s = min(t, self.end) - self.times[i]
        return float(self.positions[i] + s*(self.starts[i] + 0.5*s*self.rates[i]))

    def when(self, travel):
        """First time at which it has gone so far; none if it never has."""
        fine = np.linspace(0, self.end, 10001)
        gone = np.array([self.at(t) for t in fine])
        reached = np.flatnonzero(gone >= travel)
        return float(fine[reached[0]]) if len(reached) else None

    def farthest(self):
        """Lowest and highest position [m]."""
        gone = [self.at(t) for t in np.linspace(0, self.end, 10001)]
        return min(gone), max(gone)

    def formula(self):
        """Of the velocity, as LIGGGHTS evaluates it."""
        return "+".join(f"(time>={t0:.7g})*(time<{t1:.7g})*({v:.7g}+{a:.7g}*(time-{t0:.7g}))"
                        for t0, t1, v, a in zip(self.times, self.times[1:], self.starts, self.rates))


def read(case, p):
    """Of the parameters p."""
    name = p.get("shoePath", "none")
    if name == "none":
        return Ramped(p)
    return Tabled(*table(case/name, name))


def table(path, name):
    if not path.is_file():
        refuse("The table of the shoe's path is not there.", f"shoePath {name}   system/caseParameters", f"a file {path}",
               "Correct shoePath, or set it to none.")
    lines = csvLines.read(path)
    head = lines[0][1] if lines else []
    if len(head) != 2 or head[0] != "time":
        refuse("The first line of a table of the shoe's path names its columns.", f"{','.join(head)}   {name}",
               "time, and " + " or ".join(KINDS), "Add that line.")
    kind = word("The second column", head[1], KINDS, name)
    rows = []
    for i, cells in lines[1:]:
        try:
            time, value = map(float, cells)
            good = np.isfinite(time) and np.isfinite(value)
        except ValueError:
            good = False
        if not good:
            refuse("A row of the shoe's path is two numbers.", f"{','.join(cells)}   line {i} of {name}", "time, " + kind,
                   "Correct it.")
        if rows and time <= rows[-1][0]:
            refuse("Times of the shoe's path must ascend.", f"{time:g} s after {rows[-1][0]:g} s   line {i} of {name}",
                   "a later one", "Sort the rows.")
        rows.append((time, value))
    if not 2 <= len(rows) <= MOST:
        refuse("A table of the shoe's path has some rows.", f"{len(rows)}   {name}", f"2 to {MOST}",
               "Add rows, or take out those that lie on a line with their neighbours.")
    if rows[0][0] != 0 or (kind == "position" and rows[0][1] != 0):
        refuse("The shoe's path begins where it stands.", f"{kind} {rows[0][1]:g} at {rows[0][0]:g} s   {name}",
               "time 0" + (", position 0" if kind == "position" else ""), "Count from there.")
    return kind, rows
