# SPDX-License-Identifier: GPL-3.0-or-later
"""Cohesion of the die filling case: what pulls two parcels off each other, and one off a wall, is the van der Waals force
A r/(6 z0^2) of a grain's asperity [H.C. Hamaker, Physica 4 (1937) 1058-1072], times k^2 or k^3. LIGGGHTS alone: drawn
apart without damping; the largest pull on the way.

And `prepare`: cohesion of parcels without a rule for their size is refused, `auto` takes it where a grain weighs less.
"""
import math
import pathlib
import shutil
import subprocess

from dem.run import Run
from harness.bench import main

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT/"foam_cases/dieFilling"
PULL = 1e-2
GRAIN, DENSITY = 40e-6, 7360.0
FORCE = 1e-19*1e-7/(6*4e-10**2)  # [N]
SCALES = {"stress": 2, "weight": 3}


def prepared(bench, name, *changes):
    """Derived numbers of a variant of the case, whose bed is not poured: {key: number}, or what was said instead."""
    tree = bench.work/"tree"
    case = tree/"foam_cases/dieFilling"
    if not case.is_dir():
        shutil.copytree(CASE, case, ignore=shutil.ignore_patterns("variants", "results", "processor*", "postProcessing",
                                                                  "preparation", "polyMesh", "0.*", "log.*", "pictures"))
        (tree/"liggghts_scripts").mkdir()  # no script that could pour
        (tree/"foam_cases/common").symlink_to(ROOT/"foam_cases/common")
    subprocess.run([case/"variant", name, *changes], check=True, stdout=subprocess.DEVNULL)
    done = subprocess.run([case/"variants"/name/"prepare"], capture_output=True, text=True)
    derived = case/"variants"/name/"system/caseDerived"
    numbers = {}
    if derived.is_file():
        for line in derived.read_text().splitlines():
            words = line.rstrip(";").split()
            if len(words) == 2:
                numbers[words[0]] = words[1]
    return numbers, done.stdout + done.stderr


def drawn(bench, name, k, numbers, wall):
    """Largest pull on the upper parcel [N]."""
    d = k*GRAIN
    away = 2e-3*d  # overlap at the start
    lower = [] if wall else [(1, d, DENSITY, (0, 0, 0.5*d), (0, 0, 0))]
    bottom = 0 if wall else d
    spheres = lower + [(1, d, DENSITY, (0, 0, bottom + 0.5*d - away), (0, 0, 2e-5*k))]
    step = 1e-7*k
    steps = round(1.1*away/spheres[-1][4][2]/step)
    run = Run(bench, name, "pulled.in", spheres, ((-d, -d, -0.5*d), (d, d, 4*d)), (step, steps, max(1, steps//4000)), 2,
              contacts=ROOT/"liggghts_scripts/contacts.in", plane=int(wall), youngsModulus=1e7, wallYoungsModulus=3e7,
              poissonsRatio=0.3, restitution=1, wallRestitution=1, friction=0.67, rollingFriction=0.218,
              rollingModel="epsd2", particleDensity=DENSITY, parcelRadius=d/2,
              **{key: numbers[key] for key in ("cohesionModel", "cohesionEnergyDensity", "wallCohesionEnergyDensity")})
    return run, -min(row[5] for _, row in run.track(len(spheres) - 1))


def verify(bench):
    for rule, k in (("none", 1), ("stress", 10), ("weight", 10)):
        numbers, _ = prepared(bench, f"{rule}{k}", "cohesion=on", f"coarseGraining={k}", f"cohesionScaling={rule}",
                              "wallYoungsModulus=3e7")
        for wall in (False, True):
            run, pull = drawn(bench, f"k {k}, {rule}, {'wall' if wall else 'pair'}", k, numbers, wall)
            bench.near(run, "largest pull [N]", k**SCALES.get(rule, 0)*FORCE, pull, PULL)
    if bench.ranks > 1:
        return
    _, said = prepared(bench, "noRule", "cohesion=on")
    wanted = ("cohesion on, coarseGraining 10, cohesionScaling none", "stress or weight")
    bench.row("parcels without a rule", "words missing from the error", 0, sum(w not in said for w in wanted),
              sum(w not in said for w in wanted), 0, 0.0)
    heavy = (FORCE*6/(math.pi*DENSITY*9.81))**(1/3)  # its weight is the force [m]
    for size, on in ((1.01*heavy, False), (0.99*heavy, True)):
        numbers, _ = prepared(bench, "choice", "cohesion=auto", "cohesionScaling=stress", f"particleDiameter={size:.9g}")
        found = float(numbers["cohesionEnergyDensity"]) > 0
        bench.row(f"auto, {1e6*size:.4g} um", "is cohesive", on, found, found - on, 0, 0.0)


if __name__ == "__main__":
    main(verify)
