# SPDX-License-Identifier: GPL-3.0-or-later
"""Filling ratio with air over the size of particles, the level without air, and the size from which on `air auto` leaves it
out."""
import matplotlib.pyplot as plt

import figures as engine
import tableFile
from badInput import BadInput
from panels import numbers

LEFT_OUT = 2*9.56e6  # zeta; critical is half of it [Y. Guo et al., AIChE J. 55 (2009) 49-62]
SIZE, FILLING = "particleDiameter", "fillingRatioPassed"


def airlessSize(row):
    """From which on the air is left out by zeta = rho_p (rho_p - rho_g) g d^3/mu^2 [m]."""
    density, gas, viscosity = (tableFile.number(row[key]) for key in ("particleDensity", "airDensity", "airViscosity"))
    return (LEFT_OUT*viscosity**2/(density*(density - gas)*9.81))**(1/3)


def draw(table, chosen, study):
    for key in (SIZE, FILLING, "air", "particleDensity", "airDensity", "airViscosity"):
        if key not in table.columns:
            raise BadInput(f"{table.name} has no column '{key}'; the study {study} gives it.")
    rows = [row for row in table.chosen(chosen.where) if row[FILLING] != ""]
    still = [row for row in rows if row["air"] == "off"]
    blown = sorted((row for row in rows if row["air"] != "off"), key=lambda row: tableFile.number(row[SIZE]))
    if len(still) != 1 or len(blown) < 2:
        raise BadInput(f"{table.name} has {len(blown)} rows with air and {len(still)} without; the study {study} gives "
                       "several and one: choose them by --where.")
    fig, axes = plt.subplots(figsize=(1.2*engine.WIDTH, 0.8*engine.WIDTH), layout="constrained")
    level, error = (values[0] for values in numbers(table, still, FILLING))
    axes.axhspan(level - error, level + error, color="0.85", lw=0)
    axes.axhline(level, color="0.4", lw=1, label="without air")
    y, dy = numbers(table, blown, FILLING)
    axes.errorbar([1e6*tableFile.number(row[SIZE]) for row in blown], y, dy, color=engine.COLOURS[0], marker="o", ms=4.5,
                  mec="white", mew=0.4, capsize=2.5, lw=1, elinewidth=0.9, label="with air")
    size = 1e6*airlessSize(blown[0])
    axes.axvline(size, color=engine.COLOURS[1], lw=1, ls="--", label=rf"$\zeta = 1.91\times10^7$: {size:.0f} µm")
    axes.set(xscale="log", xlabel=r"particle diameter $d_\mathrm{p}$ [µm]", ylabel=table.label(FILLING))
    axes.set_xticks([20, 40, 80, 160, 400], ["20", "40", "80", "160", "400"])
    axes.minorticks_off()
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, fontsize=8, loc="lower center")
    return fig
