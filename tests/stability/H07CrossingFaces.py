# SPDX-License-Identifier: GPL-3.0-or-later
"""One parcel flies through air at rest and crosses face after face of the mesh. Where cells see it by
its centre, all its volume V enters a cell within one step: the air leaves at V/(6 dx^2 dt), which for a
parcel of 400 um in cells of 600 um is 1.5 m/s at a step of 10 us, however slowly it flies.

What air must do is make way. A parcel that is a blunt cloud on the mesh, with solids share s at most
(read from the void fraction), is to the air what a dielectric sphere is to a field: in it, the air flows
back at s v/(3 alpha). Air without viscosity must not exceed this by more than 0.05 v, nor show a pressure
of 1 % of the 433 Pa below the sealed plug (A.11). In real air the parcel, of hundreds of grains, takes
along the air of its cells: then the bound is its own speed besides.
"""
import math

from hardCase import (Air, Box, Case, Powder, main, measured, run as runCase, steps, table,
                      volumeError)

CELL = 0.4e-3  # [m]
CELLS = (8, 8, 20)
SPEED = 0.1  # of the parcel [m/s]
STEP = 1e-4  # [s]; 40 steps from face to face
COUNT = 80
EXTREMES = """    extremes
    {
        type        fieldMinMax;
        libs        (fieldFunctionObjects);
        location    no;
        fields      (p voidFraction);
        log         no;
    }"""
PLUG = 433.14  # [Pa]
K = 10
PARCELS = ((0.7, 0), (2, 2))  # diameter and smoothing width, in cells


def flight(name, size, air, lawName, smoothing, place=(0.5, 0.5), **options):
    """size: of the parcel, in cells. place: where its path runs within a cell."""
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("noSlip", "noSlip", ("noSlip", "outlet")))
    powder = Powder(size*CELL/K, 7360.0, air)
    start = ((3 + place[0])*CELL, (3 + place[1])*CELL, 6.13*CELL)
    case = Case(name, box, powder, k=K, positions=[start], velocity=(0, 0, SPEED),
                lawName=lawName, smoothingWidth=smoothing*CELL, deltaT=STEP,
                endTime=COUNT*STEP, writeInterval=10*STEP, timeStep="stabilityLimit 1e9;", **options)
    return measured(case, EXTREMES)


def extremes(run):
    """Over all steps: fastest air [m/s], largest pressure [Pa] and most powder in a cell."""
    rows = table(run, "extremes")
    assert len(rows) == COUNT
    return (max(step.speed for step in steps(run)),
            run.case.powder.air.density*max(abs(p) for row in rows for p in row[1:3]),
            1 - min(row[3] for row in rows))


def bound(solids):
    """Of the air's speed, over the parcel's: displacement flow and 0.05."""
    return solids/(3*(1 - solids)) + 0.05


def judge(bench, case, carried):
    """carried: what drag may give to the air, of the parcel's speed."""
    run = bench.run(case, impulse=math.inf)
    speed, pressure, solids = extremes(run)
    bench.atMost(run, "fastest air, of the parcel's speed", carried + bound(solids), speed/SPEED)
    bench.atMost(run, "pressure, of that below the plug", 0.01, pressure/PLUG)
    bench.atMost(run, "powder on the mesh less of all", 1e-12,
                 max(abs(volumeError(run, t)) for t in run.times()))


def verify(bench):
    inviscid = Air(viscosity=1e-12)
    for size, smoothing in PARCELS:
        for place in ((0.5, 0.5), (0.0, 0.0)):
            name = f"{size:g} dx, along {'centres' if place[0] else 'edges'}"
            judge(bench, flight(name, size, inviscid, "Stokes", smoothing, place), carried=0)
        judge(bench, flight(f"{size:g} dx, drag", size, Air(), "GidaspowHuilin", smoothing),
              carried=1)

        case = flight(f"{size:g} dx, by centres", size, inviscid, "Stokes", smoothing,
                      deposit="centre")
        run = runCase(case, bench.folder(case), bench.ranks, bench.solver)
        speed, _, solids = extremes(run)
        bench.atLeast(run, "must fail: fastest air, of the bound", 3, speed/SPEED/bound(solids))


if __name__ == "__main__":
    main(verify)
