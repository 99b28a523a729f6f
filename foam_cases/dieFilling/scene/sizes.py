# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of the powder's particles: a few classes, for LIGGGHTS and for what follows from one diameter.

A class has a share of the mass and one diameter, that of its particle of mean volume. So it has both the mass and the
number of particles of its part of the distribution. Diameters here are those of particles, not of parcels.
"""
import math
from statistics import NormalDist

import numpy as np

import sizeTable
from wrong import refuse, word

FILE = "system/caseParameters"
KINDS = ("mono", "logNormal", "table")
MEANINGS = ("sauterMean", "medianByMass", "medianByNumber")


class Sizes:
    """Diameters of the classes [m], ascending, and their shares of the mass."""

    def __init__(self, diameters, masses):
        self.diameters = np.asarray(diameters, float)
        self.masses = np.asarray(masses, float)/np.sum(masses)

    def numbers(self):
        """Shares of the number of particles."""
        numbers = self.masses/self.diameters**3
        return numbers/numbers.sum()

    def sauter(self):
        """d32, six volumes over surface: what resistance to air goes with."""
        return 1/float(np.sum(self.masses/self.diameters))

    def meanVolume(self):
        """d30, diameter of the particle of mean volume: says how many particles a mass has."""
        return float(np.sum(self.masses/self.diameters**3))**(-1/3)


def read(case, p):
    """Sizes as the parameters say; none if all particles have the same."""
    kind = word("sizeDistribution", p["sizeDistribution"], KINDS)
    meaning = word("diameterIs", p["diameterIs"], MEANINGS)
    if kind == "mono":
        return None
    if kind == "table":
        return ofTable(case, p, meaning)
    check(p)
    return ofLogNormal(p, meaning)


def ofTable(case, p, meaning):
    path = case/str(p["sizeTable"])
    sizes = Sizes(*sizeTable.classes(path, p["sizeTable"]))
    if meaning != "sauterMean" or abs(sizes.sauter()/p["particleDiameter"] - 1) > 0.01:
        refuse("particleDiameter must be the Sauter mean of the size table, as dimensionless numbers are made with it.",
               f"particleDiameter {p['particleDiameter']:.4g}, diameterIs {meaning}   {FILE}",
               f"{sizes.sauter():.4g} m, as {p['sizeTable']} has it",
               f"Write particleDiameter {sizes.sauter():.4g} and diameterIs sauterMean.")
    return sizes


def check(p):
    """Of a log-normal distribution."""
    rules = (("geometricDeviation", "a number above 1 (1: all alike, that is sizeDistribution mono)", lambda x: x > 1),
             ("sizeClasses", "a whole number from 2 to 100", lambda x: 2 <= x <= 100 and x == int(x)),
             ("smallestSize", "a number above 0 and below 1, in particleDiameter", lambda x: 0 < x < 1),
             ("largestSize", "a number above 1, in particleDiameter", lambda x: x > 1))
    for key, wanted, good in rules:
        if not (isinstance(p[key], float) and math.isfinite(p[key]) and good(p[key])):
            refuse(f"{key} of a log-normal size distribution is out of range.", f"{key} {p[key]}   {FILE}",
                   wanted, f"Correct {key}.")


def ofLogNormal(p, meaning):
    """Log-normal between the smallest and the largest size. A Sauter mean is met exactly, by the classes; a
    median is that of the distribution before its ends are cut off."""
    d, s = p["particleDiameter"], math.log(p["geometricDeviation"])
    ends = p["smallestSize"]*d, p["largestSize"]*d
    made = lambda median: equalMasses(median, s, ends, int(p["sizeClasses"]))
    if meaning == "medianByMass":
        return made(d)
    if meaning == "medianByNumber":
        return made(d*math.exp(3*s*s))
    low, high = math.log(d) - 3*s, math.log(d) + 3*s
    if not made(math.exp(low)).sauter() < d < made(math.exp(high)).sauter():
        refuse("No log-normal distribution of this width has this Sauter mean between these ends.",
               f"geometricDeviation {p['geometricDeviation']:g}, smallestSize {p['smallestSize']:g}, largestSize "
               f"{p['largestSize']:g}   {FILE}", "ends on both sides of the mean, about alike in their ratio to it",
               "Lower smallestSize or raise largestSize.")
    while high - low > 1e-14*abs(low):
        middle = 0.5*(low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if made(math.exp(middle)).sauter() < d else (low, middle)
    return made(math.exp(0.5*(low + high)))


def equalMasses(median, s, ends, count):
    """Classes of equal mass. In ln d, mass is normal about the median by mass, and number about 3 s^2 less (T. Hatch &
    S. P. Choate, J. Franklin Inst. 207 (1929) 369-387)."""
    mass = NormalDist(math.log(median), s)
    number = NormalDist(mass.mean - 3*s*s, s)
    first, last = (mass.cdf(math.log(end)) for end in ends)
    inner = [mass.inv_cdf(p) for p in np.linspace(first, last, count + 1)[1:-1]]
    edges = [math.log(ends[0]), *inner, math.log(ends[1])]
    particles = np.diff([number.cdf(edge) for edge in edges])
    meanVolume = math.exp(3*mass.mean - 4.5*s*s)
    return Sizes((meanVolume*(last - first)/count/particles)**(1/3), np.full(count, 1/count))


def told(sizes, *beds):
    """One line; refuses a class too rare for its share of the mass to be poured. beds: how many parcels they have."""
    fewest = min(beds)*float(sizes.numbers().min())
    if fewest < 1:
        refuse("A class of particle sizes has less than one parcel.",
               f"{fewest:.2g} of {1e6*sizes.diameters[sizes.numbers().argmin()]:.3g} um, of {min(beds)} parcels",
               "1 or more", "Lower coarseGraining, largestSize or sizeClasses, or join rare sizes of the table.")
    um = 1e6*sizes.diameters
    return (f"sizes: {len(um)} classes from {um[0]:.4g} to {um[-1]:.4g} um, Sauter mean "
            f"{1e6*sizes.sauter():.4g} um, at least {fewest:.0f} parcels in each")


def script(sizes, k, seed):
    """What LIGGGHTS inserts, as the distribution `mix`; its shares are of mass."""
    if sizes is None:
        return ("fix             parcel all particletemplate/sphere 160481183 atom_type 1 &\n"
                "                density constant ${particleDensity} radius constant ${parcelRadius}\n"
                "fix             mix all particledistribution/discrete 179424673 1 parcel 1.0\n")
    lines, shares = [], []
    seeds = primes(160481183, {int(seed), 179424673})
    for i, (d, mass) in enumerate(zip(sizes.diameters, sizes.masses), 1):
        lines += [f"fix             parcel{i} all particletemplate/sphere {next(seeds)} atom_type 1 &",
                  f"                density constant ${{particleDensity}} radius constant {0.5*k*d:.9g}"]
        shares.append(f"parcel{i} {mass:.9g}")
    lines.append(f"fix             mix all particledistribution/discrete 179424673 {len(shares)} &")
    return "\n".join(lines) + "\n                " + " &\n                ".join(shares) + "\n"


def primes(n, taken):
    """From n on, without those taken: LIGGGHTS wants each seed to be another prime."""
    while True:
        if n not in taken and all(n % i for i in range(2, math.isqrt(n) + 1)):
            yield n
        n += 1
