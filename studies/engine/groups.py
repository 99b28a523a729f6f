# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensionless groups of die filling that follow from the parameters in a table."""

GROUPS = {
    "dpOverHd": ("$d_p/h_D$", ("particleDiameter", "dieDepth"), lambda d, h: d/h),
    "shoeReynolds": (r"$v\,\rho_g L_D/\mu_g$",
                     ("shoeSpeed", "airDensity", "dieLength", "airViscosity"),
                     lambda v, rho, length, mu: v*rho*length/mu),
    "densityRatio": (r"$\rho_p/\rho_g$", ("particleDensity", "airDensity"),
                     lambda solid, gas: solid/gas),
    "LdOverHd": ("$L_D/h_D$", ("dieLength", "dieDepth"), lambda length, h: length/h),
}
