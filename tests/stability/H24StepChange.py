# SPDX-License-Identifier: GPL-3.0-or-later
"""The die-filling slice with half and with twice the coupling step: the filling ratio changes by
less than one percentage point (pp). The air's step and the coupling interval are one and the same
here, so that this is the convergence in both; half of it is `coupling x 0.5` as well.

Packings make single runs scatter by 1.7 pp (24 runs), and so do last digits, because contacts amplify
them. So means over packings are compared. Their difference has the standard error s sqrt(2/n), with s the
scatter of a single run, pooled over all settings, and n the number of packings. Allowed are 1 pp and two
standard errors; both are printed, and whoever wants it sharper asks for more packings: with s = 1.7 pp,
3 allow 3.8 pp, 30 allow 1.9 pp. foam_cases/dieFilling/studies/stepChange.yaml is the same; eight packings of it say
that half of the step changes the ratio by 0.3 +- 0.9 pp, twice the step by 0.7 +- 0.9 pp. When moving
walls pushed the air through what they had not covered of a cell (H15MovingBed), twice the step changed it by 1.8 +- 0.6 pp.

That the steps really differ is judged, too: a Courant number that binds would make them the same.

    H24StepChange.py --packings 3      nine whole fillings, two minutes each on an idle core
"""
import argparse
import math
import os
import shutil
import sys

from hardCase import STEP

from A12DieFilling import ROOT, SEEDS, Slice, mean
from harness.bench import Bench

sys.path.append(str(ROOT/"foam_cases/common"))

import parameters  # noqa: E402

CHANGE = 0.01  # of the filling ratio
CASE = parameters.read(ROOT/"foam_cases/dieFilling/system/caseParameters")
FACTORS = {"chosen": 1.0, "half": 0.5, "twice": 2.0}
TAKEN = 0.1  # relative, of the mean step to what it should be


def meanStep(run):
    log = (run.folder/"log.demPimpleFoam").read_text()
    return mean([float(found["dt"]) for found in STEP.finditer(log)])


def fill(bench, packings, changes):
    """Runs by setting: all of one packing, then of the next."""
    runs = {setting: [] for setting in FACTORS}
    for seed in SEEDS[:packings]:
        for setting, factor in FACTORS.items():
            run = Slice(bench, f"{setting}{seed}", bench.ranks, seed=seed,
                        couplingNumber=factor*CASE["couplingNumber"], maxDeltaT=factor*CASE["maxDeltaT"],
                        **changes)
            ratio = run.filling()
            bench.row(run.name, "filling ratio", ratio, ratio, 0, math.inf, run.seconds)
            runs[setting].append(run)
    return runs


def scatter(groups):
    """Of a single run, pooled over settings."""
    squares = [(x - mean(group))**2 for group in groups for x in group]
    return math.sqrt(sum(squares)/(len(squares) - len(groups)))


def compare(bench, runs):
    fillings = {setting: [run.filling() for run in group] for setting, group in runs.items()}
    steps = {setting: mean([meanStep(run) for run in group]) for setting, group in runs.items()}
    packings = len(fillings["chosen"])
    error = scatter(fillings.values())*math.sqrt(2/packings) if packings > 1 else math.inf
    bench.row("all", "standard error of a difference of means", 0, error, 0, math.inf, 0)
    first = mean(fillings["chosen"])
    for setting, factor in FACTORS.items():
        if setting == "chosen":
            continue
        ratio = steps[setting]/steps["chosen"]
        bench.row(setting, "mean coupling step, of the chosen", factor, ratio, ratio/factor - 1,
                  TAKEN, 0)
        value = mean(fillings[setting])
        bench.row(setting, f"filling ratio, mean of {packings}", first, value, value - first,
                  CHANGE + 2*error, 0)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--solver", required=True, help="path of demPimpleFoam")
    options.add_argument("--work", required=True, help="folder for the runs")
    options.add_argument("--ranks", type=int, default=2)
    options.add_argument("--packings", type=int, default=3)
    options.add_argument("--naive", help="not used")
    options.add_argument("--changes", nargs="*", default=[], metavar="KEY=VALUE",
                         help="parameters of the case, for a smaller one")
    chosen = options.parse_args()
    if not 1 < chosen.packings <= len(SEEDS):
        options.error(f"from 2 to {len(SEEDS)} packings: one has no scatter")
    os.environ["OMPI_MCA_mpi_yield_when_idle"] = "1"  # where ranks share cores
    shutil.rmtree(chosen.work, ignore_errors=True)
    bench = Bench("H24StepChange", chosen.solver, chosen.work, chosen.ranks)
    changes = dict(change.split("=") for change in chosen.changes)
    compare(bench, fill(bench, chosen.packings, changes))
    bench.end()


if __name__ == "__main__":
    main()
