# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in thin air, on which the gas slips: drag is 1 + Kn (1.257 + 0.4 exp(-1.1/Kn)) times smaller, with Kn = 2 lambda/d
and lambda = mu sqrt(pi/(2 p rho)) (C.N. Davies, Proc. Phys. Soc. 57 (1945) 259-270).

a  A grain that falls is that much faster than Stokes has it, in the end and on the way there.
b  Air that flows through a frozen bed loses that much less pressure.
c  `auto` decides by 2.52 lambda/d at the start, and later if a grain calls for it; water has none, and is refused it.
"""
import math

import A02bLatticeBed as beds
from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, GRAVITY, Powder, stokes

EXACT = 1e-3
ALONE = "rarefaction on; shearLift off; spinLift off; virtualMass off; viscousForce off;"
PRESSURE = 1000.0  # [Pa]


def thin(pressure):
    return Air(1.225*pressure/101325)


def freePath(air, pressure):
    return air.viscosity*math.sqrt(math.pi/(2*pressure*air.density))


def factor(powder, pressure):
    knudsen = 2*freePath(powder.air, pressure)/powder.diameter
    return 1 + knudsen*(1.257 + 0.4*math.exp(-1.1/knudsen))


def inAir(pressure):
    return f"pressure {pressure:g};"


def falling(name, powder, pressure, effects, **options):
    response = powder.density*powder.diameter**2/(18*powder.air.viscosity)
    return Case(name, Box((0.02,)*3, (5,)*3), powder, positions=[(0.01,)*3], lawName="Stokes", effects=effects,
                air="oneWay", gravity=(0, 0, -GRAVITY), compressibility=inAir(pressure),
                **{"deltaT": response/20, "subSteps": 4, "endTime": response, **options})


def judgeFall(bench):
    for pressure in (PRESSURE, 20.0):
        powder = Powder(40e-6, 7360.0, thin(pressure), stokes)
        run = bench.run(falling(f"falling at {pressure:g} Pa", powder, pressure, ALONE), impulse=math.inf)
        mass = math.pi/6*powder.diameter**3*powder.density
        end = run.case.endTime
        response = end*factor(powder, pressure)
        bench.near(run, "speed [m/s]", response*GRAVITY*(1 - math.exp(-end/response)), -run.budget()[-1][2][2]/mass, EXACT)


def judgeBed(bench):
    drops = []
    for effects in (ALONE, ALONE.replace("rarefaction on", "rarefaction off")):
        case = beds.bed(f"bed, {effects[:15]}", 0.40, 2, 0.02, compressibility=inAir(PRESSURE), effects=effects)
        run = bench.run(case, impulse=math.inf)
        p = run.pressureLayers()
        drops.append(p[beds.INSIDE[0]] - p[beds.INSIDE[1]])
    # The mean free path is that of the case's own density.
    bench.near(run, "pressure drop over that without slip", 1/factor(case.powder, PRESSURE), drops[0]/drops[1], EXACT)


def judgeChoice(bench):
    for name, share in (("auto, large", 0.049), ("auto, small", 0.051)):
        air = Air()
        powder = Powder(2.52*freePath(air, 101325)/share, 7360.0, air, stokes)
        run = bench.run(falling(name, powder, 101325, ""), impulse=math.inf)
        bench.equal(run, "told to be simulated", share > 0.05, "rarefaction is simulated" in run.log, 0)
    water = Powder(1e-6, 2500.0, Air(1000.0, 1e-3), stokes)
    run = bench.run(falling("water", water, 101325, "", deltaT=1e-8, endTime=1e-7), impulse=math.inf)
    bench.equal(run, "told to be simulated", 0, "rarefaction is simulated" in run.log, 0)
    bench.refused(falling("slipping water", water, 101325, ALONE, deltaT=1e-8, endTime=1e-7),
                  "rarefaction on, 1000 kg/m3", "effects, key rarefaction", "transportProperties, key rho")


def verify(bench):
    judgeFall(bench)
    judgeBed(bench)
    judgeChoice(bench)


if __name__ == "__main__":
    main(verify)
