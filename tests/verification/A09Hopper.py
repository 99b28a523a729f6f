# SPDX-License-Identifier: GPL-3.0-or-later
"""Dry powder without air: how fast it runs out of a hopper, and how steep a heap of it is.

Hopper  foam_cases/hopper, 40 000 spheres of 1 mm above three orifices. Beverloo, Leniger and van de
        Velde, Chem. Eng. Sci. 15 (1961) 260:

            W = C rho_b sqrt(g) (D - k d)^2.5        k = 1.4, C = 0.55 to 0.65

        C is that of the best line of slope 2.5 through the three; those of each are shown. rho_b is
        that of the bed at rest without its lowest and highest layers. A hopper does not feel how full
        it is, as long as the bed is higher than 1.5 D: half the bed gives the same W, where a vessel of
        water would give 0.71 of it. The spheres are soft, so the overlap of the contacts in the bed at
        rest is judged as well: 99 of 100 are below 1 % of d.
Repose  a tube full of spheres with the contact of the die filling study is lifted from a plate, slowly
        (0.05 sqrt(g d); at 0.1 of it the heap has 29 degrees, at 0.3 it has 24). Its half-filled die
        has a slope of 14.5 to 14.8 degrees; a heap at rest must be far steeper, 30 to 40 degrees.
        The slope is that of the mean surface between 0.2 and 0.8 of the heap's height.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys
import time

from dem.run import frames
from harness.bench import main
from harness.case import execute
from harness.laws import GRAVITY

ROOT = pathlib.Path(__file__).resolve().parents[2]

ORIFICES = (8e-3, 12e-3, 16e-3)  # [m]
K_BEVERLOO = 1.4
EXPONENT, C = (2.5, 0.15), (0.60, 0.05)
STEADY = 0.05  # from then on [s]
LOW = 0.1  # difference between a low bed and a high one
OVERLAP = 1e-2
MASS = 1e-12
STEEPEST_IN_DIE = 14.77  # [degrees]
REPOSE = (30.0, 40.0)
TUBE, TUBE_HEIGHT, SPHERE, SPHERES = 30e-3, 136e-3, 4e-3, 2500


class Tree:
    """A copy of the case in a tree like the source's."""

    def __init__(self, bench):
        self.bench = bench
        self.case = bench.work/"tree/foam_cases/hopper"
        shutil.rmtree(bench.work/"tree", ignore_errors=True)
        shutil.copytree(ROOT/"foam_cases/hopper", self.case, ignore=shutil.ignore_patterns(
            "variants", "preparation", "triSurface", "polyMesh", "log.*", "pictures"))
        for shared in ("liggghts_scripts", "cmake", "foam_cases/common"):
            (bench.work/"tree"/shared).symlink_to(ROOT/shared)
        self.command(self.case/"prepare")

    def command(self, *words):
        path = f"{pathlib.Path(self.bench.solver).parent}:{os.environ['PATH']}"
        done = subprocess.run(words, cwd=self.case, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env={**os.environ, "PATH": path})
        if done.returncode:
            sys.exit(f"{words[0]} failed\n" + done.stdout[-3000:])

    def parameter(self, name):
        for line in (self.case/"system/caseParameters").read_text().splitlines():
            if line.startswith(name + " "):
                return float(line.split()[1].rstrip(";"))
        raise ValueError(name)


class Discharge:
    """A run with an orifice; what Bench prints of it."""

    def __init__(self, tree, orifice, **changes):
        self.orifice = orifice
        self.case = self
        changed = [f"{value} {key}" for key, value in changes.items()]
        self.name = ", ".join([f"D = {1e3*orifice:g} mm"] + changed)
        start = time.monotonic()
        variant = tree.bench.folder(self).name
        tree.command("./variant", variant, f"orifice={orifice}",
                     *[f"{key}={value}" for key, value in changes.items()])
        folder = tree.case/"variants"/variant
        tree.command(folder/"run", "-np", str(tree.bench.ranks))
        self.seconds = time.monotonic() - start
        text = (folder/"postProcessing/powderBalance/0/powderBalance.dat").read_text()
        self.rows = [list(map(float, line.split())) for line in text.splitlines()
                     if not line.startswith("#")]

    def rate(self):
        """Mass that leaves the bin [kg/s]."""
        return -slope([(row[0], row[1]) for row in self.rows if row[0] >= STEADY])

    def judge(self, bench, density, width):
        missing = max(abs(row[5]) for row in self.rows)/self.rows[0][4]
        bench.atMost(self, "mass missing, of all", MASS, missing)
        bench.atMost(self, "spheres lost", 0, self.rows[-1][8])
        height = self.rows[-1][1]/(density*width**2)
        bench.atLeast(self, "height of the bed at the end, of D", 1.5, height/self.orifice)


def slope(points):
    """Of a straight line through points, by least squares."""
    n = len(points)
    x, y = (sum(p[i] for p in points)/n for i in (0, 1))
    return sum((p[0] - x)*(p[1] - y) for p in points)/sum((p[0] - x)**2 for p in points)


def bulkDensity(spheres, width, low, high):
    """Of the layers between two heights; of a sphere that is cut, the part between them counts."""
    def below(top):
        mass = 0.0
        for _, _, z, r, m in spheres:
            h = min(max(top - z + r, 0.0), 2*r)
            mass += m*h*h*(3*r - h)/(4*r**3)
        return mass
    return (below(high) - below(low))/(width**2*(high - low))


def overlaps(spheres):
    """Of all pairs that touch, over the diameter, in rising order."""
    d = 2*spheres[0][3]
    bins = {}
    for sphere in spheres:
        bins.setdefault(tuple(int(x//d) for x in sphere[:3]), []).append(sphere[:3])
    found = []
    for (i, j, k), here in bins.items():
        around = [x for a in (i - 1, i, i + 1) for b in (j - 1, j, j + 1) for c in (k - 1, k, k + 1)
                  for x in bins.get((a, b, c), ())]
        found += [1 - gap/d for x in here for other in around if x < other
                  and (gap := math.dist(x, other)) < d]
    return sorted(found)


def hopper(bench):
    tree = Tree(bench)
    (_, spheres), = frames(tree.case/"preparation/bed.dump")
    width, d = tree.parameter("binWidth"), tree.parameter("grainDiameter")
    top = sorted(row[2] for row in spheres)[-len(spheres)//100]
    density = bulkDensity(spheres, width, 0.2*top, 0.7*top)

    runs = [Discharge(tree, orifice) for orifice in ORIFICES]
    constants = []
    for run in runs:
        run.judge(bench, density, width)
        ideal = density*math.sqrt(GRAVITY)*(run.orifice - K_BEVERLOO*d)**2.5
        constants.append(run.rate()/ideal)
        bench.report(run, "C of this orifice", C[0], constants[-1])
    bench.equal(runs[-1], "C of all", C[0], math.prod(constants)**(1/len(runs)), C[1])
    fit = slope([(math.log(run.orifice - K_BEVERLOO*d), math.log(run.rate())) for run in runs])
    bench.equal(runs[-1], "exponent of D - 1.4 d", EXPONENT[0], fit, EXPONENT[1])
    free = [1e-3*i for i in range(6, 16)]
    bench.curve("hopper, 1 mm glass", "D - 1.4 d [m]", "discharge [kg/s]",
                [(x, C[0]*density*math.sqrt(GRAVITY)*x**2.5) for x in free],
                [(run.orifice - K_BEVERLOO*d, run.rate()) for run in runs], log=True)
    low = Discharge(tree, ORIFICES[0], parcels=len(spheres)//2)
    low.judge(bench, density, width)
    bench.near(low, "discharge, as of the high bed [kg/s]", runs[0].rate(), low.rate(), LOW)
    found = overlaps(spheres)
    bench.atMost(runs[0], "overlap of 99 of 100 contacts, of d", OVERLAP,
                 found[99*len(found)//100])
    bench.report(runs[0], "bulk density over that of the spheres", 0.58,
                 density/tree.parameter("grainDensity"))


def tube(path):
    """An open cylinder, in small triangles."""
    sides, rings = 48, 12
    lines = ["solid tube"]

    def point(i, k):
        angle = 2*math.pi*i/sides
        return TUBE*math.cos(angle), TUBE*math.sin(angle), TUBE_HEIGHT*k/rings
    for i in range(sides):
        for k in range(rings):
            a, b, c, e = point(i, k), point(i + 1, k), point(i + 1, k + 1), point(i, k + 1)
            for corners in ((a, b, c), (a, c, e)):
                lines.append("facet normal 0 0 0\n outer loop")
                lines += ["  vertex {:.9g} {:.9g} {:.9g}".format(*corner) for corner in corners]
                lines.append(" endloop\nendfacet")
    path.write_text("\n".join(lines) + "\nendsolid tube\n")


class Heap:
    """A lifted cylinder."""

    def __init__(self, bench):
        self.case = self
        self.name = "heap of a lifted tube"
        folder = bench.folder(self)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        tube(folder/"tube.stl")
        values = dict(
            contacts=ROOT/"liggghts_scripts/contacts.in", tube="tube.stl", particleDensity=2500,
            parcelRadius=SPHERE/2, spheres=SPHERES, tubeRadius=TUBE, tubeHeight=TUBE_HEIGHT,
            half=120e-3, settleTime=0.3, liftTime=4.0, restTime=0.3, liftSpeed=0.01,
            youngsModulus=5e6, wallYoungsModulus=5e6, poissonsRatio=0.3, restitution=0.5,
            wallRestitution=0.5, friction=0.67, rollingFriction=0.218, rollingModel="epsd2")
        command = ["liggghts", "-in", str(ROOT/"tests/verification/dem/repose.in"), "-log", "none"]
        for key, value in values.items():
            command += ["-var", key, str(value)]
        if bench.ranks > 1:
            command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np",
                       str(bench.ranks)] + command
        start = time.monotonic()
        execute(folder, command, "log.liggghts", timeout=3000)
        self.seconds = time.monotonic() - start
        (_, self.spheres), = frames(folder/"record.txt")

    def profile(self):
        """(radius, height of the surface): the highest sphere of each square of 2 x 2 d, averaged
        over rings."""
        highest = {}
        for x, y, z, *_ in self.spheres:
            square = (math.floor(x/(2*SPHERE)), math.floor(y/(2*SPHERE)))
            highest[square] = max(highest.get(square, 0.0), z + SPHERE/2)
        rings = {}
        for (i, j), height in highest.items():
            radius = 2*SPHERE*math.hypot(i + 0.5, j + 0.5)
            rings.setdefault(int(radius/SPHERE), []).append((radius, height))
        return [tuple(sum(p[n] for p in ring)/len(ring) for n in (0, 1))
                for _, ring in sorted(rings.items())]

    def angle(self):
        profile = self.profile()
        height = profile[0][1] - SPHERE  # above the single layer around it
        flank = [(r, h) for r, h in profile if 0.2 <= (h - SPHERE)/height <= 0.8]
        return math.degrees(math.atan(-slope(flank)))

    def speed(self):
        """Root of the mean square [m/s]."""
        return math.sqrt(sum(v*v for row in self.spheres for v in row[3:6])/len(self.spheres))


def repose(bench):
    run = Heap(bench)
    angle = run.angle()
    bench.atLeast(run, "angle of repose [degrees]", REPOSE[0], angle)
    bench.atMost(run, "angle of repose [degrees]", REPOSE[1], angle)
    bench.atLeast(run, "steeper than in the study's die [degrees]", 10, angle - STEEPEST_IN_DIE)
    bench.atMost(run, "speed of the heap, at rest [m/s]", 1e-3, run.speed())


def verify(bench):
    repose(bench)
    hopper(bench)


if __name__ == "__main__":
    main(verify)
