# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere takes along half the mass of the fluid that it displaces [M.R. Maxey & J.J. Riley, Phys. Fluids 26
(1983) 883-889].

a  A light sphere rises from rest in still water: v = v_t (1 - exp(-t/T)), T = (rho_p + rho_f/2) d^2/(18 mu),
   v_t = (rho_f - rho_p) g d^2/(18 mu). Without that mass T is 51 times shorter.
b  Water that is pushed as a whole, by b [m/s2], leaves a light sphere behind: slip (rho_p b d^2/(18 mu))
   (1 - exp(-t/T)). Were the water's acceleration left out of the force, the slip would grow 51 times as large.
c  A sphere that rides on a wave of transverse velocity, which travels with the water and does not change for it: the
   sphere's velocity does not change. Each of the two parts of Du/Dt alone would change it by 60 % of the wave.
d  What spheres get, the water loses, also among many.
e  `auto` takes it for a sphere that is light in its fluid, and leaves it out for powder in air.
"""
import math

from harness.bench import main
from harness.case import Box, Case, fill
from harness.laws import Air, GRAVITY, Powder, stokes

WATER = Air(1000.0, 1e-3)
LIGHT = Powder(100e-6, 10.0, WATER, stokes)
PERIODIC = ("periodic",)*3
CLOSE = 1e-2
CONSERVED = 1e-10
ALONE = "virtualMass on; shearLift off; spinLift off; viscousForce off;"


def response(powder):
    """T [s]"""
    return (powder.density + 0.5*powder.air.density)*powder.diameter**2/(18*powder.air.viscosity)


def mass(powder):
    return powder.density*math.pi/6*powder.diameter**3


class Waves(Case):
    """Water with a velocity (c, V sin(2 pi x/L), 0), and, if asked for, a push on all of it."""

    def __init__(self, *words, speed=0.0, height=0.0, push=(0, 0, 0), **options):
        super().__init__(*words, lawName="Stokes", **options)
        self.speed, self.height, self.push = speed, height, push

    def wave(self, x):
        return self.height*math.sin(2*math.pi*x/self.box.size[0])

    def write(self, folder, ranks):
        super().write(folder, ranks)
        count = math.prod(self.box.cells)
        rows = [(self.speed, self.wave((i % self.box.cells[0] + 0.5)*self.box.cell[0]), 0) for i in range(count)]
        fill(folder/"0/U", "vector", [f"({u:.15g} {v:.15g} {w:.15g})" for u, v, w in rows])
        if any(self.push):
            text = (folder/"0/U").read_text().replace("object U", "object bodyForce")
            (folder/"0/bodyForce").write_text(text.replace("[0 1 -1 0 0 0 0]", "[0 1 -2 0 0 0 0]"))
            fill(folder/"0/bodyForce", "vector", ["(%g %g %g)" % self.push]*count)


def settings(powder, steps=40, span=2.0):
    """A run of `span` response times."""
    deltaT = span*response(powder)/steps
    return {"deltaT": deltaT, "subSteps": 4, "endTime": steps*deltaT}


def judgeRise(bench):
    edge = 0.01
    box = Box((edge,)*3, (5,)*3, ("noSlip",)*3)
    run = bench.run(Waves("rise", box, LIGHT, positions=[(edge/2,)*3], gravity=(0, 0, -GRAVITY),
                          airGravity=(0, 0, -GRAVITY), effects=ALONE, **settings(LIGHT)),
                    impulse=math.inf)
    final = (1000 - 10)*GRAVITY*LIGHT.diameter**2/(18*WATER.viscosity)
    for share in (0.1, 0.5, 1):
        time, _, grain, _ = run.budget()[round(share*40) - 1]
        bench.near(run, f"velocity at {time/response(LIGHT):.1f} T [m/s]",
                   final*-math.expm1(-time/response(LIGHT)), grain[2]/mass(LIGHT), CLOSE)
    rise = [(time/response(LIGHT), grain[2]/mass(LIGHT)/final) for time, _, grain, _ in run.budget()]
    bench.curve("light sphere in water", "t/T", "velocity, of the last", [(x/20, -math.expm1(-x/20)) for x in range(41)], rise)


def judgePush(bench):
    edge, push = 0.01, 10.0
    run = bench.run(Waves("push", Box((edge,)*3, (5,)*3, PERIODIC), LIGHT, positions=[(edge/2,)*3],
                          push=(push, 0, 0), effects=ALONE, **settings(LIGHT, 200)), impulse=math.inf)
    time, water, grain, _ = run.budget()[-1]
    still = LIGHT.density*LIGHT.diameter**2/(18*WATER.viscosity)*push
    slip = water[0]/(WATER.density*edge**3) - grain[0]/mass(LIGHT)
    bench.equal(run, "slip, of what all the water's mass would make", still/(51*still)*-math.expm1(
        -time/response(LIGHT)), slip/(51*still), CLOSE)


def judgeWave(bench):
    length, height, speed = 0.256, 0.01, 1.0
    thin = Powder(1e-3, 10.0, Air(1000.0, 1e-6), stokes)  # neither drag nor viscosity has a part
    case = Waves("wave", Box((length, 4e-3, 4e-3), (256, 1, 1), PERIODIC), thin, speed=speed, height=height,
                 effects=ALONE, deltaT=2.5e-4, subSteps=4, endTime=0.1*length/speed)
    case.positions = [(length*x + 1e-3, 2e-3, 2e-3) for x in (0.0, 0.25, 0.5, 0.6)]
    case.velocity = lambda x: (speed, case.wave(x[0]), 0)
    case.recordEvery = 4
    run = bench.run(case, impulse=math.inf)
    record = run.record()
    first, last = record[min(record)], record[max(record)]
    change = max(abs(last[i][1][1] - first[i][1][1]) for i in first)
    bench.equal(run, "change of velocity, of the wave's", 0, change/height, CLOSE)


def judgeMomentum(bench):
    edge = 8e-3
    beads = Powder(400e-6, 200.0, WATER, stokes)
    wave = Waves("momentum", Box((edge,)*3, (8,)*3, PERIODIC), beads, height=0.05, effects=ALONE,
                 positions=[(edge*(0.05 + 0.4*i/3), edge*(0.1 + 0.8*j/3), edge*(0.1 + 0.8*k/3))
                            for i in range(4) for j in range(4) for k in range(4)],
                 deltaT=5e-4, subSteps=4, endTime=1e-2)
    run = bench.run(wave, impulse=math.inf)
    first, last = run.budget()[0], run.budget()[-1]
    total = [air[1] + grains[1] - owed[1] for _, air, grains, owed in (first, last)]
    scale = max(abs(row[2][1]) for row in run.budget())
    bench.equal(run, "momentum gained, of the spheres' largest", 0, (total[1] - total[0])/scale, CONSERVED)


def judgeChoice(bench):
    edge = 0.01
    for name, powder, called in (("auto, bead", LIGHT, True), ("auto, powder", Powder(law=stokes), False)):
        run = bench.run(Waves(name, Box((edge,)*3, (5,)*3, PERIODIC), powder, positions=[(edge/2,)*3],
                              effects="", **settings(powder, 3, 0.1)), impulse=math.inf)
        bench.equal(run, "told to be simulated", called, "virtualMass is simulated" in run.log, 0)


def verify(bench):
    if bench.ranks == 1:
        judgeRise(bench)
        judgePush(bench)
        judgeWave(bench)
    judgeMomentum(bench)
    judgeChoice(bench)


if __name__ == "__main__":
    main(verify)
