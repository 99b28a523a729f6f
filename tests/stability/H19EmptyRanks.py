# SPDX-License-Identifier: GPL-3.0-or-later
"""All powder lies on the part of one rank; the others have no particle, or no cell of the bed, or
neither. Empty arrays must not stop a rank that others wait for, and sums over ranks must stay what
they are.

A narrow bed stands at one side of a box that is cut across, mesh and powder each by itself: both on
the bed's side, only the mesh, only the powder. Every run is compared with one on a single rank:
void fraction, velocity and pressure, what the powder fills on the mesh, the pressure drop and the
momentum of air and powder at each step. The bed is frozen, and then free, in air that lifts some of
it and before any contact, so that the order of sums is all that may differ.

A third run starts without any powder on any rank. Its grains come by fix insert during later steps,
each at a place of its own, so that the number of ranks does not change what is inserted.
"""
import math

from hardCase import GRAVITY, Box, Powder, change, main, measured, table, volumeError
from H18Decompositions import EQUAL, CutCase, difference

CELL, CELLS = 1e-3, (16, 4, 8)  # [m]
BED = (3, 4, (2, 5))  # cells in x and y, and layers along z: within a fourth of the box
POWDER = Powder(0.45e-3, 2600.0)
SPEED = 0.3  # of the air, upwards [m/s]
STEP, SUBSTEPS, COUNT = 2e-4, 10, 10
VOLUME = 1e-12  # relative, of powder on the mesh
BORN = (25, 43)  # DEM steps at which a grain is inserted, inside a coupling step
PLACES = ((1.3e-3, 1.7e-3, 3.1e-3), (2.6e-3, 2.2e-3, 4.4e-3))
SEEDS = ((15485863, 32452843, 49979687), (67867967, 86028121, 104395301))


def cuts(ranks):
    across, along = f"{ranks} 1 1", f"1 1 {ranks}"
    return [(across, across), (across, along), (along, across)]


def bed(box):
    """A simple cubic lattice, two grains along a cell's edge."""
    (columns, rows, (first, last)), half = BED, CELL/2
    return [((i + 0.5)*half, (j + 0.5)*half, (k + 0.5)*half) for i in range(2*columns)
            for j in range(2*rows) for k in range(2*first, 2*last)]


def blown(name, mesh, powder, **options):
    box = Box(tuple(CELL*n for n in CELLS), CELLS, ("slip", "periodic", ("inlet", "outlet")))
    case = CutCase(f"{name} ({mesh}) ({powder})", mesh, box=box, powder=POWDER,
                   U=(0, 0, SPEED), gravity=(0, 0, -GRAVITY), processors=powder, deltaT=STEP,
                   subSteps=SUBSTEPS, endTime=COUNT*STEP, **options)
    return measured(case, "    powderBalance { type powderBalance; }")


def frozen(mesh, powder):
    case = blown("frozen", mesh, powder, motion="frozen")
    case.positions = bed(case.box)
    return case


def free(mesh, powder):
    """Smoothing takes powder to ranks that have none."""
    case = blown("free", mesh, powder, smoothingWidth=CELL)
    case.positions = bed(case.box)
    return case


def insertion(i):
    """A fix that inserts one grain at one place: a region too small to choose."""
    low = " ".join(f"{x - 1e-15:.17g} {x + 1e-15:.17g}" for x in PLACES[i])
    template, mix, seed = SEEDS[i]
    return f"""
region place{i} block {low} units box volume_limit 1e-60
fix grain{i} all particletemplate/sphere {template} atom_type 1 &
    density constant {POWDER.density} radius constant {POWDER.diameter/2}
fix mix{i} all particledistribution/discrete {mix} 1 grain{i} 1.0
fix born{i} all insert/pack seed {seed} distributiontemplate mix{i} maxattempt 100 &
    insert_every once start {BORN[i]} overlapcheck yes all_in no vel constant 0 0 0 &
    region place{i} particles_in_region 1"""


def born(mesh, powder):
    case = blown("born later", mesh, powder)
    births = "".join(insertion(i) for i in range(len(BORN)))
    return change(case, "powder.in", "fix integrate all nve/sphere",
                  f"fix integrate all nve/sphere\nfix g all gravity {GRAVITY} vector 0 0 -1" + births)


def pressureDrop(run):
    layers = run.pressureLayers()
    return layers[0] - layers[-1]


def budgetDifference(run, reference):
    """Of any step's momentum of air, powder or remainder, of the largest of its kind."""
    rows, others = run.budget(), reference.budget()
    assert [row[0] for row in rows] == [row[0] for row in others]
    worst = 0.0
    for part in (1, 2, 3):
        size = max(math.hypot(*row[part]) for row in others)
        gap = max(math.dist(a[part], b[part]) for a, b in zip(rows, others))
        worst = max(worst, gap/size if size else gap)
    return worst


def beside(run):
    """Powder in any cell that a rank without the bed would have on four ranks."""
    alphas = run.field("voidFraction")
    return max(1 - alpha for i, alpha in enumerate(alphas) if i % CELLS[0] >= CELLS[0]//4)


def judgeSame(bench, run, reference):
    for name in ("voidFraction", "U", "p"):
        bench.equal(run, f"difference of {name} from one rank", 0,
                    difference(run, reference, name), EQUAL)
    bench.equal(run, "difference of a momentum from one rank", 0,
                budgetDifference(run, reference), EQUAL)
    bench.near(run, "pressure drop, as on one rank [Pa]", pressureDrop(reference),
               pressureDrop(run), EQUAL)


def judgeBirths(bench, run):
    counts = [row[6] for row in table(run, "powderBalance")]
    expected = [sum(step <= SUBSTEPS*n for step in BORN) for n in range(1, COUNT + 1)]
    bench.equal(run, "steps with another number of grains", 0,
                sum(a != b for a, b in zip(counts, expected)), 0)
    onMesh = math.fsum(1 - alpha for alpha in run.field("voidFraction"))*CELL**3
    bench.near(run, "powder on the mesh, of the grains [m3]",
               len(BORN)*math.pi/6*POWDER.diameter**3, onMesh, VOLUME)


def verify(bench):
    ranks = bench.ranks
    for make in (frozen, free, born):
        bench.ranks = 1
        reference = bench.run(make("1 1 1", "1 1 1"), impulse=math.inf)
        bench.ranks = ranks
        for mesh, powder in cuts(ranks):
            run = bench.run(make(mesh, powder), impulse=math.inf)
            judgeSame(bench, run, reference)
            if make is born:
                judgeBirths(bench, run)
            else:
                bench.equal(run, "powder on the mesh less that of grains", 0, volumeError(run),
                            VOLUME)
            if make is frozen:
                bench.equal(run, "powder beside the bed's part", 0, beside(run), 0)


if __name__ == "__main__":
    main(verify)
