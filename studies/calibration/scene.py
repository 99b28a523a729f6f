# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scenes of the calibration (heap, drum) have in common: what LIGGGHTS is told, and what it
wrote."""
import re
import shutil
import subprocess
import sys

import numpy as np

COLUMNS = ["id", "type", "x", "y", "z", "vx", "vy", "vz", "radius"]


def common(p):
    """What both scripts want besides the parameters: one material, one grain a parcel."""
    return {"coarseGraining": 1, "boundaryY": "p", "wallYoungsModulus": p["youngsModulus"],
            "wallRestitution": p["restitution"],
            "halfSlice": 0.5*whole(p, "sliceDiameters")*p["particleDiameter"]}


def whole(p, key):
    if p[key] != int(p[key]) or p[key] < 4:
        sys.exit(f"{key} in system/caseParameters must be a whole number from 4:\n"
                 f"    found   {p[key]:g}\n"
                 "A thinner slice would meet itself through its periodic sides.")
    return int(p[key])


def writeParameters(case, values):
    """preparation/parameters.in, which the script includes."""
    lines = ["# Written by prepare from system/caseParameters: change that file."]
    for key, value in values.items():
        word = f"{value:.12g}" if isinstance(value, (int, float)) else value
        lines.append(f"variable        {key} index {word}")
    (case/"preparation").mkdir(exist_ok=True)
    (case/"preparation/parameters.in").write_text("\n".join(lines) + "\n")


def main(case, root, script, words):
    """The script `run` of a scene."""
    if words[1:] not in ([], ["-np", "1"]):
        sys.exit(f"usage: {words[0]} [-np 1]\nThis case runs on one rank: LIGGGHTS would pour in another "
                 "number of parcels on more.")
    if subprocess.run([case/"prepare"]).returncode:
        sys.exit(1)
    shutil.rmtree(case/"postProcessing", ignore_errors=True)
    (case/"postProcessing").mkdir()
    run(case, root, script)


def run(case, root, script):
    """LIGGGHTS on one rank; ends the program if it fails or if parcels are missing."""
    log = case/f"log.{script}"
    # Line by line: what LIGGGHTS says of an error would be lost in a buffer when it aborts.
    command = ["stdbuf", "-oL", "liggghts", "-in", str(root/f"liggghts_scripts/{script}.in"), "-log",
               "none", "-var", "case", str(case), "-var", "scripts", str(root/"liggghts_scripts")]
    with open(log, "w") as screen:
        code = subprocess.run(command, cwd=case, stdout=screen, stderr=screen).returncode
    text = log.read_text(errors="replace")
    if code:
        sys.exit("\n".join(text.splitlines()[-20:]) + f"\nliggghts failed: see {log}")
    asked, poured = map(int, re.search(r"^parcels asked for: (\d+), poured: (\d+)$", text,
                                       re.M).groups())
    if poured < asked:
        sys.exit("ERROR: There was no room for all parcels.\n"
                 f"    wanted  {asked}\n    poured  {poured}\n"
                 "Take fewer, or a larger box or drum.")
    print(f"parcels: {poured}")


def dump(path):
    """Particles of a dump, as columns by name; the glued ones, type 2, as well."""
    rows = np.loadtxt(path, skiprows=9, ndmin=2)
    return dict(zip(COLUMNS, rows.T))


def powder(path):
    """The same without the glued ones."""
    all_ = dump(path)
    return {key: column[all_["type"] == 1] for key, column in all_.items()}


def frames(case, name):
    """Dumps postProcessing/name.STEP.dump in the order of their steps."""
    step = lambda path: int(path.name.split(".")[1])
    return sorted((case/"postProcessing").glob(f"{name}.*.dump"), key=step)
