# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests with numbers have left in a build: the tests that ctest knows, and their rows."""
import ast
import json
import math
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

GROUPS = ("verification", "stability")
MAKE = "./Alltest -L 'verification|stability|long' makes them"
BUILD = "./Alltest sets up, builds and tests; cmake --build builds what is configured"

# Judged in every coupled run, see harness/bench.py; many, and all alike.
STANDING = ("steps with lost particles", "steps with powder cut off by the floor",
            "momenta that are no number", "remainder, of a step's drag impulse")


class BadInput(Exception):
    """One sentence for the user."""


@dataclass(frozen=True)
class Row:
    case: str
    quantity: str
    expected: float
    measured: float
    error: float
    tolerance: float  # None: shown, not judged
    ranks: int
    seconds: float
    good: bool

    @property
    def kind(self):
        """A tolerance of zero is a bound; which one, the numbers tell."""
        if self.tolerance is None:
            return "shown"
        if self.tolerance > 0:
            return "within"
        if not math.isfinite(self.measured):
            return "bound"
        if self.error > 0 or self.error == 0 and self.measured < self.expected:
            return "at most"
        if self.error < 0 or self.measured > self.expected:
            return "at least"
        return "exactly"

    @property
    def used(self):
        """The share of what is allowed that is used: missed above one. Of a bound: how near the
        number is to it."""
        if self.kind == "shown" or not math.isfinite(self.measured):
            return math.inf if self.tolerance is not None else 0.0
        if self.kind == "within":
            return abs(self.error)/self.tolerance
        if self.kind == "exactly":
            return 0.0
        bound, measured = self.expected, self.measured
        if self.kind == "at least":
            bound, measured = -bound, -measured
        if bound > 0:
            return max(0.0, measured)/bound
        if bound < 0:
            return bound/measured if measured < 0 else math.inf
        return 0.0 if self.good else math.inf

    @property
    def verdict(self):
        if not self.good:
            return "MISSED"
        return "shown" if self.kind == "shown" else "met"


@dataclass(frozen=True)
class Curve:
    """Points (x, y) of a theory and of what was measured."""
    title: str
    x: str  # on the axes
    y: str
    log: bool
    theory: list
    measured: list


CURVE = {"title": str, "x": str, "y": str, "log": bool, "theory": list, "measured": list}
NUMBERS = ("expected", "measured", "error", "seconds")
TYPES = {"case": str, "quantity": str, "ranks": int, "good": bool,
         **dict.fromkeys(NUMBERS, (int, float)), "tolerance": (int, float, type(None))}


@dataclass
class Run:
    """A test of ctest: one case file on some ranks."""
    name: str
    script: Path
    folder: Path
    rows: list = field(default_factory=list)
    curves: list = field(default_factory=list)
    made: float = None  # when, seconds since 1970; None: no result

    @property
    def group(self):
        return self.name.partition(".")[0]

    @property
    def variant(self):
        return self.name.rpartition(".")[2]


@dataclass
class Line:
    """A row of one or more numbers of ranks; of several, the worst."""
    row: Row
    ranks: list

    @property
    def standing(self):
        return self.row.quantity in STANDING


@dataclass
class Test:
    """A case file and its runs."""
    name: str
    text: str  # its docstring
    runs: list

    @property
    def rows(self):
        return [row for run in self.runs for row in run.rows]

    @property
    def curves(self):
        """Alike on any ranks: of the first run that has some."""
        return next((run.curves for run in self.runs if run.curves), [])

    @property
    def missing(self):
        return [run for run in self.runs if run.made is None]

    @property
    def lines(self):
        return fold(self.runs)

    def count(self, verdict):
        return sum(row.verdict == verdict for row in self.rows)


def fold(runs):
    """Joins rows that differ in the number of ranks only. What is missed keeps its own line."""
    lines, joined = [], {}
    for run in runs:
        seen = {}
        for row in run.rows:
            key = (row.case, row.quantity)
            seen[key] = seen.get(key, 0) + 1
            line = joined.get((key, seen[key]))
            if not row.good or line is None:
                lines.append(Line(row, [row.ranks]))
                if row.good:
                    joined[key, seen[key]] = lines[-1]
                continue
            if row.ranks not in line.ranks:
                line.ranks.append(row.ranks)
            if (row.used, abs(row.error)) > (line.row.used, abs(line.row.error)):
                line.row = row
    return lines


def read(build):
    """The tests of a build with the rows they left, and the time the solver was built."""
    runs, solver = known(build)
    for run in runs:
        path = run.folder/"results.json"
        if path.is_file():
            run.rows, run.curves = contentOf(path, path.relative_to(build) if build in path.parents else path)
            run.made = path.stat().st_mtime if run.rows else None
    if all(run.made is None for run in runs):
        raise BadInput(f"No test of {build} has left a result: {MAKE}.")
    tests = {}
    for run in sorted(runs, key=lambda run: (GROUPS.index(run.group), run.script)):
        tests.setdefault(run.script, []).append(run)
    return [Test(script.stem, docstring(script), group) for script, group in tests.items()], solver


def known(build):
    """The runs that ctest knows, and when their solver was built."""
    if not build.is_dir():
        raise BadInput(f"The build folder {build} does not exist: {BUILD}.")
    if not (build/"CTestTestfile.cmake").is_file():
        raise BadInput(f"The folder {build} holds no configured build: {BUILD}.")
    try:
        ctest = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"],
                               capture_output=True, text=True)
    except FileNotFoundError:
        raise BadInput("ctest, which knows the tests, is not on the PATH: install cmake.")
    if ctest.returncode:
        raise BadInput(f"ctest cannot list the tests of {build}: {' '.join(ctest.stderr.split())}")
    runs, solvers = [], set()
    for test in json.loads(ctest.stdout)["tests"]:
        if test["name"].partition(".")[0] in GROUPS:
            runs.append(runOf(test, build))
            solvers.update(option(test, "--solver"))
    if not runs:
        raise BadInput(f"ctest knows no verification test in {build}: the laws alone are built "
                       "there, or no tests; the release preset has them.")
    for solver in map(Path, sorted(solvers)):
        if not solver.is_file():
            raise BadInput(f"The build in {build} is not complete, it has no {solver.name}: "
                           f"{BUILD}.")
    return runs, max((Path(solver).stat().st_mtime for solver in solvers), default=0.0)


def option(test, name):
    command = test.get("command", [])
    return command[command.index(name) + 1:][:1] if name in command else []


def runOf(test, build):
    group, _, rest = test["name"].partition(".")
    folder = Path(*(option(test, "--work") or [build/"tests"/group/rest]))
    scripts = [word for word in test.get("command", []) if word.endswith(".py")]
    return Run(test["name"], Path(*(scripts[:1] or [rest.rpartition(".")[0]])), folder)


def docstring(script):
    return ast.get_docstring(ast.parse(script.read_text())) or "" if script.is_file() else ""


def contentOf(path, name):
    """Rows and curves of a results.json."""
    try:
        content = json.loads(path.read_text())
    except ValueError as reason:
        raise BadInput(f"{name} is torn ({reason}): run its test again, {MAKE}.")
    for key, kind in (("test", str), ("rows", list)):
        require(content, key, kind, f"{name}")
    for number, row in enumerate(content["rows"], 1):
        for key, kind in TYPES.items():
            require(row, key, kind, f"row {number} of {name}")
    curves = content.get("curves", [])
    for number, curve in enumerate(curves, 1):
        for key, kind in CURVE.items():
            require(curve, key, kind, f"curve {number} of {name}")
        for point in curve["theory"] + curve["measured"]:
            if not isinstance(point, list) or len(point) != 2 or not all(isinstance(x, (int, float)) for x in point):
                raise BadInput(f"A point of curve {number} of {name} is {point!r} and must be two numbers: "
                               f"run its test again, {MAKE}.")
    return ([Row(**{key: row[key] for key in TYPES}) for row in content["rows"]],
            [Curve(**{key: curve[key] for key in CURVE}) for curve in curves])


def require(content, key, kind, where):
    if not isinstance(content, dict) or key not in content:
        raise BadInput(f"The key '{key}' is missing from {where}: run its test again, {MAKE}.")
    value = content[key]
    if not isinstance(value, kind) or isinstance(value, bool) and kind is not bool:
        raise BadInput(f"The key '{key}' of {where} is {value!r}, which it cannot be: "
                       f"run its test again, {MAKE}.")
