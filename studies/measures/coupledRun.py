# SPDX-License-Identifier: GPL-3.0-or-later
"""What demPimpleFoam wrote of a run, as the `measure` of a case tells it: tables of its function objects,
the balance of the powder, and the line on screen of each coupling step."""
import json
import math
import re
import sys

import runTables

STEPS = {
    "peakAirSpeed": dict(unit="m/s", symbol="u_max", text="highest air speed"),
    "maxCourant": dict(unit="1", symbol="Co", text="highest Courant number of the air"),
    "meanDt": dict(unit="s", symbol="dt", text="mean coupling step"),
    "responseBound": dict(unit="1", shown="%", symbol="", text="share of the coupling steps that the "
                                                               "powder's response time limits"),
    "pressureIterations": dict(unit="1", symbol="", text="mean number of pressure iterations"),
}
BALANCE = {
    "massMissing": dict(unit="1", symbol="", text="largest mass that is missing, of all"),
    "parcelsLost": dict(unit="1", symbol="", text="parcels lost"),
    "clippedVolume": dict(unit="m3", symbol="", text="largest powder volume hidden from the air by "
                                                     "full cells"),
    "hiddenVolume": dict(unit="m3", symbol="", text="largest powder volume inside solids"),
    "momentumRemainder": dict(unit="1", symbol="", text="largest momentum that waits to be given to "
                                                        "the air, of a step's largest drag impulse"),
}
STEP = re.compile(r"^t = (\S+) s .* dt (\S+) s \(([^,)]+),")
AIR = re.compile(r"air max (\S+) m/s, Co (\S+), p iterations (\d+)")


def table(case, name, *columns):
    """Rows of the wanted columns, time first; the columns by their headings, without units."""
    pattern = f"{name}/*/{name}.dat"
    path = next((path for _, path in runTables.files(case, pattern)), None)
    if path is None:
        return []
    with open(path) as file:
        heads = [head.strip("# ").split(" [")[0] for head in file.readline().split("\t")]
    wanted = [0] + [heads.index(column) for column in columns]
    return [[float(row[column]) for column in wanted] for row in runTables.joined(case, pattern)]


def balance(case):
    vector = lambda name: [name + axis for axis in "XYZ"]
    rows = table(case, "powderBalance", "massAtStart", "massMissing", "lost", "clippedVolume",
                 "hiddenVolume", *vector("momentumRemainder"), *vector("dragImpulse"))
    if not rows:
        return {}
    impulse = max(math.hypot(*row[9:12]) for row in rows)
    found = {"massMissing": max(abs(row[2]) for row in rows)/rows[0][1],
             "parcelsLost": max(row[3] for row in rows), "clippedVolume": max(row[4] for row in rows),
             "hiddenVolume": max(row[5] for row in rows)}
    if impulse > 0:
        found["momentumRemainder"] = max(math.hypot(*row[6:9]) for row in rows)/impulse
    return found


def steps(case):
    """From the solver's line for each coupling step; one that a resumed run made again counts once."""
    path = case/"log.demPimpleFoam"
    taken = {}
    for line in path.read_text(errors="replace").splitlines() if path.is_file() else ():
        step = STEP.match(line)
        if step:
            air = AIR.search(line)
            taken[float(step[1])] = (float(step[2]), step[3],
                                     [float(word) for word in air.groups()] if air else None)
    if not taken:
        return {}
    some = taken.values()
    found = {"meanDt": sum(step[0] for step in some)/len(taken),
             "responseBound": sum(step[1] == "powder response" for step in some)/len(taken)}
    air = [step[2] for step in some if step[2]]
    if air:
        found.update(peakAirSpeed=max(x[0] for x in air), maxCourant=max(x[1] for x in air),
                     pressureIterations=sum(x[2] for x in air)/len(air))
    return found


def tell(listed, measured):
    """The whole of `measure`: what the names mean, or what `measured()` found, null if it is not there."""
    if "-list" in sys.argv:
        print(json.dumps(listed, indent=1))
        return
    found = measured()
    finite = lambda value: float(value) if value is not None and math.isfinite(value) else None
    print(json.dumps({name: finite(found.get(name)) for name in listed}, indent=1))
