# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels appear in, and vanish from, a closed box of air in the middle of a run: a hopper is filled
up, spilled powder is swept away. From one step to the next the powder takes up other room, and air that
cannot be compressed has nowhere to go.

The room that is gained or lost must be that of the parcels, to round-off, and the air must take it as
if every cell had its share: air that comes into a cell, and void that is opened there, differ by the
cell's part of it and by no more. That moves air for one step, as a source of the volume V does that
goes out through the faces of a block of 2 x 2 x 2 cells, where a parcel is seen: u = V/(24 dx^2 dt),
the volume that of all of them. Nowhere may the air be quicker than three times that, then and in the
ten steps that follow, nor in these quicker than then. What vanished is counted as lost, and missing;
what appeared is missing mass below zero.
"""
import copy
import math

from hardCase import (GRAVITY, Box, Case, Powder, cellVolume, change, grainVolume, lattice, main,
                      measured, mostIterations, outflow, run as runCase, steps, table)

from H05ClosedBox import CONTACTS, WALL

CELL = 0.5e-3  # [m]
CELLS = (8, 8, 12)
STEP, SUB_STEPS = 1e-4, 20  # coupling step [s], DEM steps in it
EVENT = 20  # coupling step after which parcels appear, or in which the first could vanish
AFTER = 10
APPEAR = (1, 6)
VANISH = 4
POWDER = Powder()
K = 8

MEASURES = """    powderBalance { type powderBalance; }
    opened
    {
        type            volFieldValue;
        libs            (fieldFunctionObjects);
        operation       volIntegrate;
        fields          (ddtVoidFraction);
        writeFields     no;
        log             no;
    }
"""
INSERTION = """
fix     kind all particletemplate/sphere 15485863 atom_type 1 density constant {density} &
        radius constant {radius:.15g}
fix     mixture all particledistribution/discrete 32452843 1 kind 1.0
region  above block 0.5e-3 3.5e-3 0.5e-3 3.5e-3 4e-3 5.5e-3 units box
fix     filling all insert/pack seed 49979687 distributiontemplate mixture insert_every once &
        start {step} overlapcheck yes all_in yes particles_in_region {count} region above
"""
SWEEP = """
fix     plane all mesh/surface file plane.stl type 1
fix     sweep all massflow/mesh mesh plane count once vec_side 0 0 -1 delete_atoms yes
"""


def falling(name, commands):
    """Three layers of parcels that fall in a box that is closed on all sides."""
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("noSlip", "noSlip", "noSlip"))
    case = Case(name, box, POWDER, k=K, gravity=(0, 0, -GRAVITY), deltaT=STEP, subSteps=SUB_STEPS,
                endTime=(EVENT + 3*AFTER)*STEP, writeInterval=STEP)
    case.positions = lattice(box, 1, (3, 6))
    walls = "".join(WALL.format(axis, side, side*length)
                    for axis, length in zip("xyz", box.size) for side in (0, 1))
    change(case, "powder.in", "neigh_modify    delay 0 exclude group all all",
           "neigh_modify    delay 0\n" + CONTACTS + walls + commands)
    # A checkpoint sets LIGGGHTS up anew, and massflow/mesh then forgets who was on which side.
    change(case, "constant/couplingProperties", "walls off;", "walls off; checkpoints off;")
    return measured(case, MEASURES)


def appearing(count):
    diameter = K*POWDER.diameter
    return falling(f"{count} appear", INSERTION.format(
        density=POWDER.density, radius=diameter/2, step=EVENT*SUB_STEPS, count=count))


def vanishing():
    """Four parcels fall through a mesh that takes them away."""
    case = falling(f"{VANISH} vanish", SWEEP)
    lowest = min(z for _, _, z in case.positions)
    height = lowest - 0.5*GRAVITY*(EVENT*STEP)**2
    write = case.write

    def withPlane(folder, ranks):
        write(folder, ranks)
        (folder/"plane.stl").write_text(square(2*CELL, 4*CELL, height))
    case.write = withPlane
    return case


def square(low, high, z):
    corners = [(low, low), (high, low), (high, high), (low, high)]
    facets = "".join(
        "facet normal 0 0 1\n outer loop\n"
        + "".join(f"  vertex {x:.15g} {y:.15g} {z:.15g}\n" for x, y in (corners[i] for i in three))
        + " endloop\nendfacet\n" for three in ((0, 1, 2), (0, 2, 3)))
    return f"solid plane\n{facets}endsolid plane\n"


def unevenness(run, time, source):
    """Largest of any cell: what does not match in it, off its share of the source [m3/s], of the air
    that passes."""
    then = copy.copy(run)
    then.times = lambda: [time]
    net, gross = outflow(then)
    opened = [cellVolume(run)*rate for rate in run.field("ddtVoidFraction", time)]
    share = source/len(net)
    return max(abs(a + b - share) for a, b in zip(net, opened))/max(gross)


def judge(bench, run, parcels):
    """`parcels`: that appear in the run; below zero: that vanish."""
    volume = math.pi/6*run.case.diameter**3*parcels
    opened = [rate*STEP for _, rate in table(run, "opened")]
    powder = grainVolume(run.case)
    changes = [n for n, gain in enumerate(opened) if abs(gain) > 1e-9*powder]
    bench.equal(run, "steps with a source", 1, len(changes), 0)
    event, = changes[:1] or [0]
    bench.near(run, "void that opens in it [m3]", -volume, opened[event], 1e-12)
    bench.atMost(run, "in the other steps, of the powder", 1e-14,
                 max(abs(gain) for n, gain in enumerate(opened) if n != event)/powder)
    bench.atMost(run, "cells off their share, of the flux", 1e-8,
                 unevenness(run, run.times()[event], -volume/STEP))
    judgeCalm(bench, run, event, abs(volume))
    judgeCount(bench, run, parcels)


def judgeCalm(bench, run, event, volume):
    taken = steps(run)
    bench.equal(run, "steps that the run took", EVENT + 3*AFTER, len(taken), 0)
    estimate = volume/(24*CELL**2*STEP)
    speeds = [step.speed for step in taken[event:event + AFTER + 1]]
    bench.equal(run, "steps from it on, looked at", AFTER + 1, len(speeds), 0)
    bench.atMost(run, "air in it, of the displaced", 3, speeds[0]/estimate)
    bench.atMost(run, "in the next ten steps, of it", 1, max(speeds[1:])/speeds[0])
    bench.report(run, "after ten steps, of it", 0.1, speeds[-1]/speeds[0])
    bench.atMost(run, "iterations of the pressure", 99, mostIterations(run))


def judgeCount(bench, run, parcels):
    rows = table(run, "powderBalance")
    mass = math.pi/6*run.case.diameter**3*POWDER.density
    bench.equal(run, "parcels at the end", len(run.case.positions) + parcels, rows[-1][6], 0)
    bench.near(run, "mass missing at the end [kg]", -parcels*mass, rows[-1][5], 1e-12)
    bench.equal(run, "counted as lost", max(-parcels, 0), rows[-1][8], 0)


def verify(bench):
    for count in APPEAR:
        judge(bench, bench.run(appearing(count), impulse=math.inf), count)
    case = vanishing()
    judge(bench, runCase(case, bench.folder(case), bench.ranks, bench.solver), -VANISH)


if __name__ == "__main__":
    main(verify)
