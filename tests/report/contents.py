# SPDX-License-Identifier: GPL-3.0-or-later
"""What the report says, as blocks that pages.py writes as Markdown and as HTML."""
import math
import time
from dataclasses import dataclass

from results import MAKE

LARGE = 1e-2  # a distance that is worth a word
COLUMNS = ("case", "quantity", "expected", "measured", "error", "tolerance", "ranks", "seconds", "")


@dataclass
class Heading:
    level: int
    text: str


@dataclass
class Text:
    text: str
    bad: bool = False


@dataclass
class Quote:
    """As it stands in the source, with its lines and formulas."""
    text: str


@dataclass
class Table:
    header: tuple
    rows: list  # (class, cells)
    folded: str = ""  # its title, if it is to be opened by hand


@dataclass
class Figure:
    name: str
    caption: str
    png: bytes


def report(tests, solverBuilt, figures, curves):
    yield Heading(1, "Verification of Interstice")
    yield from summary(tests, solverBuilt)
    yield from missed(tests)
    yield Heading(2, "Margins")
    yield from figures
    if curves:
        yield Heading(2, "Against theory")
        yield Text("Lines: theory; dots: measured. The numbers that are judged stand below, under the names of the tests.")
        yield from curves
    yield from distances(tests)
    yield Heading(2, "Every number")
    yield Text("The error is relative to the number that is expected, or a difference where that "
               "is zero or a matter of round-off. A bound (at most, at least) has no error as long "
               "as it is kept. Equal rows of several numbers of ranks are one line, with the "
               "numbers of the worst, whose ranks are bold; what is missed has a line of its own.")
    for test in tests:
        yield from details(test)


def succeeded(tests):
    return not any(test.missing or test.count("MISSED") for test in tests)


def summary(tests, solverBuilt):
    rows = [row for test in tests for row in test.rows]
    runs = [run for test in tests for run in test.runs]
    lost = sum(len(test.missing) for test in tests)
    wrong = sum(test.count("MISSED") for test in tests)
    judged = sum(row.kind != "shown" or not row.good for row in rows)
    if succeeded(tests):
        yield Text(f"**All {judged} numbers are met, in {len(runs)} runs of {len(tests)} tests.**")
    else:
        yield Text(f"**{wrong} of {judged} numbers {'is' if wrong == 1 else 'are'} missed; "
                   f"{lost} of {len(runs)} runs {'has' if lost == 1 else 'have'} left no result.**",
                   bad=True)
    made = sorted(run.made for run in runs if run.made is not None)
    yield Text(f"Made from {moment(made[0])} to {moment(made[-1])}; what must be true, and why, "
               "stands at the top of each test's file.")
    old = [test.name for test in tests
           if any(run.made is not None and run.made < solverBuilt for run in test.runs)]
    if old:
        yield Text(f"The solver was built after these had run, at {moment(solverBuilt)}; ./Alltest "
                   f"runs them with it: {', '.join(old)}.", bad=True)
    yield Table(("test", "runs", "rows", "met", "shown only", "missed", "no result"),
                [tally(test.name, [test]) for test in tests] + [tally("**all**", tests)])


def tally(name, tests):
    """A line of the summary."""
    numbers = [sum(len(test.runs) for test in tests), sum(len(test.rows) for test in tests)]
    for verdict in ("met", "shown", "MISSED"):
        numbers.append(sum(test.count(verdict) for test in tests))
    numbers.append(sum(len(test.missing) for test in tests))
    return "" if succeeded(tests) else "missed", [name, *map(str, numbers)]


def moment(seconds):
    return time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime(seconds))


def missed(tests):
    """Everything red, in one place."""
    if succeeded(tests):
        return
    yield Heading(2, "Missed or without result")
    if any(test.missing for test in tests):
        yield Text(f"A test leaves no result if it has not run or has ended early; {MAKE}.")
    for test in tests:
        if test.missing or test.count("MISSED"):
            yield Heading(3, test.name)
            yield from judged([line for line in test.lines if not line.row.good], test.missing)


def distances(tests):
    shown = [(test, [line for line in test.lines if line.row.verdict == "shown"]) for test in tests]
    far = [(test, [line for line in lines if abs(line.row.error) > LARGE]) for test, lines in shown]
    near = sum(len(lines) for _, lines in shown) - sum(len(lines) for _, lines in far)
    yield Heading(2, "Distances")
    yield Text("Numbers that the method does not reach: shown, not judged, and off by more than "
               f"{100*LARGE:g} %; with what the test says about them."
               + (f" Others that are shown only, within {100*LARGE:g} % or with nothing to "
                  f"compare to: {near}." if near else ""))
    for test, lines in far:
        if lines:
            yield Heading(3, test.name)
            yield from judged(lines)
            yield Quote(test.text)


def details(test):
    yield Heading(3, test.name)
    yield Text(" ".join(test.text.split("\n\n")[0].split()))
    lines = test.lines
    always = [line for line in lines if line.standing and line.row.good]
    yield from judged([line for line in lines if line not in always], test.missing)
    if always:
        yield from judged(always, folded="Met in every coupled run: no particle lost, no powder "
                          "cut off, no value that is no number, little momentum waiting "
                          f"({len(always)} lines)")


def judged(lines, missing=(), folded=""):
    rows = [("missed" if not line.row.good else line.row.verdict, cells(line)) for line in lines]
    rows += [("missed", [f"**{run.variant}**", "no result", *[""]*6, "**NO RESULT**"])
             for run in missing]
    if rows:
        yield Table(COLUMNS, rows, folded)


def cells(line):
    row = line.row
    ranks = ", ".join(f"**{n}**" if n == row.ranks and len(line.ranks) > 1 else str(n)
                      for n in sorted(line.ranks))
    allowed = number(row.tolerance, ".2g") if row.kind == "within" else row.kind
    verdict = row.verdict if row.good else "**MISSED**"
    return [row.case, row.quantity, number(row.expected, ".6g"), number(row.measured, ".6g"),
            number(row.error, ".1e") if row.error else "0", allowed, ranks, f"{row.seconds:.1f}",
            verdict]


def number(value, form):
    return format(value, form) if math.isfinite(value) else "no number"
