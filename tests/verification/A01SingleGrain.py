# SPDX-License-Identifier: GPL-3.0-or-later
"""A lone grain falls from rest, against the exact path of a grain in air that it does not disturb.

a  MFiX DEM06: box, mesh and numbers of that verification case. In the box the grain drags the air
   of its own cell along and so falls faster; that error of the method grows with d over the size
   of the cell (MFiX publishes 4.13 % for values of the cell alone, 0.56 to 2.25 % for wider
   kernels). In a room so large that the air stays as it is, nothing but the drag is left.
b  the settling test of CFDEMcoupling: 0.1 m cube, 10^3 cells.
c  the powder of the die filling study as grains and as parcels of 1000 grains: the same fall.
"""
import math

from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, Powder, gidaspowHuilin, schillerNaumann, stokes

UNDISTURBED = 1e-3
IN_THE_BOX = 1e-2
SETTLING = 5e-3
COARSE = 1e-3

# Downward velocity [m/s] by time [s].
MFIX = {0.01: 0.012553, 0.10: 0.052631, 0.20: 0.057010, 0.35: 0.057393}
MFIX_BLEND = {0.01: 0.012919, 0.10: 0.054290, 0.20: 0.058841, 0.35: 0.059241}
SETTLING_TABLE = {
    "Stokes": {0.01: 0.073523, 0.02: 0.113874, 0.05: 0.154842, 0.1: 0.162551, 0.2: 0.162954},
    "SchillerNaumann": {0.01: 0.071654, 0.02: 0.106809, 0.05: 0.134424, 0.1: 0.137281,
                        0.2: 0.137337},
    "GidaspowHuilin": {0.01: 0.071774, 0.02: 0.107119, 0.05: 0.135031, 0.1: 0.137948,
                       0.2: 0.138007}}
SEED = {0.005: 0.04577, 0.010: 0.08541, 0.020: 0.14893, 0.050: 0.25422, 0.100: 0.30541}
LAWS = {"Stokes": stokes, "SchillerNaumann": schillerNaumann, "GidaspowHuilin": gidaspowHuilin}


def velocity(run, time):
    mass = math.pi/6*run.case.diameter**3*run.case.powder.density
    return next(-ofPowder[2]/mass for t, _, ofPowder, _ in run.budget() if abs(t - time) < 1e-9)


def grain(name, box, powder, law, position, **options):
    pull = (0, 0, -powder.gravity)
    return Case(name, box, powder, lawName=law, gravity=pull, airGravity=pull,
                positions=[position], **options)


def weight(case):
    return math.pi/6*case.diameter**3*case.powder.density*case.powder.gravity


def fall(bench, case, table, tolerance):
    run = bench.run(case, impulse=weight(case)*case.deltaT)
    exact = case.powder.fall(table.keys(), upward=case.U[2])
    for time, expected in table.items():
        # The table is rounded, and so confirms the path that it is compared with.
        assert abs(-exact[time][1] - expected) < 1e-5
        bench.near(run, f"velocity at {time:g} s [m/s]", -exact[time][1], velocity(run, time),
                   tolerance)
    points = run.budget()[::max(1, len(run.budget())//25)]
    path = case.powder.fall([t for t, *_ in points], upward=case.U[2], steps=400)
    bench.curve(case.name, "t [s]", "falling at [m/s]", [(0, 0), *((t, -v) for t, (_, v) in path.items())],
                [(t, velocity(run, t)) for t, *_ in points])
    return run


def mfix(name, law, cells, size, **options):
    powder = Powder(100e-6, 2000.0, Air(1.2, 1.8e-5), LAWS[law], gravity=9.80665)
    box = Box(size, cells, ("slip", "slip", ("inlet", "outlet")))
    settings = dict(U=(0, 0, 0.40), deltaT=1e-3, subSteps=8, endTime=0.35)
    settings.update(options)
    return grain(name, box, powder, law, (size[0]/2, size[1]/2, 0.925*size[2]), **settings)


def verify(bench):
    inBox(bench)
    settling(bench, SETTLING_TABLE if bench.ranks == 1 else ["SchillerNaumann"])
    if bench.ranks == 1:
        inRoom(bench)
        parcels(bench)


def inRoom(bench):
    for law, table in (("SchillerNaumann", MFIX), ("GidaspowHuilin", MFIX_BLEND)):
        fall(bench, mfix(f"a room, {law}", law, (5, 5, 5), (1.0, 1.0, 1.0), deltaT=5e-4), table,
             UNDISTURBED)


def inBox(bench):
    small, cells = (0.01, 0.01, 0.10), (5, 5, 20)
    fall(bench, mfix("a box, smoothed", "SchillerNaumann", cells, small, smoothingWidth=0.004),
         MFIX, IN_THE_BOX)
    for deposit in ("kernel", "centre"):
        case = mfix(f"a box, {deposit}", "SchillerNaumann", cells, small, deposit=deposit)
        run = bench.run(case, impulse=weight(case)*case.deltaT)
        bench.report(run, "velocity at 0.35 s [m/s]", MFIX[0.35], velocity(run, 0.35))


def settling(bench, laws):
    air = Air(10.0, 1e-4)
    cube = Box((0.1, 0.1, 0.1), (10, 10, 10), ("periodic", "periodic", ("noSlip", "outlet")))
    for law in laws:
        case = grain(f"b {law}", cube, Powder(100e-6, 3000.0, air, LAWS[law]), law,
                     (0.045, 0.052, 0.085), deltaT=1e-3, subSteps=100, endTime=0.2)
        fall(bench, case, SETTLING_TABLE[law], SETTLING)


def parcels(bench):
    room = Box((2.0, 2.0, 2.0), (5, 5, 5), ("periodic", "periodic", ("noSlip", "outlet")))
    grains, ofThousand = [
        fall(bench, grain(f"c k = {k}", room, Powder(), "GidaspowHuilin", (1.0, 1.0, 1.2), k=k,
                          deltaT=2.5e-4, subSteps=5, endTime=0.1), SEED, COARSE)
        for k in (1, 10)]
    for time in SEED:
        bench.near(ofThousand, f"as of grains, at {time:g} s", velocity(grains, time),
                   velocity(ofThousand, time), COARSE)


if __name__ == "__main__":
    main(verify)
