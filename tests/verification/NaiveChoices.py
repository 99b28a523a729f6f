# SPDX-License-Identifier: GPL-3.0-or-later
"""Each choice of the scheme that a simpler code would make differently, made differently: the
number that the solver meets must then be missed, as theory or experience says.

The solvers with a naive choice are built from the sources in naive/. Some rows have a number of
their own: a sealed plug ends at U_mf/alpha where the air need not make way for it, d(alpha)/dt
forgotten, and the same where it does not feel the pressure.
"""
import copy
import math

from harness.bench import main
from harness.laws import GRAVITY, root

from A02bLatticeBed import SPEED, bed
from A11SealedPlug import RESPONSE, fall, mappedSpeed, mass, plug, powder, relaxation


def endSpeed(run):
    return fall(run)[-1][1]/mappedSpeed(run)


def overBed(run):
    """Pressure drop over the bed, of that of the void fraction on the mesh."""
    height = run.case.box.cell[2]
    p = run.pressureLayers()
    return (p[0] - p[-1])/sum(powder.slope(a, SPEED)*height for a in run.layers("voidFraction"))


def supported(run):
    """Pressure below the plug, of what its weight asks for."""
    area = run.case.box.size[0]*run.case.box.size[1]
    return run.pressureLayers()[0]*area/(mass(run.case)*GRAVITY)


def unevenness(run):
    """Swing of the velocity from step to step at the end of the run, of the end speed."""
    v = [speed for _, speed in fall(run)]
    return abs(v[-1] - 2*v[-2] + v[-3])/mappedSpeed(run)


def tooFast(run):
    """End speed of a plug that feels drag of still air and the pressure of it, or drag alone in the
    air that it drives out: alpha times the resistance in both."""
    height = run.case.box.cell[2]
    voids = run.layers("voidFraction")
    weight = sum(1 - alpha for alpha in voids)*powder.density*GRAVITY*height
    return root(lambda v: sum(alpha*powder.slope(alpha, v) for alpha in voids)*height - weight,
                0, 1)


class Comparison:
    def __init__(self, bench, case, choice, impulse):
        self.bench = bench
        self.choice = choice
        self.ours = bench.run(case, impulse)
        twin = copy.copy(case)
        twin.name = choice
        self.naive = bench.runNaively(twin, choice)

    def met(self, quantity, expected, measure, tolerance):
        self.bench.near(self.ours, quantity, expected, measure(self.ours), tolerance)

    def missed(self, quantity, expected, measure, least):
        """The naive solver must be off by at least so much."""
        error = abs(measure(self.naive)/expected - 1)
        self.bench.atLeast(self.naive, f"must miss: {quantity}", least, error)


def pushed(case):
    """Drag impulse of a step on a plug."""
    return mass(case)*GRAVITY*case.deltaT


def verify(bench):
    # One half cell of bed at each of two surfaces.
    case = bed("faces in series", 0.40, 2, 0.02)
    faces = Comparison(bench, case, "facesOneByOne", impulse=math.inf)
    faces.met("drop over bed, of mapped", 1, overBed, 5e-3)
    faces.missed("drop over bed, of mapped", 1, overBed, 0.05)

    case = plug("gradient of the fluxes", k=10, perCell=1, height=0.005)
    gradient = Comparison(bench, case, "plainPressureGradient", pushed(case))
    gradient.met("end speed, of mapped", 1, endSpeed, 2e-2)
    gradient.missed("end speed, of mapped", 1, endSpeed, 3e-2)

    for name, choice in (("volume change", "noVolumeChange"),
                         ("pressure force", "noPressureForce")):
        case = plug(name, k=10, perCell=2, endTime=20*RESPONSE)
        plugs = Comparison(bench, case, choice, pushed(case))
        plugs.met("end speed, of mapped", 1, endSpeed, 2e-2)
        bench.near(plugs.naive, "ends at U_mf/alpha [m/s]", tooFast(plugs.naive),
                   fall(plugs.naive)[-1][1], 2e-2)

    case = plug("adjoint sampling", k=4, perCell=2, smoothingWidth=480e-6, endTime=16*RESPONSE)
    adjoint = Comparison(bench, case, "noAdjoint", pushed(case))
    adjoint.met("pressure, of weight", 1, supported, 1e-3)
    adjoint.missed("pressure, of weight", 1, supported, 5e-3)

    case = plug("predicted positions", k=4, perCell=2, deltaT=0.2*RESPONSE)
    prediction = Comparison(bench, case, "noPrediction", pushed(case))

    def ofResponse(run):
        return relaxation(run, mappedSpeed(run))/(mappedSpeed(run)/GRAVITY)
    prediction.met("response time, of mapped", 1, ofResponse, 5e-2)
    prediction.missed("response time, of mapped", 1, ofResponse, 0.08)

    case = plug("carry", k=4, perCell=2, deltaT=0.5*RESPONSE, endTime=40*RESPONSE)
    carry = Comparison(bench, case, "carryOfCarry", pushed(case))
    bench.atMost(carry.ours, "swing from step to step", 1e-3, unevenness(carry.ours))
    bench.atLeast(carry.naive, "must swing from step to step", 1e-2, unevenness(carry.naive))


if __name__ == "__main__":
    main(verify)
