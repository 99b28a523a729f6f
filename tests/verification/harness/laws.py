# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag laws and closed results for uniform beds, written a second time and independently of the
library, so that an expected number never comes from the code it judges.

The drag on a grain is V B (u - v), with V its volume. B [kg/m3/s] is computed from C_D Re, which
stays finite at zero slip: B = 3/4 (C_D Re) mu/d2 with Re = rho |u - v| d/mu.
"""
import math

GRAVITY = 9.81


class Air:
    def __init__(self, density=1.225, viscosity=1.7894e-5):
        self.density = density
        self.viscosity = viscosity

    def reynolds(self, slip, diameter):
        return self.density*abs(slip)*diameter/self.viscosity


def stokes(voidFraction, reynolds):
    return 24.0


def schillerNaumann(voidFraction, reynolds):
    return max(24*(1 + 0.15*reynolds**0.687), 0.44*reynolds)


def gidaspowHuilin(voidFraction, reynolds):
    """Materials 18 (2025) 3261, eqs. 7-11, of spheres."""
    share = math.atan(150*1.75*(0.8 - voidFraction))/math.pi + 0.5
    dense = 200*(1 - voidFraction)/voidFraction + 7/3*reynolds
    inAir = voidFraction*reynolds
    dilute = voidFraction**-1.65*max(
        24/voidFraction*(1 + 0.15*inAir**0.687), 0.44*reynolds)
    return share*dense + (1 - share)*dilute


class Powder:
    """Grains in air; by default the 40 um grains of the die filling study in its air."""

    def __init__(self, diameter=40e-6, density=7360.0, air=None, law=gidaspowHuilin,
                 gravity=GRAVITY):
        self.diameter = diameter
        self.density = density
        self.air = air or Air()
        self.law = law
        self.gravity = gravity

    def B(self, voidFraction, slip):
        reynolds = self.air.reynolds(slip, self.diameter)
        return 0.75*self.law(voidFraction, reynolds)*self.air.viscosity/self.diameter**2

    def slope(self, voidFraction, superficial):
        """Pressure drop per length [Pa/m] of a fixed bed: alpha dp/L = alpha_p B U/alpha."""
        return ((1 - voidFraction)*self.B(voidFraction, superficial/voidFraction)
                * superficial/voidFraction**2)

    def minimumFluidisation(self, voidFraction, buoyant=True):
        """Superficial velocity whose drag and pressure force carry the grains."""
        weight = (self.density - (self.air.density if buoyant else 0))*self.gravity
        return root(
            lambda U: self.slope(voidFraction, U) - (1 - voidFraction)*weight, 0, 10)

    def bedResponse(self, voidFraction, superficial=0.0):
        """tau_eff = alpha^2 rho_p/B [s]: of a plug that the air must leave through itself."""
        return voidFraction**2*self.density/self.B(voidFraction, superficial/voidFraction)

    def settling(self, voidFraction, buoyant=True):
        """Velocity of a uniform suspension in a closed column, relative to the column."""
        weight = (self.density - (self.air.density if buoyant else 0))*self.gravity
        slip = root(lambda s: self.B(voidFraction, s)*s - voidFraction*weight, 0, 10)
        return voidFraction*slip

    def fall(self, times, upward=0.0, steps=4000):
        """Height gained and velocity of a lone grain from rest in air that rises, by RK4."""
        weight = self.gravity*(1 - self.air.density/self.density)

        def rate(v):
            return self.B(1.0, upward - v)*(upward - v)/self.density - weight

        found = {}
        v = z = t = 0.0
        for end in sorted(times):
            dt = (end - t)/steps
            for _ in range(steps):
                k1 = rate(v)
                k2 = rate(v + 0.5*dt*k1)
                k3 = rate(v + 0.5*dt*k2)
                k4 = rate(v + dt*k3)
                z += dt*v + dt*dt/6*(k1 + k2 + k3)
                v += dt/6*(k1 + 2*k2 + 2*k3 + k4)
            t = end
            found[end] = (z, v)
        return found


def root(function, low, high):
    """Of an increasing function, by bisection to round-off."""
    for _ in range(200):
        middle = 0.5*(low + high)
        if function(middle) < 0:
            low = middle
        else:
            high = middle
    return 0.5*(low + high)
