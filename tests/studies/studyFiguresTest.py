# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of the reference study: what stands in them, and what is said of those left out."""
import contextlib
import csv
import io
import json
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from pathlib import Path

sys.dont_write_bytecode = True

from program import loaded

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT/"foam_cases/dieFilling/studies/figures"


program = loaded(PROGRAM)  # which makes the modules below known

import criticalSize
import matplotlib.pyplot as plt
import numpy as np
import surface
import tableFile
from surface import cloud
from badInput import BadInput

plt.rcParams["savefig.dpi"] = 50  # enough to compare, and faster


def row(d=40e-6, rho=7350, v=0.1, length=8e-3, depth=5e-3, **more):
    y = 5000*d + rho/1e5 - v
    return {"variant": f"{d} {rho} {v} {length} {depth}", "particleDiameter": d,
            "particleDensity": rho, "coarseGraining": 10, "shoeSpeed": v, "dieLength": length,
            "dieDepth": depth, "sliceWidth": 2.4e-3, "airDensity": 1.225, "airViscosity": 1.7894e-5,
            "status": "ok", "packings": 3, "fillingRatioPassed": y, "fillingRatioPassed.error": 0.01,
            "meanFlowRate": 1e-7*y, "meanFlowRate.error": 1e-9, "forceNumberMean": 10*y,
            "forceNumberMean.error": 0.1, "seconds": 400, **more}


GRID = [row(d, rho, v) for d in (40e-6, 60e-6, 80e-6) for rho in (3675, 7350) for v in (0.1, 0.2)]
CAVITY = [row(length=x, depth=h) for x in (6e-3, 8e-3) for h in (5e-3, 6e-3)]


SENSITIVITY = ([row(d, 7360, 0.15, air="on") for d in (40e-6, 160e-6, 400e-6)]
               + [row(400e-6, 7360, 0.15, air="off")])


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(plt.close, "all")
        self.work = Path(folder.name)

    def write(self, rows, name="table.csv"):
        path = self.work/name
        with open(path, "w", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
        return path

    def drawn(self, rows, name, *options):
        """The figure."""
        words = [str(self.write(rows)), "--only", name, *options]
        chosen = program.options(words)
        table = tableFile.Table(chosen.table)
        program.catalogue.name(table)
        return program.catalogue.FIGURES[name].draw(table, chosen)

    def refused(self, wanted, rows, name, *options):
        with self.assertRaises(BadInput) as raised:
            self.drawn(rows, name, *options)
        self.assertIn(wanted, str(raised.exception))


def plotted(axes):
    """Label -> [(x, y)] of the lines with error bars."""
    return {bars.get_label(): [tuple(map(float, point)) for point in zip(*bars[0].get_data())]
            for bars in axes.containers}


class Panels(Folder):
    def near(self, one, other):
        self.assertEqual(len(one), len(other))
        for a, b in zip(one, other):
            self.assertAlmostEqual(a[0], b[0], 6)
            self.assertAlmostEqual(a[1], b[1], 6)

    def testHaveALineForEachSpeedAndAPanelForEachDensity(self):
        """100 (5000 d + rho/1e5 - v): 13.675 % at 40 um, 3675 kg/m3 and 0.1 m/s."""
        fig = self.drawn(GRID, "fillingOverSize")
        top, low, high = fig.axes
        self.assertIn("3675", low.get_title())
        self.assertIn("7350", high.get_title())
        self.assertEqual(list(plotted(low)), ["$v$ = 0.1 m/s", "$v$ = 0.2 m/s"])
        self.near(plotted(low)["$v$ = 0.1 m/s"], [(0.008, 13.675), (0.012, 23.675), (0.016, 33.675)])
        self.near(plotted(high)["$v$ = 0.2 m/s"], [(0.008, 7.35), (0.012, 17.35), (0.016, 27.35)])
        self.assertEqual(low.get_ylabel(), "filling ratio $δ$ [%]")
        self.assertEqual(low.get_xlabel(), "$d_p/h_D$")
        bar = low.containers[0][2][0].get_segments()[0]
        self.assertAlmostEqual(bar[1][1] - bar[0][1], 2, 6)

    def testOfTheFlowSayWhichSlice(self):
        """N_v = v rho L/mu: 0.1 * 1.225 * 8e-3/1.7894e-5 = 54.767; flow 1e2 (...) mm3/s."""
        fig = self.drawn(GRID, "flowOverReynolds", "--where", "particleDensity=7350")
        axes = fig.axes[1]
        self.near([plotted(axes)["$d_{\\mathrm{p}}$ = 40 µm"][0]], [(54.766961, 17.35)])
        self.assertIn("[mm$^{3}$/s]\ninto a slice of 2.4 mm", axes.get_ylabel())

    def testOfTheCavityHaveALineForEachDepth(self):
        axes = self.drawn(CAVITY, "fillingOverCavity").axes[1]
        self.near(plotted(axes)["$h_{\\mathrm{D}}$ = 6 mm"], [(1, 17.35), (8/6, 17.35)])

    def testOfTheForceNumberHoldAllVariants(self):
        axes = self.drawn(GRID, "fillingOverForce").axes[1]
        points = [point for line in plotted(axes).values() for point in line]
        self.assertEqual(len(points), 12)
        for x, y in points:
            self.assertAlmostEqual(y, 10*x, 6)  # as the rows above are made

    def testAreOfParcelsOfOneSizeWhateverTheGrains(self):
        """As filling.yaml and criticalSize.yaml have them; all with k = 10 are other parcels, but of one k."""
        parcels = [{**one, "coarseGraining": round(400e-6/one["particleDiameter"], 4)} for one in GRID]
        for name in ("fillingOverSize", "fillingOverReynolds", "forceOverDensity"):
            self.drawn(parcels, name)
        lone = [{**one, "coarseGraining": 5 if one["particleDiameter"] == 60e-6 else 10} for one in GRID]
        self.refused("coarseGraining varies too", lone, "fillingOverSize")

    def testThatCannotBeDrawn(self):
        self.refused("dieLength and dieDepth have one value in table.csv; the study cavity.yaml", GRID,
                     "fillingOverCavity")
        self.refused("particleDiameter has one value in table.csv; the study filling.yaml", CAVITY,
                     "fillingOverSize")
        without = [{key: value for key, value in one.items() if "Flow" not in key} for one in GRID]
        self.refused("no column 'meanFlowRate'; the study filling.yaml", without, "flowOverSize")
        self.refused("coarseGraining varies too in table.csv: choose by --where coarseGraining=VALUE",
                     GRID + [row(coarseGraining=5)], "fillingOverSize")
        self.refused("has no number 'fillingRatioPassed'", [row(fillingRatioPassed="")],
                     "fillingOverSize")
        for name in ("fillingOverSize", "fillingOverForce"):
            self.refused("nan" if name == "fillingOverForce" else "is not finite",
                         GRID[1:] + [row(rho=3675, fillingRatioPassed="nan")], name)


class Command(Folder):
    def run_(self, *words):
        out, error = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
            program.main([str(word) for word in words])
        return out.getvalue(), error.getvalue()

    def testDrawsTheSameBytesAgainAndNamesWhatIsLeftOut(self):
        table = self.write(GRID)
        out, error = self.run_(table, "--only", "fillingOverDensity", "fillingOverCavity", "--out",
                               self.work/"one")
        self.assertEqual(len(error.splitlines()), 1)
        self.assertIn("fillingOverCavity is left out: ", error)
        self.run_(table, "--only", "fillingOverDensity", "--out", self.work/"two")
        for path in map(Path, out.split()):
            self.assertGreater(path.stat().st_size, 5000)
            self.assertEqual(path.read_bytes(), (self.work/"two"/path.name).read_bytes())

    def testEndsWithTwoIfNothingCanBeDrawn(self):
        with self.assertRaisesRegex(BadInput, "No figure can be drawn from .*table.csv: see the lines"):
            self.run_(self.write([row()]), "--only", "fillingOverCavity")
        ended = subprocess.run([PROGRAM, self.work/"table.csv", "--only", "fillingOverSise"],
                               capture_output=True, text=True)
        self.assertEqual((ended.returncode, ended.stderr.count("\n")), (2, 1))
        self.assertIn("did you mean 'fillingOverSize'?", ended.stderr)

    def testListsAllFigures(self):
        out, _ = self.run_("--list")
        self.assertEqual(len(out.splitlines()), len(program.catalogue.FIGURES))
        for study in {figure.study for figure in program.catalogue.FIGURES.values()}:
            self.assertIn(study, out)
            self.assertTrue((PROGRAM.parent/study).is_file())


class CriticalSize(Folder):
    def model(self, **more):
        """Series that lie on Eq 21, and a plane 1e-3 above it."""
        series = []
        for v in (0.1, 0.125, 0.15):
            for rho in (5360, 7360):
                size = criticalSize.at(criticalSize.PUBLISHED, v*1.225*8e-3/1.7894e-5, rho/1.225)
                series.append(dict(criticalSizeRatio=size, error=1e-4, particleDensity=rho,
                                   shoeSpeed=v, dieLength=8e-3, dieDepth=5e-3, airDensity=1.225,
                                   airViscosity=1.7894e-5))
        a, b, c = criticalSize.PUBLISHED
        model = dict(threshold=0.9, series=series, criticalSize=dict(
            coefficients=[a + 1e-3, b, c], covariance=[[4e-8, 0, 0], [0, 0, 0], [0, 0, 0]]), **more)
        path = self.work/"model.json"
        path.write_text(json.dumps(model))
        return path

    def testKnowsEq21(self):
        """0.00256 + 1.77202e-4 * 54.767 - 1.05607e-6 * 6008.16 = 0.00592."""
        self.assertAlmostEqual(criticalSize.at(criticalSize.PUBLISHED, 54.767, 6008.16), 0.00592, 5)
        covariance = [[1, 0.5, 0], [0.5, 4, 0], [0, 0, 9]]  # 1 + 2*2*0.5 + 4*4 + 9*9 = 100
        self.assertAlmostEqual(criticalSize.errorAt(covariance, 2, 3), 10, 9)

    def testIsDrawnBesidePlaneAndEq21(self):
        fig = self.drawn(GRID, "predicted", "--model", str(self.model()))
        lines = plotted(fig.axes[0])
        for measured, said in lines["Eq 21"]:
            self.assertAlmostEqual(measured, said, 9)
        for measured, said in lines["our plane"]:
            self.assertAlmostEqual(measured + 1e-3, said, 9)
        axes = self.drawn(GRID, "criticalSize", "--model", str(self.model())).axes[0]
        self.assertEqual(len(plotted(axes)), 2)
        self.assertEqual([len(points) for points in plotted(axes).values()], [3, 3])

    def testThatCannotBeDrawn(self):
        torn = self.model()
        torn.write_text(torn.read_text()[:200])
        self.refused("is no whole filling model", GRID, "criticalSize", "--model", str(torn))
        with unittest.mock.patch.dict("os.environ", PATH=str(self.work)):
            self.refused("no program fillingModel on the PATH; build it, or name", GRID, "predicted")
            said = self.work/"fillingModel"
            said.write_text("#!/bin/sh\necho 'No series crosses the threshold.' >&2\nexit 1\n")
            said.chmod(0o755)
            self.refused("No series crosses the threshold. The study criticalSize.yaml gives", GRID,
                         "predicted")


class Surface(Folder):
    HEAD = ("FoamFile\n{{\n    format      {};\n    class       Cloud<passiveParticle>;\n}}\n"
            "// * * * * //\n\n{}\n(\n")

    def positions(self, folder, points, binary):
        path = folder/"lagrangian/powder/positions"
        path.parent.mkdir(parents=True)
        head = self.HEAD.format("binary" if binary else "ascii", len(points)).encode()
        if binary:
            body = b"".join(b"(" + struct.pack("<3di", *point, 7) + b")\n" for point in points)
        else:
            body = "".join("({!r} {!r} {!r}) 7\n".format(*point) for point in points).encode()
        path.write_bytes(head + body + b")\n\n// * * //\n")
        return path

    def testReadsWhatOpenFOAMWrites(self):
        # Bytes that are brackets and ends of lines, which must not be taken for such.
        tricky = struct.unpack("<d", b"()\n()\n)?")[0]
        points = [(1e-3, tricky, -2e-3), (0.1 + 0.2, -0.0, 1/3)]
        for binary in (True, False):
            path = self.positions(self.work/str(binary), points, binary)
            self.assertEqual(cloud.positions(path), points)
        path.write_bytes(path.read_bytes()[:-40])
        with self.assertRaisesRegex(cloud.NoPowder, "is torn: run that variant again"):
            cloud.positions(path)

    def testTakesTheHighestParcelOfEachTenth(self):
        """Die 8 x 5 mm, parcels of 0.4 mm: the first tenth ends at 0.8 mm. Above 0: not in the die."""
        p = dict(coarseGraining=10, particleDiameter=40e-6, dieLength=8e-3, dieDepth=5e-3)
        heights = surface.surface([(1e-4, 0, -4e-3), (7e-4, 0, -3e-3), (9e-4, 0, -1e-3),
                                   (1e-4, 0, 1e-3), (8e-3, 0, -2e-3), (-1e-3, 0, -1e-3)], p)
        wanted = [-2.8e-3, -0.8e-3] + [None]*7 + [-1.8e-3]
        for one, other in zip(heights, wanted):
            self.assertEqual(one is None, other is None)
            self.assertAlmostEqual(one or 0, other or 0, 12)

    def kept(self, runs):
        """Folders of runs, and the tables beside which they are sought."""
        head = {"particleDiameter": 40e-6, "dieLength": 8e-3, "dieDepth": 5e-3, "seed": 1}
        rows = [{"id": name, "variant": f"k{k}{air}", "coarseGraining": k, "air": air, **head,
                 "packing": 1, "status": "ok"} for name, k, air, _ in runs]
        self.write(rows, "runs.csv")
        (self.work/"plan.json").write_text(json.dumps(dict(study="cg", case=str(self.work))))
        for name, *_, height in runs:
            for time in ("0.1", "0.02", "0.09"):  # 0.1 is the last, the others hold nothing
                self.positions(self.work/f"variants/cg.{name}/processor0"/time,
                               [(4.1e-3, 0, height)] if time == "0.1" else [], True)
        return [dict(row(), variant=one["variant"], coarseGraining=one["coarseGraining"],
                     air=one["air"]) for one in rows]

    def testIsDrawnForEachK(self):
        """Mean of -3.8 and -3.4 mm, error 0.4/2; bin from 4.0 to 4.8 mm."""
        table = self.kept([("a", 10, "on", -4e-3), ("b", 10, "on", -3.6e-3), ("c", 5, "on", -2e-3)])
        axes = self.drawn(table[1:], "surface").axes[0]
        lines = plotted(axes)
        self.assertEqual(list(lines), ["$k$ = 5", "$k$ = 10"])
        self.assertAlmostEqual(lines["$k$ = 10"][0][0], 4.4, 9)
        self.assertAlmostEqual(lines["$k$ = 10"][0][1], -3.6, 9)
        self.assertAlmostEqual(lines["$k$ = 5"][0][1], -1.9, 9)
        bar = axes.containers[1][2][0].get_segments()[0]
        self.assertAlmostEqual(bar[1][1] - bar[0][1], 0.4, 9)

    def testThatCannotBeDrawn(self):
        self.refused("coarseGraining.yaml with 'keep: yes'", GRID, "surface")
        table = self.kept([("a", 10, "on", -4e-3), ("b", 10, "off", -3e-3)])
        self.refused("differ in air: choose by --where air=VALUE", table, "surface")


class OverTime(Folder):
    """Runs of 0.1 s in which the ratio rises evenly, and powder flows as it does."""

    def kept(self, runs):
        rows = [{"id": name, "variant": f"k{k}", "coarseGraining": k, "seed": name, "packing": 1, "status": "ok"}
                for name, k, _ in runs]
        self.write(rows, "runs.csv")
        (self.work/"plan.json").write_text(json.dumps(dict(study="cg", case=str(self.work))))
        for name, _, end in runs:
            home = self.work/f"variants/cg.{name}"
            (home/"system").mkdir(parents=True)
            (home/"system/caseParameters").write_text("FoamFile { }\nshoeSpeed 0.15; rampTime 0.01; dieLength 8e-3;\n")
            (home/"system/caseDerived").write_text("shoeXHigh -2.5e-3; shoeXLow -14.5e-3;\n")
            for table, head, last in (("fillingRatio", "fillingRatio", end), ("dieFlowRate", "flowRate", 1e-6*end)):
                (home/f"postProcessing/{table}/0").mkdir(parents=True)
                lines = [f"{0.001*i} {last*i/100}" for i in range(101)]
                (home/f"postProcessing/{table}/0/{table}.dat").write_text(f"# time {head}\n" + "\n".join(lines))
        return [dict(row(), variant=one["variant"], coarseGraining=one["coarseGraining"]) for one in rows]

    def testIsDrawnForEachVariant(self):
        """60 and 70 %: 65 +- 5 at the end, 32.5 at half the time, with a flow of 325 mm3/s."""
        upper, lower = self.drawn(self.kept([("a", 10, 0.6), ("b", 10, 0.7), ("c", 5, 0.8)])[1:],
                                  "fillingOverTime").axes
        lines = {line.get_label(): line for line in upper.lines}
        self.assertEqual([name for name in lines if not name.startswith("_")], ["coarse graining = 10", "coarse graining = 5"])
        for axes, factor in ((upper, 1), (lower, 10)):
            t, y = axes.lines[0].get_data()
            self.assertAlmostEqual(float(np.interp(50, t, y)), 32.5*factor, 6)
        self.assertAlmostEqual(upper.lines[0].get_ydata()[-1], 65, 6)
        band = upper.collections[0].get_paths()[0].vertices
        self.assertAlmostEqual(band[:, 1].max(), 70, 6)

    def testShowsWhenTheWallsPass(self):
        """The front wall, 2.5 mm before the die: 2.5/0.15 + 10/2 = 21.67 ms."""
        upper = self.drawn(self.kept([("a", 10, 0.6)]), "fillingOverTime").axes[0]
        self.assertTrue(any(abs(line.get_xdata()[0] - 21.6667) < 1e-3 for line in upper.lines))

    def testThatCannotBeDrawn(self):
        table = self.kept([("a", 10, 0.6)])
        (self.work/"variants/cg.a/postProcessing/dieFlowRate/0/dieFlowRate.dat").unlink()
        self.refused("has no postProcessing/fillingRatio or dieFlowRate: run that variant again", table, "fillingOverTime")


class AirSensitivity(Folder):
    def testTheSizeIsThatOfTwiceGuosNumber(self):
        """Reckoned apart: (1.912e7 (1.7894e-5)^2/(7360 (7360 - 1.225) 9.81))^(1/3) = 225.9 um."""
        axes, = self.drawn(SENSITIVITY, "airSensitivity").axes
        dashed, = [line for line in axes.lines if line.get_linestyle() == "--"]
        self.assertAlmostEqual(dashed.get_xdata()[0], 225.9, delta=0.1)

    def testAirIsDrawnOverSizeAndTheLevelWithout(self):
        axes, = self.drawn(SENSITIVITY, "airSensitivity").axes
        points = plotted(axes)["with air"]
        self.assertEqual([round(x) for x, _ in points], [40, 160, 400])
        level, = [line for line in axes.lines if line.get_label() == "without air"]
        self.assertAlmostEqual(level.get_ydata()[0], points[-1][1])

    def testItWantsOneRowWithoutAir(self):
        self.refused("3 rows with air and 0 without", SENSITIVITY[:3], "airSensitivity")
        self.refused("no column 'air'", GRID, "airSensitivity")


if __name__ == "__main__":
    unittest.main()
