#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of the bed against superficial velocity: pictures/pressureDrop.png, and a table."""
import sys

import numpy as np

sys.dont_write_bytecode = True

import bed
from picture import blue as found
from picture import grey, mm, plt, save
from picture import red as theory



def tell(run):
    print(f"\n  net weight over area {run.weight:.2f} Pa; U_mf {1e3*run.onset:.2f} mm/s by Ergun and the bed's "
          "void fraction\n\n  Pressure drop [Pa] at the end of each step, and its mean over the last 3 ms."
          "\n  Ergun: with the spheres as they move; carried: net weight less what floor and wall\n"
          "  hold, and what speeds the spheres up\n"
          f"{'t [ms]':>8}{'U [mm/s]':>10}{'dp':>10}{'Ergun':>9}{'error':>9}{'mean dp':>10}"
          f"{'carried':>9}{'error':>9}")
    for step in run.steps:
        print(f"{1e3*float(step.time):8.0f}{1e3*step.velocity:10.2f}{step.drop:10.2f}{step.ergun:9.2f}"
              f"{100*(step.drop/step.ergun - 1):8.2f}%{step.meanDrop:10.2f}{step.carried:9.2f}"
              f"{100*(step.meanDrop/step.carried - 1):8.2f}%")


def picture(run):
    fig, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
    weight, onset = run.weight, run.onset
    speeds = np.linspace(0, mm*run.velocity.max(), 50)
    axes.plot(speeds, [bed.drop(run.profile, s/mm, run.p) for s in speeds], color=theory, lw=1.2)
    axes.annotate("Ergun, bed as in the beginning", (0.5*mm*onset, 0.5*weight), xytext=(8, -14),
                  textcoords="offset points", color=theory)
    axes.axhline(weight, color=grey, lw=1.2)
    axes.annotate(f"net weight over area, {weight:.2f} Pa", (0, weight), xytext=(2, 4),
                  textcoords="offset points", color=grey)
    axes.axvline(mm*onset, color=grey, lw=0.8, ls=":")
    axes.annotate("$U_{mf}$", (mm*onset, 0), xytext=(4, 4), textcoords="offset points", color=grey)
    axes.plot(mm*run.velocity, run.drop, color=found, lw=0.8, alpha=0.6)
    axes.plot([mm*step.velocity for step in run.steps], [step.drop for step in run.steps], "o", color=found,
              ms=5, label="end of each step in velocity")
    axes.legend(frameon=False, loc="upper left")
    axes.set(xlabel="superficial velocity [mm/s]", ylabel="pressure drop of the bed [Pa]",
             xlim=(0, None), ylim=(0, 1.3*weight))
    save(fig, bed.case, "pressureDrop.png")


def main():
    run = bed.Bed()
    tell(run)
    picture(run)


if __name__ == "__main__":
    main()
