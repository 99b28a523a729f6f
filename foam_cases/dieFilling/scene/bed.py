# SPDX-License-Identifier: GPL-3.0-or-later
"""The poured bed, and the completely filled die to which a filling ratio refers."""
import re
import subprocess
import sys

import numpy as np

import madeOnce

# The bed depends on these, and on the walls; not on the air or the shoe's speed.
POURING = """particleDiameter particleDensity coarseGraining powderHeight bed seed youngsModulus
    poissonsRatio restitution friction wallFriction rollingFriction rollingModel wallYoungsModulus
    wallRestitution settleTime boundaryY demXLow demXHigh demYLow demYHigh demZLow demZHigh shoeXLow
    shoeXHigh shoeYLow shoeYHigh bedParcels referenceParcels overDie""".split()
COHESION = "cohesionEnergyDensity", "wallCohesionEnergyDensity"


class Bed:
    def __init__(self, case, scripts, values, pours):
        """values: parameters and what is derived from them; the walls are written already. pours: LIGGGHTS' lines that
        define the distribution `mix` of what is poured."""
        self.case, self.scripts, self.values = case, scripts, values
        self.folder, self.pours = case/"preparation", pours
        number = lambda v: f"{v:.9g}" if isinstance(v, (int, float)) else v
        self.key = "".join(f"{k} {number(values[k])}\n" for k in POURING)
        if values["cohesionEnergyDensity"]:
            self.key += "".join(f"{k} {number(values[k])}\n" for k in COHESION)
        if values["sizeDistribution"] != "mono":
            self.key += pours
        for name in ("die", "shoe"):
            self.key += (case/f"constant/triSurface/{name}.stl").read_text()

    def make(self):
        madeOnce.bed(self.folder, self.key, ("bed.restart", "fullMass"), self.pourAll)

    def pourAll(self):
        values = self.values
        (self.folder/"sizes.in").write_text(self.pours)
        running = [self.pour("bed", values["bedParcels"], 0, values["bed"]),
                   self.pour("full", values["referenceParcels"], values["overDie"], "poured")]
        for process, result in running:
            process.wait()
            log = (self.folder/f"log.{result}.screen").read_text(errors="replace")
            notes = re.findall(r"^(parcels asked.*|root mean.*|ERROR.*|The column.*)$", log, re.M)
            print(f"{result}: " + "; ".join(dict.fromkeys(notes)))
            if process.returncode or not (self.folder/f"{result}.restart").is_file():
                sys.exit(f"Pouring the powder failed: see {self.folder}/log.{result}.screen")
        full = massBelow(self.folder/"full.dump", 0)
        (self.folder/"fullMass").write_text(f"fullMass {full:.9g}; // [kg]\n")
        print(f"completely filled die: {1e6*full:.4g} mg")

    def pour(self, result, parcels, place, bed):
        log = self.folder/f"log.{result}"
        variables = dict(self.values, case=self.case, scripts=self.scripts, result=result,
                         parcels=parcels, place=place)
        if bed == "tapped":
            variables.update(contactFriction=0, wallFriction=0, contactRolling=0)
        # Line by line: what LIGGGHTS says of an error would be lost in a buffer when it aborts.
        command = ["stdbuf", "-oL", "liggghts", "-in", str(self.scripts/"dieFillingPour.in"),
                   "-log", str(log)]
        for key, value in variables.items():
            if isinstance(value, str) and value.startswith("("):
                continue  # a vector means nothing to LIGGGHTS
            command += ["-var", key, f"{value:.12g}" if isinstance(value, float) else str(value)]
        with open(f"{log}.screen", "w") as screen:
            return subprocess.Popen(command, stdout=screen, stderr=screen), result


def massBelow(path, top):
    """Mass of the parcels below a plane z = top; of those that the plane cuts, what is below."""
    rows = np.loadtxt(path, skiprows=9)
    z, r, m = rows[:, 3], rows[:, 4], rows[:, 5]
    h = np.clip(top - (z - r), 0, 2*r)
    return float(np.sum(m*h*h*(3*r - h)/(4*r**3)))
