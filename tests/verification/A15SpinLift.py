# SPDX-License-Identifier: GPL-3.0-or-later
"""Lift of a grain that spins, and how the air slows its spin.

a  A grain falls at its terminal velocity along z in still air, spinning about y, and drifts along x. Its spin decays
   with the time T_w = I/(pi mu d^3) = rho_p d^2/(60 mu). Of slow spin and fall the lift is that of S.I. Rubinow & J.B.
   Keller, J. Fluid Mech. 11 (1961) 447-459; the paths of both are integrated by small steps.
b  A grain that does not spin falls through air that does: half its vorticity, until the grain spins as fast.
c  What the grains get, the air loses.
d  Stopped in between it goes on as if it had not been, on one rank to round-off.
e  `auto` turns it on where rho d^2 w/(24 mu) exceeds 0.1. Parcels of several grains are refused, if asked for.
"""
import math

import A13ShearLift as sheared
from harness.bench import main
from harness.case import Box, Case, goOn
from harness.laws import GRAVITY, Powder, stokes

DRIFT = 1e-2
ALONE = "spinLift on; shearLift off; virtualMass off; viscousForce off;"
SLOW = Powder(20e-6, 1000.0, law=stokes)


def spinTime(powder):
    return powder.density*powder.diameter**2/(60*powder.air.viscosity)


def response(powder):
    return powder.density*powder.diameter**2/(18*powder.air.viscosity)


def liftFactor(powder, slip, spin):
    """Of pi/8 rho d^3 slip spin."""
    d, air = powder.diameter, powder.air
    ratio = d*spin/slip
    fade = math.exp(-0.05684*(air.density*d*d*spin/air.viscosity)**0.4*air.reynolds(slip, d)**0.3)
    return 0.45/ratio*(1 - fade) + fade


def torqueFactor(powder, spin):
    """S.C.R. Dennis, S.N. Singh & D.B. Ingham, J. Fluid Mech. 101 (1980) 257-279, over pi mu d^3 w."""
    reynolds = powder.air.density*powder.diameter**2*spin/powder.air.viscosity
    return 1 if reynolds <= 32 else (12.9*math.sqrt(reynolds) + 128.4)/(64*math.pi)


def drift(powder, spin, end, steps=20000):
    """Velocity along x at a time, by the midpoint rule, of a grain that starts at its terminal velocity."""
    dt = end/steps
    weight = GRAVITY*(1 - powder.air.density/powder.density)

    def rates(x, z, w):
        a = 0.75*powder.air.density/powder.density*w*liftFactor(powder, math.hypot(x, z), w)
        return a*z - x/response(powder), -a*x - z/response(powder) - weight, -w*torqueFactor(powder, w)/spinTime(powder)

    now = (0.0, -response(powder)*weight, spin)
    for _ in range(steps):
        middle = [q + 0.5*dt*r for q, r in zip(now, rates(*now))]
        now = [q + dt*r for q, r in zip(now, rates(*middle))]
    return now[0]


def falling(name, powder, spin, effects, deltaT, endTime, **options):
    edge = 0.01
    return Case(name, Box((edge,)*3, (5,)*3, ("noSlip",)*3), powder, lawName="Stokes", positions=[(edge/2,)*3],
                velocity=(0, 0, -response(powder)*GRAVITY*(1 - powder.air.density/powder.density)),
                spin=(0, spin, 0), gravity=(0, 0, -GRAVITY), airGravity=(0, 0, -GRAVITY), effects=effects,
                deltaT=deltaT, subSteps=4, endTime=endTime, **options)


def judgeDrift(bench):
    for name, powder, spin in (("slow", SLOW, 500.0), ("fast", Powder(100e-6, 1000.0, law=stokes), 2e5)):
        end = 1.5*spinTime(powder)
        run = bench.run(falling(name, powder, spin, ALONE, end/60, end), impulse=math.inf)
        bench.near(run, "drift [m/s]", drift(powder, spin, end), sheared.sideways(run), DRIFT)


def judgeAirsSpin(bench):
    """Upward velocity rises along x: vorticity along -y."""
    rate, end = 1000.0, 1.5*spinTime(SLOW)
    terminal = (0, 0, -response(SLOW)*GRAVITY)
    run = bench.run(sheared.falling("in shear", SLOW, rate, ALONE, velocity=terminal, deltaT=end/60, endTime=end),
                    impulse=math.inf)
    bench.near(run, "drift [m/s]", drift(SLOW, 0.5*rate, end), sheared.sideways(run), DRIFT)


def judgeChoice(bench):
    for name, spin in (("auto, slow", 2e3), ("auto, fast", 1e5)):
        share = SLOW.air.density*SLOW.diameter**2*spin/(24*SLOW.air.viscosity)
        end = 0.1*spinTime(SLOW)
        run = bench.run(falling(name, SLOW, spin, "", end/4, end), impulse=math.inf)
        bench.equal(run, "told to be simulated", share > 0.1, "spinLift is simulated" in run.log, 0)
    bench.refused(falling("parcels", SLOW, 0.0, "spinLift on;", 1e-5, 1e-5, k=2), "spinLift on, coarseGraining 2",
                  "effects, key spinLift", "powder, key coarseGraining")


def judgeRestart(bench):
    end = 0.4*spinTime(SLOW)
    case = falling("stopped", SLOW, 1e5, "", end/16, end, writeInterval=end/2)
    run = bench.run(case, impulse=math.inf)
    again = goOn(run, run.times()[0], bench.solver)
    (time, _, grain, _), (late, _, same, _) = run.budget()[-1], again.budget()[-1]
    bench.equal(again, "end of what goes on [s]", time, late, 0)
    bench.equal(again, "told that spinLift is simulated, again", 0, "spinLift is simulated" in again.log, 0)
    for axis, one, other in zip("xyz", grain, same):
        bench.equal(again, f"momentum along {axis}, of the grain's", 0, (other - one)/math.hypot(*grain), 1e-14)


def verify(bench):
    if bench.ranks == 1:
        judgeDrift(bench)
        judgeAirsSpin(bench)
        judgeRestart(bench)
    judgeChoice(bench)
    sheared.judgeMomentum(bench, ALONE, spin=(0, 1e3, 0))


if __name__ == "__main__":
    main(verify)
