# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs cases, compares numbers, and prints and keeps one row for each."""
import argparse
import json
import math
import pathlib
import re
import shutil
import sys

from . import case as cases


class Bench:
    def __init__(self, name, solver, work, ranks, naive=None):
        self.name = name
        self.solver = str(pathlib.Path(solver).resolve())
        self.naiveFolder = naive
        self.work = pathlib.Path(work).resolve()
        self.ranks = ranks
        self.rows = []
        self.curves = []
        self.quiet = False
        # A run that breaks off must not leave the results of an earlier one.
        (self.work/"results.json").unlink(missing_ok=True)
        print(f"{'case':24s} {'quantity':44s} {'expected':>13s} {'measured':>13s} "
              f"{'error':>10s} {'allowed':>9s} {'ranks':>5s} {'s':>6s}")

    def folder(self, case):
        """OpenFOAM allows few characters in the name of a folder."""
        return self.work/re.sub(r"[^A-Za-z0-9.]+", "_", case.name)

    def run(self, case, impulse):
        """Runs a case and judges what must hold in every coupled run. `impulse` [N s]: what drag
        gives to the powder in a step; what waits to be given to the air never exceeds it."""
        run = cases.run(case, self.folder(case), self.ranks, self.solver)
        self.judge(run, impulse)
        return run

    def runNaively(self, case, choice):
        """Runs a case by the solver with a naive choice; nothing is judged."""
        solver = pathlib.Path(self.naiveFolder).resolve()/choice
        return cases.run(case, self.folder(case), self.ranks, str(solver))

    def judge(self, run, impulse):
        """Rows that are printed only if they fail: they are many, and all alike."""
        self.quiet = True
        lost = len(re.findall(r"\d+ LOST", run.log))
        self.atMost(run, "steps with lost particles", 0, lost)
        clipped = len(re.findall(r"of powder not seen by the air", run.log))
        self.atMost(run, "steps with powder cut off by the floor", 0, clipped)
        budget = run.budget()
        finite = all(math.isfinite(x) for row in budget for part in row[1:] for x in part)
        self.atMost(run, "momenta that are no number", 0, 0 if finite else 1)
        waiting = max(math.hypot(*row[3]) for row in budget)
        self.atMost(run, "remainder, of a step's drag impulse", 1.001,
                    waiting/impulse if impulse else waiting)
        self.quiet = False

    def refused(self, case, *texts):
        """The case must end with an error that says all these texts."""
        try:
            cases.run(case, self.folder(case), self.ranks, self.solver)
        except cases.Failed as failure:
            missing = [text for text in texts if text not in str(failure)]
            self.row(case.name, "refused; words missing from the error", 0, len(missing),
                     len(missing), 0, 0.0)
            return
        self.row(case.name, "refused; words missing from the error", 0, len(texts), len(texts), 0,
                 0.0)

    def near(self, run, quantity, expected, measured, tolerance):
        """Relative error at most `tolerance`."""
        error = (measured - expected)/abs(expected)
        self.row(run.case.name, quantity, expected, measured, error, tolerance, run.seconds)

    def equal(self, run, quantity, expected, measured, difference):
        """Differs by at most so much."""
        self.row(run.case.name, quantity, expected, measured, measured - expected, difference,
                 run.seconds)

    def atMost(self, run, quantity, bound, measured):
        self.row(run.case.name, quantity, bound, measured, max(0.0, measured - bound), 0,
                 run.seconds)

    def atLeast(self, run, quantity, bound, measured):
        self.row(run.case.name, quantity, bound, measured, min(0.0, measured - bound), 0,
                 run.seconds)

    def report(self, run, quantity, expected, measured):
        """A number that is shown and not judged."""
        error = (measured - expected)/abs(expected)
        self.row(run.case.name, quantity, expected, measured, error, math.inf, run.seconds)

    def row(self, case, quantity, expected, measured, error, tolerance, seconds):
        expected, measured = (+x if isinstance(x, bool) else x for x in (expected, measured))
        good = math.isfinite(measured) and abs(error) <= tolerance
        self.rows.append({"case": case, "quantity": quantity, "expected": expected,
                          "measured": measured, "error": error,
                          "tolerance": None if math.isinf(tolerance) else tolerance,
                          "ranks": self.ranks, "seconds": round(seconds, 2), "good": good})
        if self.quiet and good:
            return
        print(f"{case:24s} {quantity:44s} {expected:13.6g} {measured:13.6g} {error:10.2e} "
              f"{'shown' if math.isinf(tolerance) else format(tolerance, '9.1e'):>9s} "
              f"{self.ranks:5d} {seconds:6.1f} {'' if good else '  <-- FAILED'}", flush=True)

    def curve(self, title, x, y, theory, measured, log=False):
        """For the report: the line of a theory and the points that were measured, [(x, y), ...]. `x`, `y`: words for the
        axes. Nothing is judged."""
        self.curves.append({"title": title, "x": x, "y": y, "log": log, "theory": list(theory), "measured": list(measured)})

    def end(self):
        self.work.mkdir(parents=True, exist_ok=True)
        (self.work/"results.json").write_text(
            json.dumps({"test": self.name, "rows": self.rows, "curves": self.curves}, indent=1) + "\n")
        bad = [row for row in self.rows if not row["good"]]
        if not self.rows:
            sys.exit("nothing was verified")
        if bad:
            sys.exit(f"{len(bad)} of {len(self.rows)} numbers are not met")


def main(verify):
    """Runs a case file: verify(bench)."""
    options = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__)
    options.add_argument("--solver", required=True, help="path of demPimpleFoam")
    options.add_argument("--work", required=True, help="folder for the runs")
    options.add_argument("--ranks", type=int, default=1)
    options.add_argument("--naive", help="folder of solvers with naive choices")
    chosen = options.parse_args()
    shutil.rmtree(chosen.work, ignore_errors=True)  # what an earlier run left may be of other sources
    name = pathlib.Path(sys.argv[0]).stem
    bench = Bench(name, chosen.solver, chosen.work, chosen.ranks, chosen.naive)
    verify(bench)
    bench.end()
