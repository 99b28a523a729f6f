# SPDX-License-Identifier: GPL-3.0-or-later
"""Beds whose void fractions pass 0.8, where the drag of a dense bed gives way to that of a dilute one.
The two branches differ there by a seventh. Switched at once, the same powder on either side of 0.8 has
another drag, and a cell on the edge may take turns from step to step; the law blends them over 0.01.

The pressure drop across a frozen bed must fall as the void fraction grows, never steeper than the law
itself, written a second time; and it must come to rest: in the last 100 of 1000 steps it stays the same.
The law that switches at once must be seen to jump.
"""
import math

from hardCase import main, measured, table

from A02bLatticeBed import BED, EXACT, SPEED, bed

VOIDS = [0.79 + 0.0025*i for i in range(9)]
COUNT = 1000
STEPS = 0.98  # coupling step in response times
STILL = 1e-6
PROBE = """    below
    {{
        type            probes;
        libs            (sampling);
        fields          (p);
        probeLocations  (({} {}));
        writeControl    timeStep;
    }}"""
ACROSS = 1e-4  # from one side of 0.8 to the other, closer than the blend is wide


def crossing(voidFraction, count=20, subSteps=1000, name="bed", **options):
    case = bed(f"{name} {100*voidFraction:.4g} %", voidFraction, 2, STEPS, **options)
    case.subSteps = subSteps
    case.endTime = count*case.deltaT
    return case


def slope(run):
    """Pressure per length inside the bed [Pa/m]."""
    p = run.pressureLayers()
    low, high = BED[0] + 3, BED[1] - 3
    return (p[low] - p[high])/(run.case.box.cell[2]*(high - low))


def steepest(powder):
    """Of the law: change of the slope with the void fraction."""
    fine = 1e-6
    return max(abs(powder.slope(a + fine, SPEED) - powder.slope(a, SPEED))/fine
               for a in (0.79 + 1e-5*i for i in range(2000)))


def verify(bench):
    slopes = []
    for voidFraction in VOIDS:
        case = crossing(voidFraction)
        run = bench.run(case, impulse=math.inf)
        slopes.append(slope(run))
        bench.near(run, "pressure gradient [Pa/m]", case.powder.slope(voidFraction, SPEED),
                   slopes[-1], EXACT)
    changes = [(b - a)/0.0025 for a, b in zip(slopes, slopes[1:])]
    bench.atMost(run, "growth with the void fraction [Pa/m]", 0, max(changes))
    bench.atMost(run, "steepest fall, of the law's", 1, -min(changes)/steepest(case.powder))
    atSwitch(bench)
    for voidFraction in (0.7975, 0.80, 0.8025):
        comesToRest(bench, voidFraction)


def atSwitch(bench):
    """Change of drag across the switch, of itself."""
    for law in ("GidaspowHuilin", "GidaspowSwitch"):
        runs = [bench.run(crossing(0.80 + side*ACROSS/2, name=law, lawName=law), impulse=math.inf)
                for side in (-1, 1)]
        below, above = map(slope, runs)
        jump = 1 - above/below
        if law == "GidaspowHuilin":
            bench.atMost(runs[-1], "jump of the pressure gradient", 0.01, jump)
        else:
            bench.atLeast(runs[-1], "must jump: pressure gradient", 0.05, jump)


def comesToRest(bench, voidFraction):
    case = crossing(voidFraction, COUNT, subSteps=20, name="at rest")
    place = " ".join(str(0.3*x) for x in case.box.size[:2])
    run = bench.run(measured(case, PROBE.format(place, 1e-6)), impulse=math.inf)
    pressures = [row[1] for row in table(run, "below")]
    last = pressures[-100:]
    bench.equal(run, "steps that went well", COUNT, len(pressures), 0)
    bench.atMost(run, "swing of the pressure below, of itself", STILL,
                 (max(last) - min(last))/abs(last[-1]))


if __name__ == "__main__":
    main(verify)
