# SPDX-License-Identifier: GPL-3.0-or-later
"""Cohesion by van der Waals forces between asperities, as LIGGGHTS' model sjkr2.

Two grains whose asperities of radius r are a gap z0 apart pull with A r/(6 z0^2) [H.C. Hamaker, Physica 4 (1937)
1058-1072]; so do a grain and a wall. sjkr2 pulls with a delta for an overlap delta, against Hertz' force b delta^1.5,
b = 4/3 E* sqrt(R*): at most with 4 a^3/(27 b^2), at delta = (2 a/(3 b))^2. Here a = 4 pi R* c between spheres, as LIGGGHTS'
manual has it, and 2 pi R* c at a wall, as is found (A19Cohesion). The cohesion energy density c is chosen so that the
largest pull is that of a grain times k^2 or k^3.
"""
import math

from wrong import refuse, word

POWERS = {"stress": 2, "weight": 3}


def require(p, wish):
    """What `on` and `auto` reckon with, and `off` warns by."""
    for key, unit, zero in (("hamaker", "J", True), ("asperityRadius", "m", False), ("contactGap", "m", False)):
        value = p.get(key)
        if not isinstance(value, float) or value < 0 or value == 0 and not zero:
            refuse("Van der Waals forces are reckoned from three numbers.",
                   f"cohesion {wish}, {f'no {key}' if value is None else f'{key} {value}'}   system/caseParameters",
                   f"{key} of {'0' if zero else 'more than 0'} {unit}{' or more' if zero else ''}",
                   f"Give {key} a value; cohesion off wants it too, to warn where grains would stick.")


def pull(p):
    """Of a grain [N]."""
    return p["hamaker"]*p["asperityRadius"]/(6*p["contactGap"]**2)


def bondNumber(p):
    """That over a grain's weight."""
    return pull(p)/(math.pi/6*p["particleDiameter"]**3*p["particleDensity"]*9.81)


def derived(p):
    """cohesionModel, off or sjkr2; cohesionEnergyDensity of parcels, wallCohesionEnergyDensity of parcels and walls [Pa]; zero without cohesion."""
    wish = word("cohesion", p["cohesion"], ("auto", "on", "off"))
    word("cohesionScaling", p["cohesionScaling"], ("none", *POWERS))
    require(p, wish)
    k, bond = p["coarseGraining"], bondNumber(p)
    on = wish == "on" or wish == "auto" and bond > 1
    if not on:
        if wish == "off" and bond > 1:
            print(f"cohesion is off, and would matter: van der Waals force over weight is {bond:.2g}")
        return {"cohesionModel": "off", "cohesionEnergyDensity": 0, "wallCohesionEnergyDensity": 0}
    if k > 1 and p["cohesionScaling"] == "none":
        refuse("Cohesion of parcels needs a rule by which it grows with them.",
               f"cohesion {wish}, coarseGraining {k:g}, cohesionScaling none   system/caseParameters",
               "cohesionScaling stress or weight",
               "stress: k^2 of a grain's force, as stresses in a bed have it; weight: k^3, as a parcel that falls off a "
               "surface has it.")
    print(f"cohesion: van der Waals force over weight is {bond:.2g}")
    force = k**POWERS.get(p["cohesionScaling"], 0)*pull(p)
    radius = 0.5*k*p["particleDiameter"]
    modulus = lambda young: young/(1 - p["poissonsRatio"]**2)
    parcels = modulus(p["youngsModulus"])/2
    wall = 1/(1/modulus(p["youngsModulus"]) + 1/modulus(p["wallYoungsModulus"]))
    return {"cohesionModel": "sjkr2", "cohesionEnergyDensity": density(force, 0.5*radius, parcels, 4*math.pi),
            "wallCohesionEnergyDensity": density(force, radius, wall, 2*math.pi)}


def density(force, radius, modulus, area):
    """For a contact of effective radius and modulus that pulls with at most a force, by an area times radius times
    overlap."""
    b = 4/3*modulus*math.sqrt(radius)
    return (27/4*b*b*force)**(1/3)/(area*radius)
