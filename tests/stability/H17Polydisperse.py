# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains of 20, 40 and 60 um in the same cells, as parcels of one scale k. Response times go with the
square of the size: those of the finest are a ninth of the coarsest's. An interval chosen for the mean
size would swing the fine grains against trapped air (H03); one drag for all would separate nothing.

The interval must be 0.2 response times of the finest, and the log say that it binds; a fixed one that the
mean size would allow is refused. The air blows through the mixture: each size must approach the common
velocity at its own pace, which a chain of implicit steps of the same equations predicts, and momentum
must be kept.
"""
import math

from hardCase import Box, Case, Powder, lattice, main, steps

SIZES = (20e-6, 40e-6, 60e-6)
K = 4
SOLIDS = 0.5
SPEED = 0.1  # of the air, at the start [m/s]
PATTERN = (0, 1, 2, 0, 1, 2, 0, 1)  # sizes of the eight grains of a cell
CELLS = (4, 4, 8)
KINDS = [Powder(size) for size in SIZES]
PARCELS = [math.pi/6*(K*size)**3 for size in SIZES]
EDGE = (sum(PARCELS[kind] for kind in PATTERN)/SOLIDS)**(1/3)
VOID = 1 - SOLIDS
RESPONSES = [kind.bedResponse(VOID) for kind in KINDS]
CHOSEN = 0.2
PACE = 0.05


class Mixture(Case):
    """Grains of several sizes: of kinds[i] the i-th."""
    kinds = ()

    def grains(self):
        head, tail = super().grains().split("Atoms\n\n")
        lines = tail.splitlines()
        for i, kind in enumerate(self.kinds):
            columns = lines[i].split()
            columns[2] = format(K*SIZES[kind], ".15g")
            lines[i] = " ".join(columns)
        return head + "Atoms\n\n" + "\n".join(lines) + "\n"


def mixture(name, **options):
    box = Box(tuple(n*EDGE for n in CELLS), CELLS)
    positions = lattice(box, 2)
    corner = [tuple(int(x/EDGE*2) % 2 for x in place) for place in positions]
    settings = dict(k=K, positions=positions, U=(0, 0, SPEED), endTime=2*RESPONSES[-1],
                    adjustTimeStep=True, deltaT=CHOSEN*RESPONSES[0], subSteps=100,
                    recordEvery=1000,
                    kinds=[PATTERN[x + 2*y + 4*z] for x, y, z in corner])
    settings.update(options)
    return Mixture(name, box, KINDS[1], **settings)


def velocities(grains, kinds):
    """Mean of each size, along z."""
    sums = [0.0]*len(SIZES)
    for i, kind in enumerate(kinds):
        sums[kind] += grains[i + 1][1][2]
    return [total/kinds.count(kind) for kind, total in enumerate(sums)]


def predicted(times):
    """Velocities of the sizes: implicit steps, fine enough, of air and each size."""
    solids = [SOLIDS*PATTERN.count(i)*PARCELS[i]/sum(PARCELS[j] for j in PATTERN)
              for i in range(len(SIZES))]
    air, speeds, now, found = SPEED, [0.0]*len(SIZES), 0.0, []
    for time in times:
        count = 200
        dt = (time - now)/count
        for _ in range(count):
            rates = [s*kind.B(VOID, air - v)*dt for s, kind, v in zip(solids, KINDS, speeds)]
            shares = [rate/(s*KINDS[0].density + rate) for rate, s in zip(rates, solids)]
            inertia = KINDS[0].air.density*VOID
            air = ((inertia*air + sum(r*(1 - q)*v for r, q, v in zip(rates, shares, speeds)))
                   / (inertia + sum(r*(1 - q) for r, q in zip(rates, shares))))
            speeds = [v + q*(air - v) for v, q in zip(speeds, shares)]
        now = time
        found.append(list(speeds))
    return found


def verify(bench):
    case = mixture("mixture, interval chosen")
    run = bench.run(case, impulse=math.inf)
    taken = steps(run)
    bench.near(run, "longest interval that was chosen [s]", CHOSEN*RESPONSES[0],
               max(step.dt for step in taken), 0.02)
    bench.atLeast(run, "share of steps that the response limits", 0.9,
                  sum(step.limit == "powder response" for step in taken)/len(taken))

    record = {t: grains for t, grains in sorted(run.record().items()) if t > 0}
    expected = predicted(record)
    for kind, size in enumerate(SIZES):
        errors = [abs(velocities(grains, case.kinds)[kind]/v[kind] - 1)
                  for grains, v in zip(record.values(), expected)]
        bench.atMost(run, f"{1e6*size:g} um: velocity, off that predicted", PACE, max(errors))
    start = KINDS[0].air.density*VOID*case.box.volume*SPEED
    totals = [start] + [a[2] + p[2] - r[2] for _, a, p, r in run.budget()]
    drift = max(abs(b - a) for a, b in zip(totals, totals[1:]))
    bench.equal(run, "momentum gained in a step, of all", 0, drift/start, 1e-10)

    fixed = 0.5*RESPONSES[1]
    bench.refused(mixture("mixture, half of the mean's", adjustTimeStep=False, deltaT=fixed),
                  f"deltaT {fixed:g} s", "response time")


if __name__ == "__main__":
    main(verify)
