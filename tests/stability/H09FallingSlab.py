# SPDX-License-Identifier: GPL-3.0-or-later
"""A dense slab of powder falls through the lid of a box whose air has one way out: a hole of one cell
in that lid, which else stops the air and lets powder pass, as where a hopper stands above the air that
is computed. (In a box that holds the slab from the start nothing is displaced on the whole, and nothing
blows.) As much air must leave as powder comes in,

    jet = alpha_p v A_lid/A_hole

some 30 m/s through a hole as wide as a cell. The slab is one body, so that it comes in evenly: a parcel
is seen by the air all at once when its centre passes the lid. Before the pressure has slowed it, it
falls freely, and what it displaces by then is known beforehand.

The chosen time step must keep the Courant number below one at all times; one that is fixed at the
longest of those that were chosen must not. What has left through the hole must be the volume of the
powder in the box, its mass that of the slab, and its kinetic and potential energy never more than at
the start: the air has none but what it got from it.
"""
import bisect
import math
import re

from hardCase import (GRAVITY, Box, Case, Powder, change, main, measured, run as runCase, steps,
                      table)

CELL = 0.5e-3  # [m]
CELLS = (8, 8, 12)
HOLE = (4, 4)  # its cell in the lid
SIZE = tuple(n*CELL for n in CELLS)
LID = SIZE[2]
CEILING = 2.5*LID  # of the powder's box
SPEED = 1.0  # of the slab [m/s]
POWDER = Powder()
K = 5
ROWS, LAYERS = 16, 10  # of a body-centred lattice: parcels across, and above each other
WEDGE = 1e-3  # of the slab's lower side, from edge to edge [m]
GOLDEN = 0.6180339887
RECORD = 50  # DEM steps
END = 2.5e-3  # [s]
LONGEST = 2e-5  # time step [s]
FREELY = 5e-4  # it falls so long [s]
WHOLE = (1.2e-3, 1.6e-3)  # it reaches through all of the lid [s]
MARGIN = 0.05*CELL  # so close to the mesh a parcel is in it

MEASURES = """    powderBalance { type powderBalance; }
    jet
    {
        type            surfaceFieldValue;
        libs            (fieldFunctionObjects);
        regionType      patch;
        name            hole;
        operation       sum;
        fields          (alphaPhi);
        writeFields     no;
        log             no;
    }
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


class HoledBox(Case):
    """Closed on all sides, with an outlet as wide as a cell in its lid."""

    def boundaries(self):
        texts = super().boundaries()
        texts["velocities"] = """
    hole { type pressureInletOutletVelocity; value uniform (0 0 0); }
    ".*"  { type noSlip; }"""
        texts["pressures"] = """
    hole { type fixedValue; value uniform 0; }
    ".*"  { type zeroGradient; }"""
        return texts

    def write(self, folder, ranks):
        super().write(folder, ranks)
        path = folder/"system/blockMeshDict"
        head, _ = path.read_text().split("vertices")
        path.write_text(head + nineBlocks())


def nineBlocks():
    """The middle one below the hole."""
    parts = [(0, hole, hole + 1, n) for hole, n in zip(HOLE, CELLS)]
    corners = [(x*CELL, y*CELL, z) for z in (0, LID) for y in parts[1] for x in parts[0]]
    blocks, lid = [], []
    for j in range(3):
        for i in range(3):
            floor = [i + 4*j, i + 1 + 4*j, i + 5 + 4*j, i + 4 + 4*j]
            roof = [corner + 16 for corner in floor]
            counts = (parts[0][i + 1] - parts[0][i], parts[1][j + 1] - parts[1][j], CELLS[2])
            blocks.append(f"hex {bracket(floor + roof)} {bracket(counts)} simpleGrading (1 1 1)")
            lid.append(bracket(roof))
    hole = lid.pop(4)
    return (f"vertices {bracket(map(bracket, corners))};\nblocks {bracket(blocks)};\n"
            f"boundary ( hole {{ type patch; faces ({hole}); }}\n"
            f"lid {{ type wall; faces {bracket(lid)}; }} );\n"
            "defaultPatch { name walls; type wall; }\n")


def bracket(parts):
    return "(" + " ".join(map(str, parts)) + ")"


def slab():
    """Positions: with a slanting lower side, so that it comes in over a millisecond, and layers whose
    parcels come one after the other."""
    radius = K*POWDER.diameter/2
    step = (SIZE[0] - 2*radius)/(ROWS - 0.5)
    sites = [(radius + (i + half)*step, radius + (j + half)*step,
              LID - 1e-5 + (k + half + 0.5*((i + ROWS*j)*GOLDEN % 1))*step)
             for k in range(LAYERS) for half in (0, 0.5) for i in range(ROWS) for j in range(ROWS)]
    return [(x, y, z) for x, y, z in sites if z > LID - 2e-5 + WEDGE*(x - radius)/SIZE[0]]


def falling(name, fixed=None):
    """`fixed`: a time step that is not chosen [s]."""
    box = Box(SIZE, CELLS, ("noSlip", "noSlip", "noSlip"))
    case = HoledBox(name, box, POWDER, k=K, positions=slab(), motion="tied",
                    velocity=(0, 0, -SPEED), gravity=(0, 0, -GRAVITY), deltaT=fixed or 1e-6,
                    subSteps=round(1e6*fixed) if fixed else 1, adjustTimeStep=not fixed,
                    endTime=END, recordEvery=RECORD)
    change(case, "powder.data", f"0 {LID:.15g} zlo zhi", f"0 {CEILING:.15g} zlo zhi")
    change(case, "system/controlDict", "writeControl",
           f"maxCo 0.5;\nmaxDeltaT {LONGEST};\nwriteControl")
    return measured(case, MEASURES)


def courant(run):
    return max(float(x) for x in re.findall(r"m/s, Co (\S+), p iterations", run.log))


def parcel(run):
    return math.pi/6*run.case.diameter**3


def inside(run, places, under):
    """Volume of the parcels whose centres are lower [m3]."""
    return parcel(run)*sum(z < under for _, _, z in places)


def records(run):
    """Time, positions and velocity of the slab."""
    return [(t, [x for x, _ in grains.values()], grains[1][1][2])
            for t, grains in sorted(run.record().items())]


def expelled(run):
    """Volume of air that has left through the hole by time [m3]."""
    rows, before = [(0.0, 0.0)], 0.0
    for t, flux in table(run, "jet"):
        rows.append((t, rows[-1][1] + flux*(t - before)))
        before = t
    return rows


def at(rows, time):
    """Between two rows of a table."""
    n = min(max(bisect.bisect_left(rows, (time,)), 1), len(rows) - 1)
    (t0, a), (t1, b) = rows[n - 1:n + 1]
    return a + (b - a)*(time - t0)/(t1 - t0)


def judgeStep(bench, run):
    taken = steps(run)
    bench.atMost(run, "Courant number", 1, courant(run))
    bench.atLeast(run, "share of steps that it limits", 0.5,
                  sum(step.limit in ("Courant number", "growth") for step in taken)/len(taken))
    bench.atMost(run, "first step, of deltaT", 1, taken[0].dt/run.case.deltaT)
    bench.atLeast(run, "longest over shortest step after the first", 4,
                  max(s.dt for s in taken[1:])/min(s.dt for s in taken[1:]))


def judgeJet(bench, run):
    left, frames = expelled(run), records(run)
    started = inside(run, frames[0][1], LID)
    fallen = SPEED*FREELY + 0.5*GRAVITY*FREELY**2
    freely = inside(run, run.case.positions, LID + MARGIN + fallen) - started
    bench.near(run, "air driven out by free fall [m3]", freely, at(left, FREELY), 1e-2)
    off = max(abs(at(left, t) - inside(run, places, LID + MARGIN) + started)
              for t, places, _ in frames[1:])
    bench.atMost(run, "driven out and come in, of all", 2e-3,
                 off/(parcel(run)*len(run.case.positions)))

    first, last = WHOLE
    speeds = [-v for t, _, v in frames if first <= t <= last]
    layers = 2*parcel(run)*ROWS**2/((SIZE[0] - run.case.diameter)/(ROWS - 0.5))
    expected = layers*sum(speeds)/len(speeds)/CELL**2
    mean = (at(left, last) - at(left, first))/(last - first)/CELL**2
    bench.near(run, "jet, mean of 0.4 ms [m/s]", expected, mean, 2e-2)
    bench.atLeast(run, "jet, at least [m/s]", 20, mean)


def judgeBalances(bench, run):
    flux, opened = table(run, "jet"), table(run, "opened")
    bench.atMost(run, "air out and void closed, of the most", 1e-8,
                 max(abs(a[1] + b[1]) for a, b in zip(flux, opened))/max(row[1] for row in flux))
    balance = table(run, "powderBalance")
    bench.atMost(run, "mass missing, of all", 1e-12, max(abs(row[5]) for row in balance)/balance[0][4])
    energy = [0.5*v*v + GRAVITY*sum(z for _, _, z in places)/len(places)
              for _, places, v in records(run)]
    bench.atMost(run, "energy, of that at the start", 1 + 1e-9, max(energy)/energy[0])
    bench.atMost(run, "energy gained between records, of it", 1e-9,
                 max(b - a for a, b in zip(energy, energy[1:]))/energy[0])


def verify(bench):
    run = bench.run(falling("slab through a lid"), impulse=math.inf)
    judgeStep(bench, run)
    judgeJet(bench, run)
    judgeBalances(bench, run)
    case = falling("step is fixed", LONGEST)
    fixed = runCase(case, bench.folder(case), bench.ranks, bench.solver)
    bench.atLeast(fixed, "must exceed one: Courant number", 1.2, courant(fixed))


if __name__ == "__main__":
    main(verify)
