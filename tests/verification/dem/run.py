# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a few spheres by LIGGGHTS under a script of this folder, and reads them back."""
import math
import pathlib
import shutil
import time

from harness.case import AXES, execute, spaced

HERE = pathlib.Path(__file__).resolve().parent
G = 9.80665  # of the MFiX verification manual [m/s2]


class Run:
    """Spheres (type, diameter, density, position, velocity) in a box (lowest and highest corner);
    what Bench prints of them. `clock` is the step [s], the steps and the steps between records."""

    def __init__(self, bench, name, script, spheres, box, clock, types, **settings):
        self.name = name
        self.case = self
        folder = bench.folder(self)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder/"spheres.data").write_text(data(spheres, box, types))
        step, steps, every = clock
        values = dict(dem=HERE, boundary="f f f", skin=0.2*min(s[1] for s in spheres),
                      demStep=step, steps=steps, every=every)
        values.update(settings)
        command = ["liggghts", "-in", str(HERE/script), "-log", "none"]
        for key, value in values.items():
            command += ["-var", key, str(value)]
        if bench.ranks > 1:
            command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np",
                       str(bench.ranks)] + command
        start = time.monotonic()
        execute(folder, command, "log.liggghts")
        self.seconds = time.monotonic() - start
        self.records = [(n*step, rows) for n, rows in frames(folder/"record.txt")]
        assert all(len(rows) == len(spheres) for _, rows in self.records), f"lost: {name}"

    def track(self, i):
        """[(time, (x, y, z, vx, vy, vz, omegay))] of sphere i."""
        return [(t, rows[i]) for t, rows in self.records]

    def position(self, i, moment, axis):
        """Of a sphere at a time between two records [m]."""
        track = self.track(i)
        for (t0, a), (t1, b) in zip(track, track[1:]):
            if t0 <= moment <= t1:
                return a[axis] + (b[axis] - a[axis])*(moment - t0)/(t1 - t0)
        raise ValueError(f"{self.name} does not last until {moment} s")


def data(spheres, box, types):
    lines = ["spheres", "", f"{len(spheres)} atoms", f"{types} atom types", ""]
    lines += [f"{low:.15g} {high:.15g} {a}lo {a}hi" for a, low, high in zip(AXES, *box)]
    lines += ["", "Atoms", ""]
    lines += [f"{i} {kind} {diameter:.15g} {density:.15g} {spaced(place)}"
              for i, (kind, diameter, density, place, _) in enumerate(spheres, 1)]
    lines += ["", "Velocities", ""]
    lines += [f"{i} {spaced(s[4])} 0 0 0" for i, s in enumerate(spheres, 1)]
    return "\n".join(lines) + "\n"


def frames(path):
    """Steps and the spheres' rows, of a dump."""
    lines = path.read_text().splitlines()
    at = 0
    while at < len(lines):
        count = int(lines[at + 3])
        rows = [tuple(map(float, line.split()[1:])) for line in lines[at + 9:at + 9 + count]]
        yield int(lines[at + 1]), rows
        at += 9 + count


def mass(diameter, density):
    return math.pi/6*diameter**3*density


def dampingRatio(e):
    return -math.log(e)/math.hypot(math.pi, math.log(e))


def matrix(types, value):
    """A property of all pairs of types."""
    kinds = range(1, types + 1)
    return f"{types} " + spaced([value(i, j) for i in kinds for j in kinds])


def perSphere(values):
    """As a property of pairs of types, if sphere i has type i and only touches planes."""
    return lambda i, j: values[min(i, j, len(values)) - 1]


def linear(bench, name, spheres, box, clock, stiffness, restitution, friction=lambda i, j: 0,
           rollingFriction=0, ceiling=0):
    """Sphere i has type i, the planes have the last one; stiffness, restitution and friction are
    functions of two types. The tangential spring has 2/7 of the normal stiffness and no dashpot,
    whose force Coulomb's limit would not bound."""
    types = len(spheres) + 1
    masses = [mass(s[1], s[2]) for s in spheres] + [math.inf]

    def damping(i, j):
        inverse = 1/masses[i - 1] + 1/masses[j - 1]
        return 2*dampingRatio(restitution(i, j))*math.sqrt(stiffness(i, j)*inverse)

    return Run(bench, name, "linear.in", spheres, box, clock, types, plane=types,
               kn=matrix(types, stiffness), kt=matrix(types, lambda i, j: 2/7*stiffness(i, j)),
               gamman=matrix(types, damping), gammat=matrix(types, lambda i, j: 0),
               friction=matrix(types, friction),
               rollingFriction=matrix(types, lambda i, j: rollingFriction),
               rollingModel="epsd2" if rollingFriction else "off", ceiling=ceiling, gravity=G)
