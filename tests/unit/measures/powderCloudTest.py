#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the solver on grains that fly straight and looks for each of them in what OpenFOAM's own
utilities make of the cloud it wrote: reconstructPar's fields and foamToVTK's files.

usage: powderCloudTest.py <case> <copy> <demPimpleFoam> <mpiexec> <ranks> <on|off>

The last word: with or without air. Without air a grain is where x0 + v t says (flight.in).
"""
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

GRAINS = 120
FINAL = 4e-4  # s, and written as 0.0004


def start(n):
    return ((n % 10 + 1.5)*1e-3, (n//10 % 4 + 2.5)*1e-3, (n//40 + 1.5)*1e-3)


def speed(n):
    return (3, 0, 2) if n % 2 else (0, -3, 0)


def command(log, *words):
    with open(log, "w") as file:
        code = subprocess.run(words, stdout=file, stderr=subprocess.STDOUT).returncode
    if code:
        sys.exit(f"{' '.join(words)} ended with {code}:\n" + Path(log).read_text()[-3000:])


def run(case, copy, solver, mpiexec, ranks, air):
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(case, copy)
    os.chdir(copy)
    coupling = Path("constant/couplingProperties")
    coupling.write_text(coupling.read_text().replace("AIR", air))
    command("log.blockMesh", "blockMesh")
    if ranks == 1:
        command("log.demPimpleFoam", mpiexec, "-np", "1", solver)
    else:
        Path("system/decomposeParDict").write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
            f"numberOfSubdomains {ranks}; method simple;\n"
            f"simpleCoeffs {{ n (1 1 {ranks}); delta 0.001; }}\n")
        command("log.decomposePar", "decomposePar")
        command("log.demPimpleFoam", mpiexec, "--oversubscribe", "--bind-to", "none", "-np",
                str(ranks), solver, "-parallel")
        command("log.reconstructPar", "reconstructPar")
    command("log.foamToVTK", "foamToVTK", "-ascii")


def foamList(path):
    """The entries of an IOField, each a tuple of its numbers."""
    text = Path(path).read_text().split("* //", 1)[1]
    count, opening, body = re.match(r"\s*(\d+)\s*([({])(.*?)\n?[)}]\n\n", text, re.S).groups()
    rows = [tuple(map(float, re.findall(r"[-+.\de]+", line))) for line in body.strip().split("\n")]
    if opening == "{":  # one value for all
        rows *= int(count)
    assert len(rows) == int(count), f"{path}: {len(rows)} rows, {count} said"
    return rows


def vtkArrays(path):
    arrays = {}
    for node in xml.parse(path).iter("DataArray"):
        size = int(node.get("NumberOfComponents", "1"))
        numbers = [float(word) for word in node.text.split()]
        arrays[node.get("Name")] = list(zip(*[iter(numbers)]*size))
    return arrays


def complaints(where, ids, positions, fields, air):
    if sorted(ids) != list(range(1, GRAINS + 1)):
        yield f"{where}: ids {sorted(ids)}, wanted 1 to {GRAINS}"
        return
    for row, n in enumerate(ids):
        at = [x + v*FINAL for x, v in zip(start(n), speed(n))]
        # Air holds the smallest grain (response time 8 ms) back by v t^2/(2 tau) = 3e-5 m. The last
        # digits of a VTK file are round-off.
        slack = 5e-5 if air else 2e-8
        if max(abs(a - b) for a, b in zip(positions[row], at)) > slack:
            yield f"{where}: grain {n} at {positions[row][:3]}, wanted {at}"
        if abs(fields["d"][row][0] - (40 + n)*1e-6) > 1e-12:
            yield f"{where}: grain {n} has a diameter of {fields['d'][row][0]} m"
        against = sum(f*v for f, v in zip(fields["drag"][row], speed(n)))
        if (against < 0) != air or (not air and any(fields["drag"][row])):
            yield f"{where}: drag {fields['drag'][row]} on grain {n} with air {air}"


def check(air):
    folder = Path("0.0004/lagrangian/powder")
    fields = {name: foamList(folder/name) for name in ("d", "drag", "id", "origId", "positions")}
    ids = [int(row[0]) for row in fields["id"]]
    if ids != [int(row[0]) for row in fields["origId"]]:
        yield "id and origId differ"
    yield from complaints("reconstructed", ids, fields["positions"], fields, air)

    files = sorted(Path("VTK/lagrangian/powder").glob("*.vtp"))
    if len(files) != 2:
        yield f"{len(files)} files of powder in VTK, wanted one a write time"
        return
    arrays = vtkArrays(files[-1])
    yield from complaints(
        "VTK", [int(row[0]) for row in arrays["id"]], arrays["Points"], arrays, air)


def main():
    case, copy, solver, mpiexec, ranks, air = sys.argv[1:]
    run(case, Path(copy), solver, mpiexec, int(ranks), air)
    found = list(check(air == "on"))
    print("\n".join(found[:20]) or "every grain is where it belongs")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
