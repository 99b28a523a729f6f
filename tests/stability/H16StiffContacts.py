# SPDX-License-Identifier: GPL-3.0-or-later
"""Two hundred parcels fly at 5 m/s against walls and each other, restitution 0.1, at a DEM step of
40 % of the Rayleigh time. That is a fifth of the duration of such an impact: the first step of a
contact carries a parcel through a good part of the overlap, and the dashpot of e = 0.1 is strong. A
scheme that gives back more than it took would heat the powder until it explodes.

Energy may not grow. During a contact part of it is elastic, so it is counted between contacts: a
bounce is a set of parcels that touch each other or a wall, from the last record at which all are
free to the next one, at records of every DEM step. Nothing but contacts acts where there is no air,
so after each bounce the parcels in it have at most the energy, of motion and spin, that they had
before. In air that is closed in and at rest, the energy of powder and air together never grows.

Rough parcels at 40 % are beyond what an explicit dashpot allows along the surface: a slip decays at
the rate 7 sqrt(5/6) b sqrt(8 G* sqrt(R* delta)/m*), b = 0.59, 3.5 times what it is for a point mass
because the parcels spin, and times the step that may be 2 at most. At 40 % four of 785 bounces gained
energy, by up to a quarter, and a parcel that rolled in an edge of the box was thrown out of it; so the
solver refuses that step. At 27 %, the longest that it takes here, no bounce may gain.

A step so long is the user's choice: the solver must say so, once, in a warning, which does not come at
20 %, as it chooses by itself. Beyond half the Rayleigh time it refuses smooth parcels as well, whether
the step or its share is given. LIGGGHTS alone does not, and energy grows.

Walls of steel are two thousand times as stiff. A contact with one is at most twice as stiff as between
two parcels, so the step need not be shorter; and no bounce may gain there either.

Rayleigh time: pi R sqrt(rho/G)/(0.1631 nu + 0.8766), G = E/(2 + 2 nu).
"""
import itertools
import math
import random
import re

from hardCase import Box, Case, Powder, change, main, run, spaced
from harness.case import execute

CELL, CELLS = 1e-3, (6, 6, 6)  # [m]
COUNT, K = 200, 10
SPEED = 5.0  # [m/s]
YOUNG, POISSON, RESTITUTION = 1e8, 0.3, 0.1
SMOOTH, ROUGH = 0.0, 0.67  # coefficients of friction
POWDER = Powder()
RADIUS = 0.5*K*POWDER.diameter
RAYLEIGH = (math.pi*RADIUS*math.sqrt(POWDER.density*2*(1 + POISSON)/YOUNG)
            / (0.1631*POISSON + 0.8766))  # [s]
STEPS = 1000  # of the DEM: 3.8 ms, in which a parcel would fly three times through the box
WRITE = 50  # DEM steps from one written time to the next
STEEL = 2e11  # Young's modulus of walls [Pa]
# The second type is that of the walls.
CONTACTS = f"""
hard_particles yes
fix young all property/global youngsModulus peratomtype {YOUNG} WALLS
fix poisson all property/global poissonsRatio peratomtype {POISSON} {POISSON}
fix rebound all property/global coefficientRestitution peratomtypepair 2 {spaced([RESTITUTION]*4)}
fix coulomb all property/global coefficientFriction peratomtypepair 2 FRICTION FRICTION FRICTION FRICTION
pair_style gran model hertz tangential history
pair_coeff * *
"""
WALL = "fix {0}{1} all wall/gran model hertz tangential history primitive type 2 {0}plane {2:.15g}\n"
MASS = 4/3*math.pi*RADIUS**3*POWDER.density
INERTIA = 0.4*MASS*RADIUS**2


def places(box):
    """At random, no two touching."""
    chance, found = random.Random(16), []
    while len(found) < COUNT:
        place = tuple(chance.uniform(1.05*RADIUS, length - 1.05*RADIUS) for length in box.size)
        if all(math.dist(place, other) > 2.1*RADIUS for other in found):
            found.append(place)
    return found


def direction(chance):
    z, turn = chance.uniform(-1, 1), chance.uniform(0, 2*math.pi)
    across = math.sqrt(1 - z*z)
    return across*math.cos(turn), across*math.sin(turn), z


def throw(name, share, friction, air=False, walls=YOUNG):
    """A cloud at a DEM step of so much of the Rayleigh time."""
    box = Box(tuple(n*CELL for n in CELLS), CELLS, ("noSlip", "noSlip", "noSlip"))
    step = share*RAYLEIGH
    chance, positions = random.Random(61), places(box)
    velocities = {x: tuple(SPEED*c for c in direction(chance)) for x in positions}
    case = Case(name, box, POWDER, k=K, positions=positions, velocity=velocities.get,
                deltaT=10*step, subSteps=10, endTime=STEPS*step, writeInterval=WRITE*step,
                smoothingWidth=2*CELL, recordEvery=1)
    materials = CONTACTS.replace("FRICTION", str(friction)).replace("WALLS", str(walls))
    planes = "".join(WALL.format(axis, side, side*length)
                     for axis, length in zip("xyz", box.size) for side in (0, 1))
    change(case, "powder.in", "neigh_modify    delay 0 exclude group all all",
           "neigh_modify    delay 0\n" + materials + planes)
    change(case, "powder.data", "1 atom types", "2 atom types")
    change(case, "powder.in", "vx vy vz", "vx vy vz omegax omegay omegaz")
    change(case, "powder.in", 'format "%d', 'format "%d %.15g %.15g %.15g')
    if not air:
        change(case, "constant/couplingProperties", "air             on", "air             off")
    return case


def record(folder):
    """Of every DEM step: places, and energies of motion and spin, by parcel."""
    blocks = (folder/"record.txt").read_text().split("ITEM: TIMESTEP\n")[1:]
    for block in blocks:
        rows = [tuple(map(float, line.split())) for line in block.splitlines()[8:]]
        yield [row[1:4] for row in rows], [
            0.5*MASS*math.hypot(*row[4:7])**2 + 0.5*INERTIA*math.hypot(*row[7:10])**2
            for row in rows]


def beyond(place, size):
    """How far a parcel reaches into a wall."""
    return max(max(RADIUS - x, x + RADIUS - length) for x, length in zip(place, size))


def contacts(places, size):
    """Pairs that touch; who touches a wall is a pair with itself."""
    order = sorted(range(len(places)), key=lambda i: places[i][0])
    pairs = [(i, i) for i in order if beyond(places[i], size) > 0]
    for n, a in enumerate(order):
        for b in order[n + 1:]:
            if places[b][0] - places[a][0] >= 2*RADIUS:
                break
            if math.dist(places[a], places[b]) < 2*RADIUS:
                pairs.append((a, b))
    return pairs


def bounces(frames, size):
    """Energies before and after, of each set of parcels that touched until all were free again."""
    energies, open_ = [], {}  # of a parcel that is in one: {parcel: last record at which it was free}
    for now, (places, energy) in enumerate(frames):
        energies.append(energy)
        pairs = contacts(places, size)
        for a, b in pairs:
            joint = {**open_.get(a, {a: now - 1}), **open_.get(b, {b: now - 1})}
            open_.update(dict.fromkeys(joint, joint))
        touching = {i for pair in pairs for i in pair}
        for joint in {id(joint): joint for joint in open_.values()}.values():
            if touching.isdisjoint(joint):
                yield (sum(energies[free][i] for i, free in joint.items()),
                       sum(energy[i] for i in joint))
                for i in joint:
                    del open_[i]


def warnings(done):
    return len(re.findall(r"^.*WARNING.*DEM step.*$", done.log, re.M))


def energiesOf(done):
    frames = list(record(done.folder))
    return frames, [math.fsum(energy) for _, energy in frames]


def judgeWhole(bench, done):
    """What holds however rough the parcels are: of all of them, once contacts are few."""
    frames, totals = energiesOf(done)
    bench.equal(done, "records, one each DEM step", STEPS + 1, len(frames), 0)
    bench.atMost(done, "energy at any time, of the start", 1 + 1e-12, max(totals)/totals[0])
    later = totals[::WRITE]
    bench.atMost(done, "energy, of 50 DEM steps before", 1,
                 max(b/a for a, b in zip(later, later[1:])))
    bench.atMost(done, "energy at the end, of the start", 0.2, totals[-1]/totals[0])
    deepest = max(beyond(place, done.case.box.size) for places, _ in frames for place in places)
    bench.atMost(done, "deepest in a wall, of the radius", 1, deepest/RADIUS)


def judgeBounces(bench, done):
    """Each by itself."""
    found = list(bounces(record(done.folder), done.case.box.size))
    gains = [after/before for before, after in found]
    bench.atLeast(done, "bounces", 2*COUNT, len(found))
    bench.atMost(done, "energy after a bounce, of before, at most", 1 + 1e-12, max(gains))


def judgeAir(bench, done):
    """Powder and air at the times that were written."""
    density = POWDER.air.density*CELL**3
    powder = energiesOf(done)[1]
    totals = [powder[0]]
    for i, time in enumerate(done.times(), 1):
        flow = math.fsum(alpha*math.hypot(*u)**2 for alpha, u in
                         zip(done.field("voidFraction", time), done.field("U", time)))
        totals.append(powder[WRITE*i] + 0.5*density*flow)
    bench.equal(done, "times on record", STEPS//WRITE + 1, len(totals), 0)
    bench.atMost(done, "energy with the air's, of the time before", 1,
                 max(b/a for a, b in zip(totals, totals[1:])))


def alone(bench, share):
    """The rough cloud in LIGGGHTS alone, which refuses no step, while it keeps all parcels."""
    case = throw(f"LIGGGHTS alone, {100*share:g} %", share, ROUGH)
    folder = bench.folder(case)
    change(case, "powder.in", "thermo          100000", f"run {STEPS}")
    case.write(folder, 1)
    execute(folder, ["liggghts", "-in", "powder.in"], "log.alone")
    totals = [math.fsum(energy) for _, energy in
              itertools.takewhile(lambda frame: len(frame[0]) == COUNT, record(folder))]
    grown = max(totals)/totals[0]
    bench.row(case.name, "no guard: energy at any time, of the start", 1.1, grown,
              min(0.0, grown - 1.1), 0, 0)


def verify(bench):
    for name, share, friction, walls, warned in (("20 %, rough", 0.2, ROUGH, YOUNG, 0),
                                                 ("20 %, rough, steel", 0.2, ROUGH, STEEL, 0),
                                                 ("27 %, rough", 0.27, ROUGH, YOUNG, 1),
                                                 ("40 %, smooth", 0.4, SMOOTH, YOUNG, 1)):
        case = throw(name, share, friction, walls=walls)
        done = run(case, bench.folder(case), bench.ranks, bench.solver)
        bench.equal(done, "warnings of the DEM step", warned, warnings(done), 0)
        judgeWhole(bench, done)
        judgeBounces(bench, done)
    for name, share, friction in (("27 %, rough, in air", 0.27, ROUGH),
                                  ("40 %, smooth, in air", 0.4, SMOOTH)):
        done = bench.run(throw(name, share, friction, air=True), impulse=math.inf)
        bench.equal(done, "warnings of the DEM step", 1, warnings(done), 0)
        judgeWhole(bench, done)
        judgeAir(bench, done)
    bench.refused(throw("40 %, rough", 0.4, ROUGH), f"demStep {0.4*RAYLEIGH:g} s",
                  "friction's dashpot", "key demStep")
    tooLong = throw("60 %", 0.6, SMOOTH)
    bench.refused(tooLong, f"demStep {0.6*RAYLEIGH:g} s", "Rayleigh", "key demStep")
    light = throw("20 %, one parcel light", 0.2, SMOOTH)  # 80 % for that one
    change(light, "powder.data", f"\n1 1 {2*RADIUS:.15g} {POWDER.density:.15g} ",
           f"\n1 1 {2*RADIUS:.15g} {POWDER.density/16:.15g} ")
    bench.refused(light, f"demStep {0.2*RAYLEIGH:g} s", f"Rayleigh time {0.25*RAYLEIGH:.6g} s", "key demStep")
    share = throw("60 % by its share", 0.6, SMOOTH)
    change(share, "constant/couplingProperties", f"demStep {share.demStep:.15g};",
           "rayleighFraction 0.6; hertzFraction 0.6;")
    bench.refused(share, "rayleighFraction 0.6", "Rayleigh", "couplingProperties")
    alone(bench, 0.6)


if __name__ == "__main__":
    main(verify)
