# SPDX-License-Identifier: GPL-3.0-or-later
"""A bed of 10 000 settled spheres in a cylinder, and a fluid that rises through it ever faster: the case
foam_cases/packedBed as a user runs it (set-up: ErgunTestMPI of CFDEMcoupling-PUBLIC).

Below the onset the pressure drop must be that of Ergun's formula, and of the drag law that is used,

    dp/dz = 150 mu U alpha_p^2/(alpha^3 d^2) + 1.75 rho U^2 alpha_p/(alpha^3 d)

summed over the layers of the mesh with their own void fraction (of the whole bed it is not known better
than to the 5 % that 1 % of void fraction makes). U is the flux relative to the spheres, U_inlet less
their mean velocity in the layer: the soft bed rises by some micrometres as its load is taken off, ever
more slowly, and 0.1 mm/s is 1 % of U.

Above the onset the fluid carries the spheres: the pressure drop is their net weight over the area,
170.85 Pa, whatever the speed, less what floor and wall hold (LIGGGHTS' own forces), and what speeds the spheres
up. A bed that begins to rise rubs on the wall, which adds some percent; a second run, whose wall has no
friction, shows the plateau itself.
"""
import argparse
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from harness.bench import Bench
from harness.laws import GRAVITY, Air, Powder, root

ROOT = pathlib.Path(__file__).resolve().parents[2]
RADIUS, HEIGHT, LAYERS = 13.8e-3, 55.3e-3, 24  # [m]
AREA = math.pi*RADIUS**2
COUNT = 10000
powder = Powder(1e-3, 2000.0, Air(10.0, 1.5e-3))
HOLD = 0.01  # of each speed [s]
SPEEDS = [0.002*i for i in range(1, 11)]  # [m/s]
WEIGHT = COUNT*math.pi/6*powder.diameter**3*(powder.density - powder.air.density)*GRAVITY/AREA
assert abs(WEIGHT/170.85 - 1) < 1e-4

FORMULA = 1e-2
PLATEAU = 1e-2
BALANCE = 2e-3
FLOW = 1e-6
MASS = 1e-12  # missing, of all


def ergun(alpha, U):
    air, d, solids = powder.air, powder.diameter, 1 - alpha
    return (150*air.viscosity*U*solids**2/(alpha**3*d**2)
            + 1.75*air.density*U**2*solids/(alpha**3*d))


class PackedBed:
    """A copy of the case, run from its parameters to its picture."""

    def __init__(self, bench, name, speeds, **changes):
        self.bench, self.name, self.speeds = bench, name, speeds
        tree = bench.work/name
        self.folder = tree/"foam_cases/packedBed"
        shutil.copytree(ROOT/"foam_cases/packedBed", self.folder, ignore=shutil.ignore_patterns(
            "processor*", "postProcessing", "preparation", "log.*", "pictures", "polyMesh", "0.*",
            "variants", "results"))
        for shared in ("liggghts_scripts", "cmake", "foam_cases/common"):
            (tree/shared).symlink_to(ROOT/shared)
        self.change(firstSpeed=speeds[0], lastSpeed=speeds[-1], speeds=len(speeds), holdTime=HOLD,
                    **changes)
        path = f"{pathlib.Path(bench.solver).parent}:{os.environ['PATH']}"
        start = time.monotonic()
        done = subprocess.run([str(self.folder/"Allrun"), "-np", str(bench.ranks)], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "PATH": path})
        if done.returncode:
            sys.exit("Allrun failed\n" + done.stdout[-3000:])
        self.seconds = time.monotonic() - start
        last = self.times()[-1]
        self.volume = self.field(last, "V")
        self.layer = [int(z*LAYERS/HEIGHT) for z in self.field(last, "Cz")]

    def change(self, **parameters):
        path = self.folder/"system/caseParameters"
        text = path.read_text()
        for key, value in parameters.items():
            text, found = re.subn(rf"^({key} +)[^;]*;", rf"\g<1>{value:.9g};", text, flags=re.M)
            assert found == 1, key
        path.write_text(text)

    def row(self, quantity, expected, measured, error, tolerance):
        self.bench.row(self.name, quantity, expected, measured, error, tolerance, self.seconds)

    def times(self):
        return sorted((p.name for p in self.folder.iterdir()
                       if re.fullmatch(r"0\.\d+", p.name)), key=float)

    def field(self, when, name):
        text = (self.folder/when/name).read_text()
        return [float(x) for x in
                re.search(r"List<scalar>\s+\d+\s*\(([^()]*)\)", text).group(1).split()]

    def table(self, name):
        """Rows of numbers; a vector is three of them."""
        path, = (self.folder/"postProcessing"/name/"0").glob("*.dat")
        return [[float(x) for x in line.replace("(", " ").replace(")", " ").split()]
                for line in path.read_text().splitlines() if not line.startswith("#")]

    def drops(self):
        """Time, pressure drop from the floor to the outlet [Pa] less the weight of the fluid."""
        return [(t, -powder.air.density*(integral/AREA + GRAVITY*HEIGHT))
                for t, _, _, integral in self.table("pressureDrop")]

    def walls(self):
        """Time, upward force of the floor, of the wall on the spheres [N]."""
        return [[float(x) for x in line.split()] for line in
                (self.folder/"postProcessing/walls.dat").read_text().splitlines() if line[0] != "#"]

    def balance(self, start, stop):
        """Mean drop over a span [Pa], and what it carries: net weight less what floor and wall hold, and
        what speeds the spheres up."""
        rows = self.drops()
        chosen = [i for i, (t, _) in enumerate(rows) if start < t <= stop + 1e-9]
        first, last = chosen[0] - 1, chosen[-1]
        span = rows[last][0] - rows[first][0]
        drop = sum(rows[i][1]*(rows[i][0] - rows[i - 1][0]) for i in chosen)/span
        momenta = self.table("momentumBudget")
        gain = (momenta[last][6] - momenta[first][6])/span
        forces = [floor + side for t, floor, side in self.walls() if start < t <= stop + 1e-9]
        return drop, WEIGHT + (gain - sum(forces)/len(forces))/AREA

    def profile(self, when):
        """Void fraction of each layer."""
        voids, whole = [0.0]*LAYERS, [0.0]*LAYERS
        for layer, alpha, volume in zip(self.layer, self.field(when, "voidFraction"), self.volume):
            voids[layer] += alpha*volume
            whole[layer] += volume
        return [a/b for a, b in zip(voids, whole)]

    def vectors(self, when, name):
        text = (self.folder/when/"lagrangian/powder"/name).read_text()
        return [tuple(map(float, row)) for row in
                re.findall(r"^\((\S+) (\S+) ([^\s)]+)\)", text, re.M)]

    def rise(self, when):
        """Mean velocity of the spheres in each layer; each belongs to the two layers next to it."""
        count, sums = [1e-9]*LAYERS, [0.0]*LAYERS
        for x, v in zip(self.vectors(when, "positions"), self.vectors(when, "U")):
            at = min(max(x[2]*LAYERS/HEIGHT - 0.5, 0), LAYERS - 1.001)
            for layer, share in ((int(at), 1 - at % 1), (int(at) + 1, at % 1)):
                count[layer] += share
                sums[layer] += share*v[2]
        return [a/b for a, b in zip(sums, count)]

    def formula(self, when, U, law):
        """Drop [Pa] by a law, with void fraction and slip of each layer."""
        return sum(law(alpha, U - v) for alpha, v in zip(self.profile(when), self.rise(when))
                   )*HEIGHT/LAYERS


def judgeFormulas(run):
    """At the end of each speed below the onset, of the bed as it lies in the beginning."""
    drops, height = dict(run.drops()), HEIGHT/LAYERS
    profile = run.profile(run.times()[0])
    onset = root(lambda u: sum(powder.slope(a, u) for a in profile)*height - WEIGHT, 0, 1)
    for when, U in zip(run.times(), run.speeds):
        if U > onset:
            break
        measured = drops[min(drops, key=lambda t: abs(t - float(when)))]
        for name, law in (("Ergun", ergun), ("the drag law", powder.slope)):
            expected = run.formula(when, U, law)
            run.row(f"drop at {1e3*U:.0f} mm/s, {name} [Pa]", expected, measured,
                    measured/expected - 1, FORMULA)
    return onset


def judgeLifted(run, onset, plateau):
    """Means over the second half of each speed above the onset; `plateau`: tolerance of the net weight
    alone."""
    for i, U in enumerate(run.speeds):
        if U < 1.03*onset:
            continue
        stop = float(run.times()[-1 if U == run.speeds[-1] else i])
        measured, load = run.balance(stop - 0.5*HOLD, stop)
        run.row(f"drop at {1e3*U:.0f} mm/s, what it carries [Pa]", load, measured, measured/load - 1,
                BALANCE)
        run.row(f"drop at {1e3*U:.0f} mm/s, net weight [Pa]", WEIGHT, measured, measured/WEIGHT - 1,
                plateau)


def judgeSpheres(run):
    rows = run.table("powderBalance")
    missing = max(abs(row[5]) for row in rows)/rows[0][4]
    run.row("mass missing, of all", 0, missing, missing, MASS)
    for name, value in (("spheres lost", rows[-1][8]),
                        ("spheres outside the mesh", max(row[7] for row in rows)),
                        ("powder cut off by the floor [m3]", max(row[15] for row in rows))):
        run.row(name, 0, value, value, 0)


def verify(bench):
    run = PackedBed(bench, "packedBed", SPEEDS)
    flow = -run.table("flow")[-1][1]
    run.row("flow in the end [m3/s]", SPEEDS[-1]*AREA, flow, flow/(SPEEDS[-1]*AREA) - 1, FLOW)
    judgeLifted(run, judgeFormulas(run), math.inf)
    judgeSpheres(run)
    smooth = PackedBed(bench, "smoothWall", (0.012, 0.020), wallFriction=0)
    judgeLifted(smooth, judgeFormulas(smooth), PLATEAU)
    judgeSpheres(smooth)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--solver", required=True, help="path of demPimpleFoam")
    options.add_argument("--work", required=True, help="folder for the runs")
    options.add_argument("--ranks", type=int, default=2)
    options.add_argument("--naive", help="not used")
    chosen = options.parse_args()
    shutil.rmtree(chosen.work, ignore_errors=True)
    bench = Bench("A02aErgun", chosen.solver, chosen.work, chosen.ranks)
    verify(bench)
    bench.end()


if __name__ == "__main__":
    main()
