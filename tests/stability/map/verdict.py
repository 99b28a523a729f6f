# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of a run, in one of three words.

stable    it ended by itself, every number is finite, no particle was lost and no powder cut off,
          neither powder nor air was ever faster than three times what physics allows them, and the
          swing of the powder from step to step does not grow
refused   it ended with an error that names the rule, what it found and what it wants, and all was well
          until then: a refusal that comes when powder and air are already wild is none
blew up   all else

What physics allows is said by the scene: case.limit for the powder, case.airLimit for the air, and
case.scale for swings [m/s].
"""
import math
import re
import signal
import subprocess

import hardCase
from harness.case import Run, execute

MARGIN = 3  # on the speeds that physics allows
SMALLEST = 0.1  # swing, of the scene's speed, below which it is none: free grains that cross cells
LONGEST = 60  # seconds of a processor; a run that takes more counts as one that does not end
LIMITED = ["sh", "-c", f'ulimit -S -t {LONGEST}; exec "$0" "$@"']


def judge(case, folder, ranks, solver):
    """Runs a case: the word, its reason, and what was measured."""
    error = start(case, folder, ranks, solver)
    log = (folder/"log.demPimpleFoam").read_text()
    run = Run(case, folder, ranks, wallTime(log), log)
    numbers = measure(run)
    reason = complaint(numbers)
    if error is not None and not reason:
        rule, found = refusal(log)
        if rule:
            return {"word": "refused", "reason": rule, "found": found, **numbers}
        reason = error
    if not reason and hasattr(case, "expected") and numbers["steps"]:
        numbers["end"] = numbers["mean speed"]/case.expected(run)
    return {"word": "blew up" if reason else "stable", "reason": reason, **numbers}


def start(case, folder, ranks, solver):
    """Runs a case; what went wrong, if something did."""
    case.write(folder, ranks)
    execute(folder, ["blockMesh"], "log.blockMesh")
    command = LIMITED + [solver]
    if ranks > 1:
        execute(folder, ["decomposePar"], "log.decomposePar")
        command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks),
                   *command, "-parallel"]
    try:
        execute(folder, command, "log.demPimpleFoam")
    except subprocess.TimeoutExpired:
        return "did not end"
    except hardCase.Failed as failure:
        if f"ended with -{signal.SIGXCPU:d} " in str(failure):
            return f"did not end within {LONGEST} s"
        lines = [line for line in str(failure).splitlines() if line.strip()]
        return next((line for line in lines if line.startswith("ERROR")), lines[-1])
    if ranks > 1:
        execute(folder, ["reconstructPar"], "log.reconstructPar")
    return None


def wallTime(log):
    found = re.findall(r"wall time\s+(\S+)", log)
    return float(found[-1]) if found else 0.0


def refusal(log):
    """Rule and finding of an error that a user can remedy: it says what is wanted. Values that are
    no number end a run too, and are no refusal."""
    found = re.search(r"^ERROR: (.*)\n {4}found +(.*)(?:\n {12}.*)*\n {4}wanted", log, re.M)
    return found.groups() if found else (None, None)


def measure(run):
    case = run.case
    taken = hardCase.steps(run)
    numbers = {"steps": len(taken), "seconds": run.seconds,
               "lost": len(re.findall(r"\d+ LOST", run.log)),
               "cut off": len(re.findall(r"of powder not seen by the air", run.log))}
    if not taken:
        return numbers
    numbers["air"] = max(step.speed for step in taken)/case.airLimit
    numbers["step"] = max(step.dt for step in taken)
    numbers["outside"] = max(step.outside for step in taken)
    if case.positions:
        numbers["powder"] = fastest(run)/case.limit
    if case.motion in ("free", "tied"):
        speeds = [row[2][2]/case.mass for row in run.budget()]
        first, last = swing(speeds)
        numbers.update({"mean speed": abs(speeds[-1]),
                        "first swing": first/case.scale, "last swing": last/case.scale})
    return numbers


def swing(speeds):
    """Largest second difference of the powder's speed from step to step, in the first and the last
    third of a run."""
    second = [abs(a - 2*b + c) for a, b, c in zip(speeds, speeds[1:], speeds[2:])] or [0.0]
    third = -(-len(second)//3)
    return worst(second[:third]), worst(second[-third:])


def worst(numbers):
    return max(numbers) if all(map(math.isfinite, numbers)) else math.inf


def fastest(run):
    lines = (run.folder/"fastest.txt").read_text().splitlines()
    return worst([float(line.split()[1]) for line in lines if line and line[0] != "#"] or [0.0])


def complaint(numbers):
    """Why a run is not stable; nothing if it is."""
    if numbers["lost"]:
        return "particles lost"
    if numbers["cut off"]:
        return "powder cut off by the floor of the void fraction"
    for what in ("powder", "air"):
        if not numbers.get(what, 0) <= MARGIN:
            return f"{what} {numbers[what]:.2g} times as fast as physics allows"
    first, last = numbers.get("first swing", 0), numbers.get("last swing", 0)
    if last > max(first, SMALLEST):
        return f"swing of the powder grows from {first:.2g} to {last:.2g} of its speed"
    return ""

