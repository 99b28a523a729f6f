# SPDX-License-Identifier: GPL-3.0-or-later
"""The folders of runs that a study kept (`keep: yes`), and what stands in them at some instants."""
import csv
import json
import subprocess
from pathlib import Path

import runFolder
from badInput import BadInput
from tableFile import number

WHERE = "VTK/sections"  # in a run's folder; the next run there removes it
FIELDS = "(U vorticity voidFraction solid)"


def found(table, chosen, study):
    """[(parameters, folder)] of the chosen rows, packings in their order."""
    folder = chosen.table.resolve().parent
    missing = f"the study {study} with 'keep: yes' keeps what is needed."
    try:
        plan = json.loads((folder/"plan.json").read_text())
        with open(folder/"runs.csv", newline="") as file:
            runs = list(csv.DictReader(file))
    except (OSError, ValueError):
        raise BadInput(f"there is no whole plan.json and runs.csv beside {table.name}; {missing}")
    wanted = {row["variant"] for row in table.chosen(chosen.where)}
    homes = [(run, Path(plan["case"])/f"variants/{plan['study']}.{run['id']}") for run in runs
             if run["status"] == "ok" and run["variant"] in wanted]
    kept = [({key: number(value) for key, value in run.items()}, home) for run, home in homes
            if home.is_dir()]
    if not kept:
        raise BadInput(f"no folder of a run of {table.name} is kept; {missing}")
    return kept


def differing(one, other):
    """Parameters in which two runs differ, beside the packing."""
    keys = list(one)
    keys = keys[keys.index("variant") + 1:keys.index("status")]
    return [key for key in keys if one[key] != other[key] and key not in ("seed", "packing")]


def times(home):
    """Names of the instants that were kept, the start left out."""
    return sorted((path.name for path in first(home).iterdir() if isTime(path.name)), key=float)


def first(home):
    """The folder itself, or that of the first rank if the run is not put together."""
    return next(iter(ranks(home)), home)


def ranks(home):
    return sorted(home.glob("processor[0-9]*"))


def isTime(name):
    try:
        return float(name) > 0
    except ValueError:
        return False


def converted(home, names):
    """Files of cells and parcels at these instants, in their order; made if they are not there."""
    there = convertedBefore(home)
    if any(timeIn(there, name) is None for name in names):
        convert(home, names)
        there = convertedBefore(home)
    files = [timeIn(there, name) for name in names]
    if None in files:
        raise BadInput(f"OpenFOAM found no air or no powder at {names[files.index(None)]} s in {home}: "
                       "run that variant again.")
    return files


def convertedBefore(home):
    return {runFolder.timeOf(air): (air, powder)
            for air, powder in runFolder.instants(home, WHERE)}


def timeIn(there, name):
    """VTK has the time in single precision."""
    return next((files for time, files in there.items()
                 if abs(time - float(name)) < 1e-5*float(name)), None)


def convert(home, names):
    """By OpenFOAM's own programs: ranks put together, curl of the air's velocity, VTK as text."""
    when = ",".join(names)
    commands = [["postProcess", "-func", "vorticity", "-time", when],
                ["foamToVTK", "-legacy", "-ascii", "-no-boundary", "-overwrite", "-name", WHERE,
                 "-fields", FIELDS, "-time", when]]
    if any(not (home/name/"U").is_file() for name in names):
        commands.insert(0, ["reconstructPar", "-time", when])
    environment = next(folder for folder in Path(__file__).resolve().parents
                       if (folder/"cmake/environment.sh").is_file())/"cmake/environment.sh"
    for words in commands:
        log = home/f"log.{words[0]}"
        with open(log, "w") as file:
            status = subprocess.run(["bash", "-c", 'source "$1" && shift && exec "$@"', "bash",
                                     environment, *words], cwd=home, stdin=subprocess.DEVNULL,
                                    stdout=file, stderr=file).returncode
        if status:
            raise BadInput(f"{words[0]} failed in {home}: see {log.name} there.")
