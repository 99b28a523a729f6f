# SPDX-License-Identifier: GPL-3.0-or-later
"""A made-up flow through grains that do not move (case M5): the only exact solution with convection,
viscosity and drag in a void fraction that varies from place to place.

One parcel sits in the centre of each cell of a periodic box, so that all of it is in that cell, and is
just so large that the void fraction is a chosen smooth function. Of waves in x, y and z are made

    alpha u = w = W + curl(F)          so that div(alpha u) = 0
    p       = a sum of waves

and what the momentum equation of the air (steady, over its density) leaves over,

    alpha b = div(w u) + alpha grad(p) - div(alpha nu (grad u + grad u^T - 2/3 div u)) + K u/rho,

is given to the solver as the body force b. From the exact solution it goes to its own steady state. The
distance of the two must fall with the second power of the cell size: MFiX has orders from 1.98 to 2.4 in
the velocity (its case MMS03); here 1.9 is asked for, and of p as well. Convection is interpolated
linearly; upwind it must be of first order, or it would not be seen. A term that is wrong by 2 % spoils
the order of U, grad(p) that of p. All grids have one time step: what the fluxes remember of the step before
leaves a trace of second order in the steady state, whose factor depends on the step.

Parcels shrink with the cells, and so does the number k of grains along one: the grains themselves, and
K, stay. Grains as small as the finest cells resist far more than viscosity does, so that it is judged
among grains without mass: their drag takes the velocity that balances the pressure on them within a
step. So the air feels alpha_p grad(p) from them and nothing else, in all grad(p).
"""
import math

from harness.bench import main
from harness.case import Box, Case, fill, spaced
from harness.laws import Air, Powder, schillerNaumann

LENGTH = 1.0  # of the box [m]
WAVE = 2*math.pi/LENGTH
ORDER = 1.9
ORDER_OF_UPWIND = 1.5  # at most
HEAVY, WEIGHTLESS = 1e12, 1e-9  # density of the grains [kg/m3]: immovable, or without inertia
AXES = range(3)
COURANT = 0.5  # of the swiftest air
SCHEME = "div(alphaPhi,U) Gauss upwind"  # of the template


class Waves:
    """A sum of products of cosines, a cos(2 pi n_x x + f_x) cos(..y..) cos(..z..), which is known with
    all its derivatives."""

    def __init__(self, *terms):
        self.terms = terms  # (a, (n_x, n_y, n_z), (f_x, f_y, f_z))

    def along(self, axis):
        """The derivative in one direction."""
        terms = []
        for a, n, f in self.terms:
            turned = tuple(phase + (0.5*math.pi if i == axis else 0) for i, phase in enumerate(f))
            terms.append((a*n[axis]*WAVE, n, turned))
        return Waves(*(term for term in terms if term[0]))

    def __sub__(self, other):
        return Waves(*self.terms, *((-a, n, f) for a, n, f in other.terms))

    def __call__(self, x):
        total = 0.0
        for a, n, f in self.terms:
            for i in AXES:
                a *= math.cos(n[i]*WAVE*x[i] + f[i]) if n[i] else math.cos(f[i])
            total += a
        return total


def constant(value):
    return (value, (0, 0, 0), (0, 0, 0))


class Flow:
    """The made-up fields of a regime, at a place: alpha, u, p and the body force. In a flat one nothing
    varies along z."""

    def __init__(self, flat, density, grain, viscosity):
        n = deep = 0 if flat else 1  # waves along z, and whether they have a phase there
        self.alpha = Waves(constant(0.7), (0.1, (1, 1, n), (0.3, 1.1, 0.5*deep)),
                           (0.1, (1, 0, n), (2.0, 0.0, 1.7*deep)))
        potential = [
            Waves((0.07*deep, (1, 1, 1), (1.3, 0.2, 0.9))),
            Waves((0.06*deep, (1, 1, 1), (0.1, 2.2, 0.4))),
            Waves((0.08, (1, 1, n), (0.7, 1.9, 1.2*deep)), (0.03, (1, 2, 0), (0.5, 0.8, 0.0)))]
        self.w = []
        for i, mean in enumerate((0.8, 0.6, 0.4)):
            j, k = (i + 1) % 3, (i + 2) % 3
            curl = potential[k].along(j) - potential[j].along(k)
            self.w.append(Waves(constant(mean), *curl.terms))
        self.p = Waves((0.5, (1, 1, n), (0.4, 0.6, 2.1*deep)), (0.3, (0, 2, 0), (0.0, 1.0, 0.0)))
        self.powder = Powder(grain, density, Air(1.0, viscosity), schillerNaumann)
        self.alphaSlopes = [self.alpha.along(i) for i in AXES]
        self.alphaBends = [[slope.along(j) for j in AXES] for slope in self.alphaSlopes]
        self.slopes = [[w.along(i) for i in AXES] for w in self.w]
        self.bends = [[[slope.along(j) for j in AXES] for slope in slopes] for slopes in self.slopes]
        self.push = [self.p.along(i) for i in AXES]

    def diameter(self, alpha):
        """Of the grains: parcels fill a share 1 - alpha of their cells, whatever the cells' size."""
        return self.powder.diameter*(6*(1 - alpha)/math.pi)**(1/3)

    def resistance(self, alpha, speed):
        """K over the air's density [1/s]."""
        grain = Powder(self.diameter(alpha), air=self.powder.air, law=self.powder.law)
        return (1 - alpha)*grain.B(alpha, speed)/grain.air.density

    def at(self, x):
        """alpha, u, p and b."""
        alpha, w = self.alpha(x), [w(x) for w in self.w]
        da = [slope(x) for slope in self.alphaSlopes]
        u = [component/alpha for component in w]
        # du[i][j] = d(u_i)/d(x_j), from alpha u = w; and once more for ddu.
        du = [[(self.slopes[i][j](x) - u[i]*da[j])/alpha for j in AXES] for i in AXES]
        bends = [[bend(x) for bend in row] for row in self.alphaBends]
        ddu = [[[(self.bends[i][j][k](x) - du[i][j]*da[k] - du[i][k]*da[j] - u[i]*bends[j][k])/alpha
                 for k in AXES] for j in AXES] for i in AXES]
        nu = self.powder.air.viscosity/self.powder.air.density
        heavy = self.powder.density == HEAVY
        drag = self.resistance(alpha, math.hypot(*u)) if heavy else 0.0
        pressed = alpha if heavy else 1.0
        divergence = sum(du[i][i] for i in AXES)
        force = []
        for i in AXES:
            convection = sum(w[j]*du[i][j] for j in AXES)
            strained = sum((du[i][j] + du[j][i])*da[j] for j in AXES) - 2/3*divergence*da[i]
            spread = sum(ddu[i][j][j] + ddu[j][i][j]/3 for j in AXES)
            force.append((convection + pressed*self.push[i](x) - nu*(strained + alpha*spread)
                          + drag*u[i])/alpha)
        return alpha, u, self.p(x), force


class Made(Case):
    """Starts from the exact solution of a flow, with a parcel to fit in each cell."""
    exact = ()
    scheme = "linear"

    def grains(self):
        head, tail = super().grains().split("Atoms\n\n")
        lines = tail.splitlines()
        volume = math.prod(self.box.cell)
        for i, (alpha, *_) in enumerate(self.exact):
            columns = lines[i].split()
            columns[2] = format((6/math.pi*(1 - alpha)*volume)**(1/3), ".15g")
            lines[i] = " ".join(columns)
        return head + "Atoms\n\n" + "\n".join(lines) + "\n"

    def write(self, folder, ranks):
        super().write(folder, ranks)
        _, u, p, force = zip(*self.exact)
        fill(folder/"0/U", "vector", [f"({spaced(v)})" for v in u])
        fill(folder/"0/p", "scalar", [format(v, ".15g") for v in p])
        text = (folder/"0/U").read_text().replace("object U", "object bodyForce")
        (folder/"0/bodyForce").write_text(text.replace("[0 1 -1 0", "[0 1 -2 0"))
        fill(folder/"0/bodyForce", "vector", [f"({spaced(v)})" for v in force])
        path = folder/"system/fvSchemes"
        assert SCHEME in path.read_text(), "another scheme than the template had"
        path.write_text(path.read_text().replace(SCHEME, SCHEME.replace("upwind", self.scheme)))


def made(name, flow, cells, flat, endTime, **options):
    edge = LENGTH/cells
    counts = (cells, cells, 1 if flat else cells)
    box = Box(tuple(n*edge for n in counts), counts)
    centres = [tuple((i + 0.5)*edge for i in (x, y, z)) for z in range(counts[2])
               for y in range(cells) for x in range(cells)]
    exact = [flow.at(x) for x in centres]
    swiftest = max(sum(map(abs, u)) for _, u, _, _ in exact)
    steps = math.ceil(endTime*swiftest/(COURANT*edge))
    return Made(f"{name}, {cells}", box, flow.powder, exact=exact, positions=centres, motion="frozen",
                lawName="SchillerNaumann", k=edge/flow.powder.diameter, minimum=0.3,
                slices="x", deltaT=endTime/steps, endTime=endTime, timeStep="stabilityLimit 1e30;", **options)


def distance(measured, exact):
    """Root mean square over the cells, which are all alike, of that of the exact field."""
    squares = sum(math.dist(a, b)**2 for a, b in zip(measured, exact))
    return math.sqrt(squares/sum(math.hypot(*b)**2 for b in exact))


def levelled(values):
    """Without their mean."""
    mean = math.fsum(values)/len(values)
    return [(value - mean,) for value in values]


def errors(run):
    """Of U and p."""
    alpha, u, p, _ = zip(*run.case.exact)
    return (distance(run.field("U"), u), distance(levelled(run.field("p")), levelled(p)),
            max(abs(a - b) for a, b in zip(run.field("voidFraction"), alpha)))


REGIMES = {  # flat, density and size of the grains, viscosity [m2/s], grids, time to settle [s]
    "all terms": (False, HEAVY, 1/24, 0.005, (8, 16, 24), 0.4),
    "viscosity": (True, WEIGHTLESS, 1/64, 0.05, (16, 32, 64), 0.75),
    "convection": (True, HEAVY, 1/64, 2e-4, (16, 32, 64), 0.25),
    "drag": (True, HEAVY, 1/64, 0.01, (16, 32, 64), 0.05)}


def orders(bench, regime, grids, **options):
    """Of U and p between the two finest grids; and the run on the finest."""
    flat, density, grain, viscosity, _, endTime = REGIMES[regime]
    flow = Flow(flat, density, grain, viscosity)
    name = ", ".join([regime, *options.values()])
    found = []
    cases = [made(name, flow, cells, flat, endTime, **options) for cells in grids]
    for case in cases:
        case.deltaT = cases[-1].deltaT
        run = bench.run(case, impulse=math.inf)
        found.append(errors(run))
        bench.atMost(run, "void fraction off the chosen one", 1e-12, found[-1][2])
        bench.equal(run, "error of U, L2, of U", 0, found[-1][0], math.inf)
        bench.equal(run, "error of p, L2, of p", 0, found[-1][1], math.inf)
    for word, which in (("U", 0), ("p", 1)) if not options else ():
        bench.curve(f"{name}, {word}", "cells along an edge", "error, L2 (line: order 2)", [
            (n, found[-1][which]*(grids[-1]/n)**2) for n in grids], [(n, one[which]) for n, one in zip(grids, found)], log=True)
    finer = math.log(grids[-1]/grids[-2])
    return [math.log(a/b)/finer for a, b in zip(found[-2], found[-1])][:2], run


def verify(bench):
    for regime, (*_, grids, _) in REGIMES.items():
        (ofU, ofP), run = orders(bench, regime, grids)
        bench.atLeast(run, "order of U, at least", ORDER, ofU)
        bench.atLeast(run, "order of p, at least", ORDER, ofP)
    (ofU, _), run = orders(bench, "convection", (16, 32), scheme="upwind")
    bench.atMost(run, "order of U, at most", ORDER_OF_UPWIND, ofU)


if __name__ == "__main__":
    main(verify)
