# SPDX-License-Identifier: GPL-3.0-or-later
"""The die-filling slice of foam_cases/dieFilling, whole runs: what the air holds back (DF4), and that
no powder is lost.

    A12DieFilling.py --unseenShoe                          what a shoe lets out that the air does not see (DF8)
    A12DieFilling.py --packings 3 --compareRanks 1 2 4     three packings on each number of ranks

Filling ratios are those after the shoe has passed, relative to the die filled without air.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys
import time

from harness.bench import Bench

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT/"studies/engine"))

from seeds import SEEDS  # noqa: E402

DF4 = 0.15  # without air it fills at least so much more
MASS = 1e-12  # missing, of all powder


class Slice:
    """A copy of the case with changed parameters."""

    def __init__(self, bench, name, ranks, **changes):
        self.bench, self.name, self.ranks = bench, name, ranks
        base = bench.work/"tree/foam_cases/dieFilling"
        if not base.is_dir():
            shutil.copytree(ROOT/"foam_cases/dieFilling", base, ignore=shutil.ignore_patterns(
                "variants", "processor*", "postProcessing", "preparation", "VTK", "log.*",
                "pictures", "polyMesh", "triSurface", "0.*"))
            for shared in ("liggghts_scripts", "cmake", "foam_cases/common"):
                (bench.work/"tree"/shared).symlink_to(ROOT/shared)
            self.command([base/"prepare"], base)  # variants take the poured bed along
        start = time.monotonic()
        self.command([base/"variant", name] + [f"{k}={v}" for k, v in changes.items()], base)
        self.folder = base/"variants"/name
        self.command([self.folder/"run", "-np", str(ranks)], self.folder)
        self.seconds = time.monotonic() - start
        self.conserves()

    def command(self, words, folder):
        path = f"{pathlib.Path(self.bench.solver).parent}:{os.environ['PATH']}"
        done = subprocess.run([str(w) for w in words], cwd=folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "PATH": path,
                                   "INTERSTICE_BED_STORE": str(self.bench.work/"beds")})
        if done.returncode:
            sys.exit(f"{self.name}: {words[0]} failed\n" + done.stdout[-3000:])

    def table(self, name):
        text = (self.folder/f"postProcessing/{name}.dat").read_text()
        return [line.split() for line in text.splitlines() if not line.startswith("#")]

    def filling(self):
        return float(self.table("fillingRatio/0/moments")[-1][2])

    def conserves(self):
        rows = [[float(x) for x in row] for row in self.table("powderBalance/0/powderBalance")]
        start = rows[0][4]
        worst = max(abs(row[5]) for row in rows)/start
        lost = rows[-1][8]
        self.bench.row(self.name, "mass missing, of all", 0, worst, worst, MASS, self.seconds)
        self.bench.row(self.name, "parcels lost", 0, lost, lost, 0, self.seconds)


def withAirAnd(bench, other, **changes):
    """One packing with air, and in another way: the filling ratio that it has more."""
    runs = [Slice(bench, "air", bench.ranks), Slice(bench, other, bench.ranks, **changes)]
    for run in runs:
        bench.row(run.name, "filling ratio", run.filling(), run.filling(), 0, math.inf,
                  run.seconds)
    return runs[1].filling() - runs[0].filling()


def heldBack(bench):
    gain = withAirAnd(bench, "noAir", air="off")
    bench.row("noAir - air", "DF4: filling ratio held back by the air", DF4, gain,
              min(0.0, gain - DF4), 0, 0)


def letOut(bench):
    leak = withAirAnd(bench, "unseenShoe", shoeSeenByAir="off")
    bench.row("unseenShoe - air", "DF8: filling ratio let out by the shoe", 0, leak,
              min(0.0, leak), 0, 0)


def mean(values):
    return sum(values)/len(values)


def compareRanks(bench, packings, ranks):
    """Means over packings on each number of ranks differ by no more than two standard errors of
    their difference; the scatter of a single run is pooled over all."""
    fillings = {n: [Slice(bench, f"np{n}seed{seed}", n, seed=seed).filling()
                    for seed in SEEDS[:packings]] for n in ranks}
    squares = [(x - mean(group))**2 for group in fillings.values() for x in group]
    scatter = math.sqrt(sum(squares)/(len(ranks)*(packings - 1)))
    allowed = 2*scatter*math.sqrt(2/packings)
    first = mean(fillings[ranks[0]])
    for n, group in fillings.items():
        bench.row(f"{packings} packings, {n} ranks", "filling ratio, mean", first, mean(group),
                  mean(group) - first, allowed, 0)
    bench.row("all", "scatter of a single run", scatter, scatter, 0, math.inf, 0)


def main():
    import argparse
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--solver", required=True, help="path of demPimpleFoam")
    options.add_argument("--work", required=True, help="folder for the runs")
    options.add_argument("--ranks", type=int, default=2)
    options.add_argument("--unseenShoe", action="store_true")
    options.add_argument("--packings", type=int, default=1)
    options.add_argument("--compareRanks", type=int, nargs="+")
    chosen = options.parse_args()
    shutil.rmtree(chosen.work, ignore_errors=True)
    bench = Bench("A12DieFilling", chosen.solver, chosen.work, chosen.ranks)
    if chosen.compareRanks:
        compareRanks(bench, chosen.packings, chosen.compareRanks)
    elif chosen.unseenShoe:
        letOut(bench)
    else:
        heldBack(bench)
    bench.end()


if __name__ == "__main__":
    main()
