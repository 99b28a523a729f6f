# SPDX-License-Identifier: GPL-3.0-or-later
"""The particle engine, alone: LIGGGHTS against closed forms and against paths integrated here.

DEM01  a sphere falls on a plane and rebounds: three stages in closed form. Cases DEM01 to DEM04
       are those of the MFiX verification manual. For e = 1 the softest spring is 2.5e4 N/m: with
       1e4 the sphere's centre would pass the plane (delta = 1.04 r).
DEM02  it bounces on: peaks of hard spheres, r + (h0 - r) e^2k, and, sharper, of the spring.
DEM03  two spheres, pressed between two planes, are let go.
DEM04  a ball slides on a plane until it rolls: t = 2 u0/(7 mu g), v = 5/7 u0. With a rolling torque
       that is limited to mu_r r m g (epsd2) it slides for t = u0/(g (3.5 mu - 2.5 mu_r)), then
       slows down by 5/7 mu_r g: m v' = -F and 2/5 m r^2 v'/r = F r - mu_r r m g.
Hertz  an impact with the contact of the die filling study, as grain and as parcel of 1000 grains.
       Restitution is exact when the contact ends at zero overlap; with limitForce it ends as soon
       as spring and dashpot would pull, and the rebound is faster.
gas    1000 elastic smooth spheres without weight keep their energy over 100 collisions of each
       (Enskog's rate).

Linear contact: k delta + gamma m* v with v the closing speed and gamma = 2 b sqrt(k/m*),
b = -ln e/sqrt(pi^2 + ln^2 e); m* is the mass of the sphere at a plane. Hertz: spring
4/3 E* sqrt(R*) delta^1.5 and dashpot 2 sqrt(5/6) b sqrt(2 E* sqrt(R* delta) m*) v, with
E* = E/(2 (1 - nu^2)) for equal materials.

On several ranks fewer impacts are run: each is a single sphere, with nothing to share out.
"""
import math
import pathlib
import random

from dem.run import G, Run, dampingRatio, linear, mass, perSphere
from harness.bench import main
from harness.case import AXES
from harness.laws import root

CONTACTS = pathlib.Path(__file__).resolve().parents[2]/"liggghts_scripts/contacts.in"

PATH = 1e-3
FIRST_PEAK, LATER_PEAK = 1e-2, 1e-1  # of hard spheres: a contact takes time
STACK = 1e-4
SLIP = 5e-3
IMPACT = 1e-3
KINETIC, ENERGY = 1e-2, 1e-3

BALL, BALL_DENSITY, BALL_HEIGHT = 0.1, 2600.0, 0.5  # DEM01, DEM02: radius, height of centre [m]
MFIX_CONTACT = (0.285617, 2.800950)  # time [s] and speed [m/s]
MFIX_PEAKS = {1: 0.42400, 2: 0.36244, 3: 0.312576, 4: 0.272187, 5: 0.239471, 10: 0.148631}
MFIX_STACK = {0.00010288: 0.43201e-3, 0.00017039: 0.42334e-3, 0.0003022: 0.43322e-3}  # e = 1

GRAIN, GRAIN_DENSITY, YOUNG, POISSON, SPEED = 400e-6, 7360.0, 1e8, 0.3, 0.3
# By e: largest overlap over diameter, duration [s], rebound with limitForce; to three digits.
IMPACTS = {1.0: (0.00931, 3.655e-5, 1.0), 0.5: (0.00733, 3.996e-5, 0.5503),
           0.9: (None, None, 0.902), 0.3: (None, None, 0.397), 0.1: (None, None, 0.253)}
SPREAD, COLLISIONS = 0.1, 100  # of the gas: velocity along an axis [m/s], collisions of a sphere


def rk4(rate, state, step):
    def moved(slope, by):
        return [x + by*s for x, s in zip(state, slope)]
    a = rate(state)
    b = rate(moved(a, step/2))
    c = rate(moved(b, step/2))
    d = rate(moved(c, step))
    return [x + step/6*(p + 2*q + 2*r + s) for x, p, q, r, s in zip(state, a, b, c, d)]


class Bounce:
    """Contact of a sphere with a plane that it meets at a speed."""

    def __init__(self, radius, weight, k, e, speed):
        self.radius = radius
        self.omega = math.sqrt(k/weight)
        self.b = dampingRatio(e)
        self.damped = self.omega*math.sqrt(1 - self.b**2)
        self.speed = speed
        # It still touches after half a period, and has left after three quarters.
        self.duration = root(lambda t: self.height(t) - radius, math.pi/self.damped,
                             1.5*math.pi/self.damped)
        tiny = 1e-6*self.duration
        self.rebound = (self.height(self.duration) - self.height(self.duration - tiny))/tiny

    def height(self, t):
        sag = G/self.omega**2
        swing = (self.b*G/self.omega - self.speed)/self.damped
        return self.radius - sag + math.exp(-self.b*self.omega*t)*(
            sag*math.cos(self.damped*t) + swing*math.sin(self.damped*t))


def drop(bench, name, cases, step, end):
    """Balls (k, e) side by side, let go at once."""
    spheres = [(i, 2*BALL, BALL_DENSITY, (0.3*i, 0, BALL_HEIGHT), (0, 0, 0))
               for i in range(1, len(cases) + 1)]
    box = ((0, -0.2, -0.05), (0.3*(len(cases) + 1), 0.2, 0.7))
    return linear(bench, name, spheres, box, (step, round(end/step), 100),
                  perSphere([k for k, _ in cases]), perSphere([e for _, e in cases]))


def freeFall(bench):
    cases = [(2.5e4, 1.0), (1e5, 1.0), (1e4, 0.8), (1e5, 0.8), (1e4, 0.6), (1e5, 0.6)]
    run = drop(bench, "DEM01", cases, 5e-6, 0.6)
    for i, (k, e) in enumerate(cases):
        for stage, (start, stop, exact) in stages(k, e).items():
            worst = max(abs(row[2]/exact(t) - 1) for t, row in run.track(i) if start <= t < stop)
            bench.atMost(run, f"k {k:g}, e {e:g}: {stage}, error of y", PATH, worst)


def stages(k, e):
    """First and last time, and the height by time."""
    touch = math.sqrt(2*(BALL_HEIGHT - BALL)/G)
    speed = G*touch
    assert abs(touch - MFIX_CONTACT[0]) < 1e-6 and abs(speed - MFIX_CONTACT[1]) < 1e-6
    bounce = Bounce(BALL, mass(2*BALL, BALL_DENSITY), k, e, speed)
    leave = touch + bounce.duration
    return {"fall": (0, touch, lambda t: BALL_HEIGHT - G/2*t**2),
            "contact": (touch, leave, lambda t: bounce.height(t - touch)),
            "rebound": (leave, math.inf,
                        lambda t: BALL + bounce.rebound*(t - leave) - G/2*(t - leave)**2)}


def bouncing(bench):
    k, e = 1e6, 0.9
    run = drop(bench, "DEM02", [(k, e)], 1e-5, 3.9)
    heights = [row[2] for _, row in run.track(0)]
    peaks = [b for a, b, c in zip(heights, heights[1:], heights[2:]) if a < b >= c]
    speed = math.sqrt(2*G*(BALL_HEIGHT - BALL))
    for n in range(1, 11):
        speed = Bounce(BALL, mass(2*BALL, BALL_DENSITY), k, e, speed).rebound
        hard = BALL + (BALL_HEIGHT - BALL)*e**(2*n)
        assert n not in MFIX_PEAKS or abs(hard/MFIX_PEAKS[n] - 1) < 1e-5
        bench.near(run, f"peak {n}, hard sphere [m]", hard, peaks[n - 1],
                   FIRST_PEAK if n == 1 else LATER_PEAK)
        bench.near(run, f"peak {n}, with the spring [m]", BALL + speed**2/(2*G), peaks[n - 1], PATH)


def stackPath(radius, masses, k, e, gap, state, step, steps):
    """[(y1, y2, v1, v2)] at each step of two spheres between planes, by RK4."""
    both = masses[0]*masses[1]/sum(masses)

    def force(overlap, closing, m):
        return k*overlap + 2*dampingRatio(e)*math.sqrt(k*m)*closing if overlap > 0 else 0.0

    def rate(state):
        y1, y2, v1, v2 = state
        low = force(radius - y1, -v1, masses[0])
        middle = force(2*radius - (y2 - y1), v1 - v2, both)
        high = force(y2 + radius - gap, v2, masses[1])
        return v1, v2, (low - middle)/masses[0] - G, (middle - high)/masses[1] - G

    path = [state]
    for _ in range(steps):
        path.append(rk4(rate, path[-1], step))
    return path


def stacked(bench):
    radius, k, gap, heights, densities = 0.5e-3, 1e3, 1.8e-3, (0.45e-3, 1.35e-3), (2e4, 1e4)
    step, steps, every = 5e-8, 6200, 20
    spheres = [(i, 2*radius, rho, (0, 0, y), (0, 0, 0))
               for i, (rho, y) in enumerate(zip(densities, heights), 1)]
    box = ((-1e-3, -1e-3, 0), (1e-3, 1e-3, gap))
    for e in (1.0, 0.8, 0.5):
        run = linear(bench, f"DEM03, e {e:g}", spheres, box, (step, steps, every),
                     lambda i, j: k, lambda i, j: e, ceiling=gap)
        path = stackPath(radius, [mass(s[1], s[2]) for s in spheres], k, e, gap, [*heights, 0, 0],
                         every*step, steps//every)
        for i in (0, 1):
            worst = max(abs(row[2]/state[i] - 1) for (_, row), state in zip(run.track(i), path))
            bench.atMost(run, f"y{i + 1}, error to RK4", STACK, worst)
        for moment, height in MFIX_STACK.items() if e == 1 else ():
            bench.near(run, f"y1 at {1e3*moment:g} ms [m]", height, run.position(0, moment, 2),
                       STACK)


def slide(bench, name, frictions, end, rollingFriction=0.0):
    """Balls that touch the plane and are pushed along it, and the speed given to them."""
    diameter, density, k, push = 1e-3, 2600.0, 1e3, 0.1
    weight = mass(diameter, density)
    rest = diameter/2 - weight*G/k
    spheres = [(i, diameter, density, (1e-3, 2e-3*i, rest), (push, 0, 0))
               for i in range(1, len(frictions) + 1)]
    box = ((0, 0, -1e-3), (10e-3, 2e-3*(len(frictions) + 1), 2e-3))
    return push, linear(bench, name, spheres, box, (2e-6, round(end/2e-6), 2),
                        lambda i, j: k, lambda i, j: 0.5, friction=perSphere(frictions),
                        rollingFriction=rollingFriction)


def grip(track, radius):
    """Time, velocity and velocity of rolling where slip ends."""
    for (t0, a), (t1, b) in zip(track, track[1:]):
        slips = [row[3] - row[6]*radius for row in (a, b)]
        if slips[1] <= 1e-4*track[0][1][3]:
            share = slips[0]/(slips[0] - slips[1])
            return (t0 + share*(t1 - t0), *(a[n] + share*(b[n] - a[n]) for n in (3, 6)))
    raise ValueError("it never rolls")


def slipping(bench):
    frictions = [0.2, 0.4, 0.6, 0.8, 1.0]
    push, run = slide(bench, "DEM04", frictions, 0.018)
    for i, mu in enumerate(frictions):
        moment, v, omega = grip(run.track(i), 0.5e-3)
        bench.near(run, f"mu {mu:g}: end of sliding, of u0/(mu g)", 2/7, moment*mu*G/push, SLIP)
        bench.near(run, f"mu {mu:g}: v there, of u0", 5/7, v/push, SLIP)
        bench.near(run, f"mu {mu:g}: omega r there, of u0", 5/7, omega*0.5e-3/push, SLIP)


def rolling(bench):
    mu, resistance, radius = 0.5, 0.218, 0.5e-3
    push, run = slide(bench, "DEM04, epsd2", [mu], 0.06, resistance)
    end = push/(G*(3.5*mu - 2.5*resistance))
    speed = push - mu*G*end
    moment, v, _ = grip(run.track(0), radius)
    bench.near(run, "end of sliding, of u0/(mu g)", end*mu*G/push, moment*mu*G/push, SLIP)
    bench.near(run, "v there, of u0", speed/push, v/push, SLIP)
    # The ways of two parts of equal time, to be blind to the swing of slip about rolling.
    duration = speed/(5/7*resistance*G)
    first, middle, last = (run.position(0, end + part*duration, 0) for part in (0.1, 0.5, 0.9))
    bench.near(run, "slowing down as it rolls, of g", 5/7*resistance,
               (2*middle - first - last)/(0.4*duration)**2/G, SLIP)
    bench.near(run, "way to rest [m]", (push + speed)/2*end + speed/2*duration,
               run.records[-1][1][0][0] - run.records[0][1][0][0], SLIP)


def study(**values):
    """Settings of contacts.in for smooth powder with walls."""
    settings = dict(contacts=CONTACTS, youngsModulus=YOUNG, wallYoungsModulus=YOUNG,
                    poissonsRatio=POISSON, friction=0, rollingFriction=0, rollingModel="off")
    settings.update(values)
    return dict(settings, wallRestitution=settings["restitution"], particleDensity=GRAIN_DENSITY)


def hertzPath(diameter, e):
    """Largest overlap, duration, and rebound if nothing pulls at the end, by RK4."""
    rootOfRadius, weight = math.sqrt(diameter/2), mass(diameter, GRAIN_DENSITY)
    modulus = YOUNG/(2*(1 - POISSON**2))
    dashpot = 2*math.sqrt(5/6)*dampingRatio(e)*math.sqrt(2*modulus*rootOfRadius*weight)

    def push(overlap, closing):
        overlap = max(overlap, 0.0)
        return 4/3*modulus*rootOfRadius*overlap**1.5 + dashpot*overlap**0.25*closing

    step = 1e-5*diameter/SPEED
    path = [[0.0, SPEED]]
    while path[-1][0] >= 0:
        path.append(rk4(lambda s: (s[1], -push(*s)/weight), path[-1], step))
    before, after = path[-2][0], path[-1][0]
    pushed = [closing for overlap, closing in path if push(overlap, closing) > 0]
    return (max(overlap for overlap, _ in path), (len(path) - 2 + before/(before - after))*step,
            -pushed[-1]/SPEED)


def impact(bench, e, k):
    """Two spheres, one to each of two planes; only the upper plane has limitForce."""
    diameter = k*GRAIN
    gap, height = 1e-3*diameter, 4*diameter
    spheres = [(1, diameter, GRAIN_DENSITY, (0, 0, diameter/2 + gap), (0, 0, -SPEED)),
               (1, diameter, GRAIN_DENSITY, (0, 0, height - diameter/2 - gap), (0, 0, SPEED))]
    box = ((-diameter, -diameter, 0), (diameter, diameter, height))
    run = Run(bench, f"Hertz, k {k:g}, e {e:g}", "impact.in", spheres, box, (1e-8*k, 6500, 1), 2,
              height=height, **study(restitution=e, parcelRadius=diameter/2))
    overlaps = [(t, diameter/2 - row[2]) for t, row in run.track(0)]
    edges = [t0 + (t1 - t0)*a/(a - b) for (t0, a), (t1, b) in zip(overlaps, overlaps[1:])
             if a*b <= 0]
    largest, duration, limited = hertzPath(diameter, e)
    for printed, exact in zip(IMPACTS[e], (largest/diameter, duration/k, limited)):
        assert printed is None or abs(exact/printed - 1) < 2e-3
    bench.near(run, "largest overlap, of d", largest/diameter,
               max(o for _, o in overlaps)/diameter, IMPACT)
    bench.near(run, "duration over k [s]", duration/k, (edges[1] - edges[0])/k, IMPACT)
    bench.near(run, "rebound", e, run.track(0)[-1][1][5]/SPEED, IMPACT)
    bench.near(run, "rebound, limitForce", limited, -run.track(1)[-1][1][5]/SPEED, IMPACT)


def flying(count, share):
    """A lattice of spheres with random velocities and no momentum, the length of its cube, and the
    collisions of a sphere per second."""
    edge = round(count**(1/3))
    spacing = (math.pi/6/share)**(1/3)*GRAIN
    rng = random.Random(8)
    places = [tuple((n + 0.5)*spacing for n in (i, j, k))
              for i in range(edge) for j in range(edge) for k in range(edge)]
    speeds = [[rng.gauss(0, SPREAD) for _ in AXES] for _ in places]
    means = [sum(v[a] for v in speeds)/len(speeds) for a in range(3)]
    spheres = [(1, GRAIN, GRAIN_DENSITY, x, [v[a] - means[a] for a in range(3)])
               for x, v in zip(places, speeds)]
    crowding = (1 - share/2)/(1 - share)**3
    rate = 24*share*crowding*SPREAD/(math.sqrt(math.pi)*GRAIN)
    return spheres, edge*spacing, rate


def kinetic(rows):
    return mass(GRAIN, GRAIN_DENSITY)/2*sum(v*v for row in rows for v in row[3:6])


def elastic(rows, length):
    """Energy in the springs: 2/5 of 4/3 E* sqrt(R*) delta^2.5 a contact."""
    factor = 8/15*YOUNG/(2*(1 - POISSON**2))*math.sqrt(GRAIN/4)
    energy = 0.0
    for i, a in enumerate(rows):
        for b in rows[:i]:
            gap = sum((d - length*round(d/length))**2 for d in (a[n] - b[n] for n in range(3)))
            if gap < GRAIN**2:
                energy += factor*(GRAIN - math.sqrt(gap))**2.5
    return energy


def gas(bench):
    spheres, length, rate = flying(1000, 0.3)
    step = 2e-6
    every = round(1/(rate*step))
    run = Run(bench, "gas", "gas.in", spheres, ((0, 0, 0), (length, length, length)),
              (step, (COLLISIONS + 2)*every, every), 2, boundary="p p p", skin=0.1*GRAIN,
              **study(restitution=1.0, parcelRadius=GRAIN/2))
    energies = [kinetic(rows) for _, rows in run.records]
    early, late = (sum(part)/10 for part in (energies[2:12], energies[-10:]))
    bench.near(run, "kinetic energy after 100 collisions [J]", early, late, KINETIC)
    last = run.records[-1][1]
    bench.near(run, "with that in the springs [J]", energies[0],
               energies[-1] + elastic(last, length), ENERGY)
    drift = math.hypot(*(sum(row[n] for row in last) for n in (3, 4, 5)))
    bench.atMost(run, "mean velocity, of the spread", 1e-9, drift/len(last)/SPREAD)


def verify(bench):
    freeFall(bench)
    bouncing(bench)
    stacked(bench)
    slipping(bench)
    rolling(bench)
    for e in IMPACTS if bench.ranks == 1 else (0.5,):
        impact(bench, e, 1)
    impact(bench, 0.5, 10)
    gas(bench)


if __name__ == "__main__":
    main(verify)
