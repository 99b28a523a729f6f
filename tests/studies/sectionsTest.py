# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections of powder and air, and how much the air turns: of folders in which it turns as a solid body.

OpenFOAM's programs make and read them; the solver is not needed."""
import csv
import json
import shutil
import subprocess
import sys
import unittest

import numpy as np
import yaml

from studyFiguresTest import Folder, ROOT, program, row

sys.path += [str(ROOT/"foam_cases/common"), str(ROOT/"foam_cases/dieFilling/scene")]

import geometry
import runFolder
import velocitySections

MM = 1e-3
CELL = 0.5*MM
LOW, COUNT = (-4*MM, -1.5*CELL, -6*MM), (32, 3, 22)  # the die, 8 x 5 mm below 0, and room around it
TIMES = "0.065", "0.105", "0.145"  # when a shoe of 0.1 m/s has come 6.5, 10.5 and 14.5 mm

HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
PARAMETERS = {"shoeSpeed": 0.1, "rampTime": 0, "shoeWallThickness": 1.5e-3, "dieLength": 8e-3,
              "dieDepth": 5e-3}
DERIVED = {"shoeXHigh": -2.5e-3, "shoeXLow": -14.5e-3, "xLow": -4e-3, "xHigh": 12e-3, "zHigh": 5e-3,
           "dieYHigh": 0.75e-3, "dieZLow": -5e-3}


def centres():
    """In blockMesh's order: x runs fastest."""
    at = lambda axis, n: LOW[axis] + (n + 0.5)*CELL
    return [(at(0, i), at(1, j), at(2, k)) for k in range(COUNT[2]) for j in range(COUNT[1])
            for i in range(COUNT[0])]


def field(folder, kind, name, values, dimensions):
    words = "\n".join("({!r} {!r} {!r})".format(*value) if kind == "Vector" else repr(value)
                      for value in values)
    (folder/name).write_text(
        HEAD.format(f"vol{kind}Field", name) + f"dimensions [{dimensions}];\n"
        f"internalField nonuniform List<{kind.lower()}>\n{len(values)}\n(\n{words}\n);\n"
        "boundaryField { around { type zeroGradient; } }\n")


def cloud(folder, points):
    """Parcels of 0.4 mm that fall with 0.3 m/s."""
    home = folder/"lagrangian/powder"
    home.mkdir(parents=True)
    body = lambda lines: f"{len(points)}\n(\n" + "\n".join(lines) + "\n)\n"
    (home/"positions").write_text(HEAD.format("Cloud<passiveParticle>", "positions")
                                  + body("({!r} {!r} {!r}) 0".format(*point) for point in points))
    (home/"U").write_text(HEAD.format("vectorField", "U") + body(["(0 0 -0.3)"]*len(points)))
    (home/"d").write_text(HEAD.format("scalarField", "d") + body(["4e-4"]*len(points)))


def clock(folder, index):
    """What foamToVTK numbers its files by, and that parcels are told by their positions."""
    home = folder/"uniform"
    (home/"lagrangian/powder").mkdir(parents=True)
    (home/"time").write_text(HEAD.format("dictionary", "time") + f"value {folder.name}; name "
                             f"\"{folder.name}\"; index {index}; deltaT 1e-5; deltaT0 1e-5;\n")
    (home/"lagrangian/powder/cloudProperties").write_text(HEAD.format("dictionary", "cloudProperties")
                                                          + "geometry positions;\n")


def folderOfARun(home, turns):
    """The air turns about the middle of the die with so many rad/s; powder covers half a mm of floor."""
    (home/"system").mkdir(parents=True)
    for name, numbers in (("caseParameters", PARAMETERS), ("caseDerived", DERIVED)):
        (home/"system"/name).write_text("".join(f"{key} {value};\n" for key, value in numbers.items()))
    high = [low + CELL*n for low, n in zip(LOW, COUNT)]
    corners = " ".join("({} {} {})".format(*(high[a] if up else LOW[a] for a, up in enumerate(corner)))
                       for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                      (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)))
    dictionaries = {
        "blockMeshDict": f"vertices ({corners});\nblocks (hex (0 1 2 3 4 5 6 7) "
                         "({} {} {}) simpleGrading (1 1 1));\n".format(*COUNT)
                         + "boundary (); defaultPatch { name around; type patch; }\n",
        "controlDict": "startTime 0; endTime 1; deltaT 1; writeInterval 1; stopAt endTime;\n"
                       "startFrom latestTime; timePrecision 8; writePrecision 12;\n",
        "fvSchemes": "gradSchemes { default Gauss linear; } interpolationSchemes { default linear; }\n"
                     "divSchemes { } laplacianSchemes { } snGradSchemes { } ddtSchemes { }\n",
        "fvSolution": "", "decomposeParDict": "numberOfSubdomains 2; method simple; "
                                              "simpleCoeffs { n (2 1 1); delta 0.001; }\n"}
    for name, text in dictionaries.items():
        (home/"system"/name).write_text(HEAD.format("dictionary", name) + text)
    for index, time in enumerate(TIMES, 1):
        folder = home/time
        folder.mkdir()
        clock(folder, index)
        at = centres()
        field(folder, "Vector", "U",
              [(turns*(z + 2.5*MM), 0.0, -turns*(x - 4*MM)) for x, _, z in at], "0 1 -1 0 0 0 0")
        field(folder, "Scalar", "voidFraction", [0.4 if z < -4.5*MM else 1.0 for *_, z in at],
              "0 0 0 0 0 0 0")
        field(folder, "Scalar", "solid", [0.0]*len(at), "0 0 0 0 0 0 0")
        cloud(folder, [(1*MM, 0.0, -4.7*MM), (7*MM, 0.0, -4.7*MM)])
    openfoam(home, "blockMesh")


def openfoam(home, *words):
    done = subprocess.run(["bash", "-c", 'source "$1" && shift && exec "$@"', "bash",
                           ROOT/"cmake/environment.sh", *words], cwd=home, capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stdout[-2000:] + done.stderr[-2000:])


class Sections(Folder):
    def kept(self, **turns):
        """Rows of the table of runs whose air turns so; names are those of the runs."""
        rows = []
        for number, (name, (size, turning)) in enumerate(turns.items()):
            folderOfARun(self.work/f"variants/s.{name}", turning)
            rows.append({"id": name, "variant": f"d{size}", "particleDiameter": size, "shoeSpeed": 0.1,
                         "seed": number, "packing": number, "status": "ok"})
        self.write(rows, "runs.csv")
        (self.work/"plan.json").write_text(json.dumps(dict(study="s", case=str(self.work))))
        return [dict(row(one["particleDiameter"]), variant=one["variant"]) for one in rows]

    def command(self, rows):
        """Rows of airSections.csv."""
        program.main([str(self.write(rows)), "--only", "airSections", "--out",
                      str(self.work/"out")])
        self.assertGreater((self.work/"out/airSections.png").stat().st_size, 5000)
        with open(self.work/"out/airSections.csv", newline="") as file:
            return list(csv.DictReader(file))

    def near(self, said, **wanted):
        for key, value in wanted.items():
            self.assertAlmostEqual(float(said[key]), value, delta=1e-4*abs(value) + 1e-9, msg=key)

    def testAirThatTurnsAsASolidBodyHasTwiceItsRateAsVorticity(self):
        """2 * 100 rad/s everywhere; over the 8 x 4.5 mm of the die above the powder that is 7.2e-3 m2/s;
        the fastest free cell lies 3.75 and 2.25 mm from the axis: 0.43732 m/s. The other way round with
        200 and 400 in two packings: 600 1/s on average, with an error of |800 - 400|/2."""
        rows = self.kept(a=(30e-6, 100), b=(60e-6, -200), c=(60e-6, -400))
        run = self.work/"variants/s.a"
        openfoam(run, "decomposePar", "-time", "0.01:")  # as a run on two ranks leaves it
        for time in TIMES:
            self.assertTrue((run/"processor1"/time/"U").is_file())
            shutil.rmtree(run/time)
        said = self.command([rows[0], rows[1]])
        self.assertEqual([one["shoeIs"] for one in said],
                         2*["frontOverMiddle", "frontCrossed", "rearArrives"])
        for one, travel in zip(said, (6.5*MM, 10.5*MM, 14.5*MM)):
            self.near(one, particleDiameter=30e-6, shoeTravel=travel, packings=1, meanVorticity=200,
                      peakVorticity=200, circulationClockwise=7.2e-3, circulationCounter=0,
                      peakAirSpeed=0.43732, freeAirShare=0.9)
        self.near(said[3], packings=2, meanVorticity=600, circulationClockwise=0,
                  circulationCounter=3*7.2e-3, peakAirSpeed=3*0.43732, **{"meanVorticity.error": 200})

    def testCellsOfOneLineThatDifferByRoundingAreOneLine(self):
        """Else the streamlines' grid of half a cell has millions of points a side."""
        cells = np.add.outer(np.linspace(-4.2, 12, 28), [0, 1e-6, -1e-6]).ravel()[::-1]
        where, number = velocitySections.lines(cells)
        self.assertEqual(len(where), 28)
        self.assertLess(np.abs(where[number] - cells).max(), 1.1e-6)
        self.assertTrue((np.diff(where) > 0.59).all())

    def testPowderIsDrawnWhereItLiesAndAsFastAsItIs(self):
        fig = self.drawn(self.kept(a=(30e-6, 100)), "powderSections")
        first = fig.axes[0]
        self.assertIn("= 6.5 mm, $t$ = 65 ms", first.get_title())
        dots = first.collections[0]
        self.assertEqual([round(float(speed), 6) for speed in dots.get_array()], [0.3, 0.3])
        middles = sorted(tuple(path.get_extents().get_points().mean(axis=0).round(3))
                         for path in dots.get_paths())
        self.assertEqual(middles, [(1.0, -4.7), (7.0, -4.7)])

    def testTheStudyKeepsTheInstantsThatAreDrawn(self):
        """To within half a wall, 0.75 mm, at all its speeds."""
        case = ROOT/"foam_cases/dieFilling"
        study = yaml.safe_load((case/"studies/sections.yaml").read_text())
        for speed in study["vary"]["shoeSpeed"]:
            p = {**runFolder.parameters.read(case/"system/caseParameters"), **study["base"], "shoeSpeed": speed}
            d = {**p, **geometry.rig(p)}
            travels = [runFolder.shoeAt(d, n*d["pictureInterval"]) for n in range(1, p["pictures"] + 1)]
            for _, _, place in velocitySections.PLACES:
                self.assertLess(min(abs(travel - place(d)) for travel in travels), 0.7*MM)

    def testThatCannotBeDrawn(self):
        rows = self.kept(a=(30e-6, 100))
        shutil.rmtree(self.work/"variants/s.a/0.105")
        self.refused("the instant for a shoe that has come 10.5 mm is at 14.5 mm in", rows, "airSections")
        shutil.rmtree(self.work/"variants/s.a")
        for name in ("airSections", "powderSections"):
            self.refused("no folder of a run of table.csv is kept; the study sections.yaml with "
                         "'keep: yes'", rows, name)


if __name__ == "__main__":
    unittest.main()
