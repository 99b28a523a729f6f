# SPDX-License-Identifier: GPL-3.0-or-later
"""H22: a plug of grains tied into one body falls at 0.3 m/s onto a closed cavity of isothermal air, and
bounces on it while the air leaks through its pores.

Expected is another solution of the same physics, a line of pores between cavity and outlet, without
the inertia of the air (z upwards through the plug, q the flux relative to it):

    alpha/p0 dp/dt = -dq/dz                  in the pores, dp/dz = -(a q + b q |q|)
    h/p0 dp_c/dt   = v - q(0)                in the cavity, dh/dt = -v
    m dv/dt        = m g - p_c               m: of the plug per area

While little leaks, that is an oscillator of frequency sqrt(p0/(h m)) with the cavity's depth h; a third
of the pores' air is compressed with it and adds alpha H/3 to h, here a quarter of it. With p0 beyond
all measure it is the plug to which air does not yield (A11), and a closed box works with either.
"""
import bisect
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]/"verification"))

from A11SealedPlug import VOID, HEIGHT, fall, mappedSpeed, mass, plug, powder  # noqa: E402
from harness.bench import main  # noqa: E402
from harness.laws import GRAVITY  # noqa: E402

REST = 101325.0  # p0 [Pa]
IMPACT = 0.3  # [m/s]
END = 0.03  # three periods [s]

PATH = 3e-2  # of the speed of impact, rms
PERIOD = 2e-2
OSCILLATOR = 5e-2
STIFF = 1e-4  # of the speed of impact
CLOSED = 1e-2
NODES = 12


def flux(slope):
    """Superficial velocity that a pressure slope [Pa/m] drives through the plug."""
    low, high = 1e-4, 0.2
    a = powder.slope(VOID, low)/low
    b = (powder.slope(VOID, high)/high - a)/high
    return math.copysign((math.sqrt(a*a + 4*b*abs(slope)) - a)/(2*b), slope)


def bounce(cavity, massPerArea):
    """Rows of time and speed of the plug [m/s], downwards, by Heun's method."""
    dz = HEIGHT/NODES
    pores = REST/(VOID*dz)

    def rates(state):
        pressures, below, h, v = state[:NODES], *state[NODES:]
        q = [flux((below - pressures[0])/(dz/2))]
        q += [flux((one - other)/dz) for one, other in zip(pressures, pressures[1:])]
        q.append(flux(pressures[-1]/(dz/2)))
        return [pores*(one - other) for one, other in zip(q, q[1:])] + [
            REST/h*(v - q[0]), -v, GRAVITY - below/massPerArea]

    slow = powder.slope(VOID, 1e-4)/1e-4  # a
    steps = math.ceil(END/(0.2*VOID*slow*dz*dz/REST))
    dt = END/steps
    state = [0.0]*NODES + [0.0, cavity, IMPACT]
    rows = [(0.0, IMPACT)]
    for n in range(1, steps + 1):
        first = rates(state)
        second = rates([s + dt*r for s, r in zip(state, first)])
        state = [s + 0.5*dt*(r + t) for s, r, t in zip(state, first, second)]
        rows.append((n*dt, state[-1]))
    return rows


def at(rows, time):
    """Between two rows, on a straight line."""
    n = min(max(bisect.bisect_left(rows, (time,)), 1), len(rows) - 1)
    (t, v), (u, w) = rows[n - 1], rows[n]
    return v + (w - v)*(time - t)/(u - t)


def period(rows, middle):
    """Between the first two moments at which the speed falls through its value in the end."""
    found = [t + (u - t)*(v - middle)/(v - w) for (t, v), (u, w) in zip(rows, rows[1:])
             if v >= middle > w]
    return found[1] - found[0]


def falling(name, pressure=None, lid="outlet", **options):
    settings = dict(velocity=(0, 0, -IMPACT), deltaT=2e-5, subSteps=1, endTime=END)
    settings.update(options)
    case = plug(name, **settings)
    case.box.sides[2] = ("noSlip", lid)
    if pressure:
        case.compressibility = f"compressibility isothermal; pressure {pressure:g};"
    return case


def judgeBounce(bench):
    run = bench.run(falling("bounce", REST), impulse=math.inf)
    massPerArea = mass(run.case)/(run.case.box.size[0]*run.case.box.size[1])
    cavity = run.case.positions[0][2] - run.case.box.cell[2]/2
    expected, measured = bounce(cavity, massPerArea), [(0.0, IMPACT), *fall(run)]
    end = mappedSpeed(run)
    off = [v - at(expected, t) for t, v in measured]
    bench.equal(run, "speed, rms of the difference, of impact", 0,
                math.sqrt(sum(x*x for x in off)/len(off))/IMPACT, PATH)
    bench.curve("plug on a closed cavity", "t [s]", "falling at [m/s]", expected[::max(1, len(expected)//200)], measured[::20])
    found = period(measured, end)
    bench.near(run, "period [s]", period(expected, end), found, PERIOD)
    bench.near(run, "period of the oscillator [s]",
               2*math.pi*math.sqrt((cavity + VOID*HEIGHT/3)*massPerArea/REST), found, OSCILLATOR)
    bench.report(run, "period without the pores' own air [s]",
                 2*math.pi*math.sqrt(cavity*massPerArea/REST), found)
    bench.atMost(run, "speed after three periods, of impact", 0.1, abs(measured[-1][1] - end)/IMPACT)


def judgeLimit(bench):
    """What cannot be compressed, by p0 and by the equations."""
    runs = [bench.run(falling(name, pressure, endTime=5e-3), impulse=math.inf)
            for name, pressure in (("p0 of 1e12 Pa", 1e12), ("incompressible", None))]
    off = max(abs(v - w) for (_, v), (_, w) in zip(*map(fall, runs)))
    bench.equal(runs[0], "speed, of the incompressible air's, of impact", 0, off/IMPACT, STIFF)


def judgeClosed(bench):
    """From rest, until it sinks steadily: what it leaves behind takes up what it displaces."""
    for name, pressure in (("closed, isothermal", REST), ("closed, incompressible", None)):
        run = bench.run(falling(name, pressure, "noSlip", velocity=(0, 0, 0), endTime=0.06),
                        impulse=math.inf)
        bench.near(run, "speed [m/s]", mappedSpeed(run), fall(run)[-1][1], CLOSED)


def verify(bench):
    judgeBounce(bench)
    judgeLimit(bench)
    judgeClosed(bench)


if __name__ == "__main__":
    main(verify)
