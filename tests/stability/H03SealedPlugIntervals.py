# SPDX-License-Identifier: GPL-3.0-or-later
"""The sealed plug of A.11 with long coupling steps. Over a step the grains feel the pressure of its
start; in a sealed bed that pressure is all that carries them. Let them fall for too long against a
pressure of before, and the next one throws them back by more: the swing grows beyond a limit between
one and two response times.

Up to one response time the plug must end at the speed of the formula on the void fraction of the mesh;
a longer fixed step is refused, with the step, the response time and the step to take. With the refusal
lifted the plug must be seen to swing: the limit is needed.
"""
import re

from hardCase import Failed, main, run as runCase

from A11SealedPlug import RESPONSE, SHARP, fall, mappedSpeed, mass, plug
from harness.laws import GRAVITY

STABLE = (0.2, 0.99)  # of the response time; at one, the drag of the end speed decides
REFUSED = (1.1, 2.5, 10)
ROUNDED = 1e-2  # drag at rest is less than at the end speed


def interval(steps, **options):
    return plug(f"plug, {steps:g} responses", deltaT=steps*RESPONSE, subSteps=max(10, round(20*steps)),
                endTime=40*steps*RESPONSE, **options)


def judgeRefusal(bench, case, steps):
    """The message's own numbers: the step, and what it is of the response time."""
    try:
        runCase(case, bench.folder(case), bench.ranks, bench.solver)
        message = ""
    except Failed as failure:
        message = str(failure)
    found = re.search(r"deltaT (\S+) s = (\S+) of the powder's response time", message)
    step, share = map(float, found.groups()) if found else (float("nan"), float("nan"))
    bench.row(case.name, "refused: step that it names [s]", case.deltaT, step,
              step/case.deltaT - 1, 1e-5, 0.0)
    bench.row(case.name, "refused: in response times", steps, share, share/steps - 1, ROUNDED, 0.0)


def verify(bench):
    for steps in STABLE:
        case = interval(steps)
        run = bench.run(case, impulse=mass(case)*GRAVITY*case.deltaT)
        end = mappedSpeed(run)
        bench.near(run, "end speed [m/s]", end, fall(run)[-1][1], SHARP)
        swing = max(abs(b - a) for (_, a), (_, b) in zip(fall(run)[-6:], fall(run)[-5:]))
        bench.atMost(run, "swing from step to step at the end", 1e-3, swing/end)
    for steps in REFUSED:
        judgeRefusal(bench, interval(steps), steps)

    case = interval(2.5, timeStep="stabilityLimit 1e9; parcelCourant 1e9;")
    case.name = "plug, 2.5, not refused"
    case.endTime = 15*case.deltaT
    swinging = runCase(case, bench.folder(case), bench.ranks, bench.solver)
    speeds = [abs(v) for _, v in fall(swinging)]
    bench.atLeast(swinging, "must swing: highest over end speed", 10,
                  max(speeds)/mappedSpeed(swinging))


if __name__ == "__main__":
    main(verify)
