# SPDX-License-Identifier: GPL-3.0-or-later
"""Something breaks in the middle of a run, often on one rank only, while the others wait for it in
a message: a value that is no number in a particle's force or velocity, or in the air; an error that
LIGGGHTS finds on the rank of one particle, or on all; a rank that dies. Two codes in one MPI world
must then end as one.

Measured from the last step before the fault: the run is over within 10 s, its exit code is not
zero, none of its processes is left, and its message tells what happened, and of a value that is no
number also where. Then the last state is on disk, of every rank, at the time of the fault, and of
numbers only.
"""
import collections
import math
import os
import pathlib
import re
import signal
import subprocess
import threading
import time

from hardCase import GRAVITY, Box, Case, Powder, change, lattice, main
from harness.case import environment, execute

CELL, CELLS = 1e-3, (4, 4, 8)  # [m]
STEP, SUBSTEPS = 2e-4, 10
FAULT = 40*STEP  # [s]; DEM step 400
VICTIM = 7  # id of a grain
LIMIT = 10.0  # [s]
PATIENCE = 25.0  # what takes longer hangs

Fault = collections.namedtuple("Fault", "name words edits state signal",
                               defaults=((), False, None))
End = collections.namedtuple("End", "code text seconds left")
Timed = collections.namedtuple("Timed", "case seconds")  # as rows of the bench want it

DUE = f"(step>{round(FAULT/STEP*SUBSTEPS)})"
MOTION = "fix integrate all nve/sphere"
KICK = f"""{MOTION}
group one id {VICTIM}
variable push equal {DUE}*1e200*1e200
fix kick one addforce v_push 0.0 0.0"""
DRIVE = f"""group one id {VICTIM}
group others subtract all one
fix integrate others nve/sphere
variable still equal 0.0
variable speed equal SPEED
fix drive one move variable NULL NULL NULL v_speed v_still v_still"""
INFINITE = f"{DUE}*1e200*1e200"
NO_NUMBER = f"{INFINITE}*(1-{DUE})"
# Divides by zero where the grain is.
DIVIDE = f"""{MOTION}
variable push atom 0.0/(1-{DUE}*(id=={VICTIM}))
fix kick all addforce v_push 0.0 0.0"""
LEAVE = f"""{MOTION}
group one id {VICTIM}
variable push equal {DUE}*1e-3
fix kick one addforce v_push 0.0 0.0"""
LOST = ("thermo          100000", "thermo          50\nthermo_modify   lost error")
JET = (f"type uniformFixedValue; uniformValue table ((0 (0 0 0.1)) ({FAULT:g} (0 0 0.1))"
       f" ({FAULT + 0.5*STEP:g} (0 0 1e300))); value uniform (0 0 0.1);")
WRITTEN = "was written before stopping"

FAULTS = [
    Fault("force of a grain", ("no number", f"particle {VICTIM} ", "on rank ", WRITTEN),
          (("powder.in", MOTION, KICK),), state=True),
    Fault("velocity of a grain", ("no number", f"particle {VICTIM}", "on rank ", WRITTEN),
          (("powder.in", MOTION, DRIVE.replace("SPEED", NO_NUMBER)),), state=True),
    Fault("air at the inlet", ("no number", "cell ", "of rank ", WRITTEN),
          (("0/U", "type fixedValue; value uniform (0 0 0.1);", JET),), state=True),
    Fault("LIGGGHTS, on one rank", ("LIGGGHTS stopped", "Divide by 0"),
          (("powder.in", MOTION, DIVIDE),)),
    Fault("LIGGGHTS, on all ranks", ("LIGGGHTS stopped", "Lost atoms"),
          (("powder.in", MOTION, LEAVE), ("powder.in", *LOST))),
    Fault("a rank is killed", ("signal 9",), signal=signal.SIGKILL),
    Fault("a rank's memory fault", ("signal 11",), signal=signal.SIGSEGV)]


def blown(fault, ranks):
    """Grains in a rising stream; it would run for days."""
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("slip", "periodic", ("inlet", "outlet")))
    case = Case(fault.name, box, Powder(0.3e-3, 2600.0), positions=lattice(box, 2, (2, 5)),
                U=(0, 0, 0.1), gravity=(0, 0, -GRAVITY), deltaT=STEP, subSteps=SUBSTEPS,
                endTime=1e4, smoothingWidth=CELL, processors=f"1 1 {ranks}")
    for edit in fault.edits:
        change(case, *edit)
    return case


def descendants(process):
    """All processes that it started, and those that they did."""
    parents = {}
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            text = path.read_text()
        except OSError:
            continue  # it has ended
        parents[int(path.parent.name)] = int(text.rpartition(")")[2].split()[1])
    found = [process]
    for one in found:
        found += [child for child, parent in parents.items() if parent == one]
    return found[1:]


def alive(process):
    """Whether it runs; what is dead and still listed does not."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def rankProcesses(process, ranks):
    """Its own, or those that mpirun started."""
    return descendants(process)[:ranks] if ranks > 1 else [process]


def gone(processes, since):
    """Seconds until none of them is left."""
    while any(map(alive, processes)) and time.monotonic() < since + PATIENCE:
        time.sleep(0.05)
    return time.monotonic() - since


def runToTheFault(folder, command, fault, ranks):
    """Its end. Seconds are those since the last step before the fault was told."""
    env = environment(folder)
    if fault.signal:  # not for the address sanitizer, if there is one
        env["ASAN_OPTIONS"] = env.get("ASAN_OPTIONS", "") + ":handle_segv=0"
    process = subprocess.Popen(command, cwd=folder, env=env, text=True,
                               errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    watch = threading.Timer(PATIENCE, process.terminate)  # mpirun then ends its ranks
    watch.start()
    lines, since, all_, victim = [], time.monotonic(), [], None
    for line in process.stdout:
        lines.append(line)
        told = re.match(r"t = (\S+) s", line)
        if told and float(told[1]) < FAULT + 0.5*STEP:
            since = time.monotonic()
            all_ = all_ or descendants(process.pid)
        elif told and fault.signal and not victim:
            victim = rankProcesses(process.pid, ranks)[-1]
            since = time.monotonic()
            os.kill(victim, fault.signal)
    code = process.wait()
    seconds = gone(all_, since)
    watch.cancel()
    text = "".join(lines)
    (folder/"log").write_text(text)
    return End(code, text, seconds, [one for one in all_ if alive(one)])


def states(folder, ranks):
    """Times of which every rank has its fields, and some the powder, all of numbers. A rank without
    a grain writes none."""
    parts = [folder/f"processor{i}" for i in range(ranks)] if ranks > 1 else [folder]
    found = []
    for path in parts[0].iterdir():
        if not re.fullmatch(r"[0-9.e-]+", path.name) or float(path.name) == 0:
            continue
        fields = [part/path.name/name for part in parts for name in ("U", "p", "voidFraction")]
        grains = [file for part in parts for file in (part/path.name).glob("lagrangian/*/U")]
        whole = all(file.is_file() for file in fields) and grains
        if whole and not any(re.search(r"\b(nan|inf)\b", file.read_text())
                             for file in fields + grains):
            found.append(float(path.name))
    return found


def judge(bench, case, fault, end):
    run = Timed(case, end.seconds)
    bench.atMost(run, "seconds from the fault to the end", LIMIT, end.seconds)
    bench.equal(run, "processes left", 0, len(end.left), 0)
    bench.equal(run, "exit code is zero", 0, end.code == 0, 0)
    if bench.ranks > 1 or not fault.signal:
        missing = [word for word in fault.words if word not in end.text]
        bench.equal(run, "words missing from the message", 0, len(missing), 0)
    if fault.state:
        found = states(bench.folder(case), bench.ranks)
        bench.equal(run, "whole states on disk", 1, len(found), 0)
        bench.equal(run, "time of the last state [s]", FAULT + STEP,
                    found[-1] if found else math.inf, 1.01*STEP)


def verify(bench):
    solver = [bench.solver]
    if bench.ranks > 1:
        solver = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(bench.ranks),
                  bench.solver, "-parallel"]
    for fault in FAULTS:
        case = blown(fault, bench.ranks)
        folder = bench.folder(case)
        case.write(folder, bench.ranks)
        execute(folder, ["blockMesh"], "log.blockMesh")
        if bench.ranks > 1:
            execute(folder, ["decomposePar"], "log.decomposePar")
        judge(bench, case, fault, 
              runToTheFault(folder, solver, fault, bench.ranks))


if __name__ == "__main__":
    main(verify)
