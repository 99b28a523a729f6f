# SPDX-License-Identifier: GPL-3.0-or-later
"""The store of poured beds, with a LIGGGHTS that only pretends to pour; and what the die-filling case's `measure` reads."""
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from toyCase import ROOT

# Writes what the script of the pour would: two parcels of 1.5 kg below the die's mouth.
POUR = """#!/bin/bash
while [ $# -gt 0 ]; do
    [ "$1" = -var ] && { declare "$2=$3"; shift 2; }
    shift
done
echo "$result" >> POURED
sleep WAIT
for i in 1 2 3 4 5 6 7 8 9; do echo head; done > "$case/preparation/$result.dump"
for i in 1 2; do echo $i 0 0 -1e-3 1e-4 1.5; done >> "$case/preparation/$result.dump"
echo "$result $seed" > "$case/preparation/$result.restart"
"""
WANTED = ["bed.restart", "fullMass", "madeWith"]


class DieFilling(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)
        self.case = self.work/"foam_cases/dieFilling"
        (self.work/"liggghts_scripts").mkdir()
        (self.work/"studies").symlink_to(ROOT/"studies")
        self.case.mkdir(parents=True)
        (self.work/"foam_cases/common").symlink_to(ROOT/"foam_cases/common")
        source = ROOT/"foam_cases/dieFilling"
        for name in ("0", "system", "scene", "constant"):
            shutil.copytree(source/name, self.case/name, ignore=shutil.ignore_patterns(
                "polyMesh", "triSurface", "caseDerived", "ranks"))
        for name in ("variant", "prepare", "run", "measure", "uniformity"):
            shutil.copy(source/name, self.case)


class TheBedStore(DieFilling):
    def setUp(self):
        super().setUp()
        self.store, self.poured = self.work/"store", self.work/"poured"
        (self.work/"bin").mkdir()
        self.pours(0.5)

    def pours(self, seconds):
        program = self.work/"bin/liggghts"
        program.write_text(POUR.replace("POURED", str(self.poured)).replace("WAIT", str(seconds)))
        program.chmod(0o755)

    def variant(self, name, *changes):
        subprocess.run([self.case/"variant", name, *changes], check=True, capture_output=True)
        return self.case/"variants"/name

    def prepare(self, folder, store=True):
        environment = {**os.environ, "PATH": f"{self.work}/bin:{os.environ['PATH']}"}
        environment.pop("INTERSTICE_BED_STORE", None)
        if store:
            environment["INTERSTICE_BED_STORE"] = str(self.store)
        return subprocess.Popen([folder/"prepare"], env=environment, start_new_session=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def prepared(self, folder, store=True):
        process = self.prepare(folder, store)
        told = process.communicate()[0]
        self.assertEqual(process.returncode, 0, told)

    def pouredBeds(self):
        return self.poured.read_text().split().count("bed") if self.poured.is_file() else 0

    def beds(self):
        return sorted(path for path in self.store.iterdir() if path.is_dir())

    def testPoursOnceForTwoRunsAtTheSameTime(self):
        folders = [self.variant(f"v{i}", f"shoeSpeed=0.{i}") for i in (1, 2)]
        both = [self.prepare(folder) for folder in folders]
        told = [process.communicate()[0] for process in both]
        self.assertEqual([process.returncode for process in both], [0, 0], told)
        self.assertEqual(self.pouredBeds(), 1)
        self.assertEqual(sorted("by another run" in text for text in told), [False, True])
        bed, = self.beds()
        self.assertEqual(sorted(path.name for path in bed.iterdir()), WANTED)
        for folder in folders:
            self.assertIn("fullMass 3;", (folder/"preparation/fullMass").read_text())
            self.assertEqual((folder/"preparation/bed.restart").read_text(),
                             (bed/"bed.restart").read_text())
        self.keepsAnotherPowderApart(bed)

    def keepsAnotherPowderApart(self, first):
        folder = self.variant("other", "seed=49979687")
        self.prepared(folder)
        self.assertEqual(self.pouredBeds(), 2)
        self.assertEqual((folder/"preparation/bed.restart").read_text(), "bed 49979687\n")
        self.prepared(self.variant("walls", "wallFriction=0.3"))
        self.assertEqual((self.pouredBeds(), len(self.beds())), (3, 3))

    def testHoldsNothingOfAPourThatWasKilled(self):
        self.pours(30)
        process = self.prepare(self.variant("v1"))
        while not self.pouredBeds():
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        self.assertEqual(self.beds(), [])
        self.pours(0)
        self.prepared(self.variant("v2"))
        self.assertEqual((self.pouredBeds(), len(self.beds())), (2, 1))

    def testPoursNoPowderOverTheShoe(self):
        process = self.prepare(self.variant("high", "powderHeight=30e-3"))
        told = process.communicate()[0]
        self.assertNotEqual(process.returncode, 0)
        self.assertRegex(told, r"must not be higher than the shoe[\s\S]*powderHeight 0.03 m[\s\S]*0.03 m")
        self.assertEqual(self.pouredBeds(), 0)

    def testIsNotThereUnlessWanted(self):
        self.pours(0)
        self.prepared(self.variant("v1"), store=False)
        self.prepared(self.variant("v2"), store=False)
        self.assertEqual(self.pouredBeds(), 2)
        self.assertFalse(self.store.exists())


class OtherCases(unittest.TestCase):
    def testKeepTheirBedsThereToo(self):
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            (work/"foam_cases").mkdir()
            for shared in ("foam_cases/common", "liggghts_scripts"):
                (work/shared).symlink_to(ROOT/shared)
            program = work/"liggghts"
            program.write_text(f"""#!/bin/bash
echo "$*" | tr ' ' '\\n' | grep -A1 -x seed >> {work}/poured
case=$(echo "$*" | sed 's/.*-var case \\([^ ]*\\).*/\\1/')
echo bed > "$case/preparation/bed.restart"; echo bed > "$case/preparation/bed.dump"
""")
            program.chmod(0o755)
            for name, fluid in (("hopper", "airDensity=2"), ("packedBed", "fluidDensity=20")):
                self.pours(work, name, fluid)

    def pours(self, work, name, fluid):
        """Three variants, two of which differ in the fluid only."""
        case = work/"foam_cases"/name
        shutil.copytree(ROOT/"foam_cases"/name, case, ignore=shutil.ignore_patterns("variants", "results", "preparation"))
        (work/"poured").write_text("")
        environment = {**os.environ, "PATH": f"{work}:{os.environ['PATH']}", "INTERSTICE_BED_STORE": str(work/name)}
        for variant, change in (("first", fluid.replace("2", "3")), ("second", fluid), ("third", "seed=49979687")):
            subprocess.run([case/"variant", variant, change], check=True, capture_output=True)
            done = subprocess.run([case/"variants"/variant/"prepare"], env=environment, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual("by another run" in done.stdout, variant == "second")
            self.assertTrue((case/"variants"/variant/"preparation/bed.restart").is_file())
        self.assertEqual((work/"poured").read_text().split(), ["seed", "32452843", "seed", "49979687"])


class Measure(DieFilling):
    def table(self, name, start, head, *rows):
        folder = self.case/f"postProcessing/{name}/{start}"
        folder.mkdir(parents=True)
        (folder/f"{name}.dat").write_text(
            f"# time [s]\t{head}\n" + "".join("\t".join(map(str, row)) + "\n" for row in rows))

    def measured(self):
        return json.loads(subprocess.run([self.case/"measure"], check=True, capture_output=True,
                                         text=True).stdout)

    def testIsNullWhereThereIsNothing(self):
        found = self.measured()
        self.assertEqual(set(found.values()), {None})
        self.assertEqual(list(found), list(json.loads(subprocess.run(
            [self.case/"measure", "-list"], capture_output=True, text=True).stdout)))

    def testJoinsARunThatWentOn(self):
        """Goes on from 2 s; what the first part did after that does not count."""
        for start, rows in ((0, [(1, "frontCrossed", 0.25)]), (2, [(3, "end", 0.65)])):
            folder = self.case/f"postProcessing/fillingRatio/{start}"
            folder.mkdir(parents=True)
            (folder/"moments.dat").write_text("# time [s]\tmoment\tfillingRatio [-]\n" + "".join(
                "\t".join(map(str, row)) + "\n" for row in rows))
        flow = "flowRate [m3/s]\tvolumeInDie [m3]\tmaximum [m3/s]\ttimeOfMaximum [s]"
        self.table("dieFlowRate", 0, flow, (1, 0, 0, 0, 0), (2, 5, 5, 5, 2), (2.5, 9, 90, 9, 2.5))
        self.table("dieFlowRate", 2, flow, (3, 3, 8, 3, 3), (6, 1, 20, 3, 3), (7, 0, 20, 3, 3))
        self.table("surfaceSlope", 0, "slope [deg]\tR2 [-]\tbins [-]", (1, 0, 0, 0),
                   (7, 30, 0.9, 10))
        # Weight over drag: (2*1 + 2*3)/(2*1/4 + 2*3/1), while the volume grows from 2 to 6 s.
        self.table("forceNumber", 0, "forceNumberInDie [-]\tother\tparticlesInDie [-]",
                   (1, "nan", 0, 0), (2, 8, 0, 9), (3, 4, 0, 2), (6, 1, 0, 2), (7, 99, 0, 9))
        (self.case/"log.demPimpleFoam").write_text(
            "t = 1 s  9 % | 7 particles | dt 0.25 s (growth, 3 DEM steps) | air max 2 m/s, Co 0.5, "
            "p iterations 10\n"
            "t = 2 s  9 % | 7 particles | dt 0.75 s (powder response, 3 DEM steps) | "
            "air max 3.5 m/s, Co 0.25, p iterations 30\nEnd\n")
        found = self.measured()
        wanted = dict(fillingRatioPassed=0.65, fillingRatioCrossed=0.25, fillingRatioArrives=None,
                      peakFlowRate=5, meanFlowRate=15/4, slope=30, slopeFit=0.9, peakAirSpeed=3.5,
                      maxCourant=0.5, meanDt=0.5, responseBound=0.5, pressureIterations=20)
        for name, value in wanted.items():
            self.assertEqual(found[name], value, name)
        self.assertAlmostEqual(found["forceNumberMean"], 8/6.5, 12)

    def testReadsTheBalance(self):
        heads = ("massInDie [kg]", "massInShoe [kg]", "massElsewhere [kg]", "massAtStart [kg]",
                 "massMissing [kg]", "particles [-]", "outside [-]", "lost [-]",
                 *(f"momentumRemainder{axis} [N s]" for axis in "XYZ"),
                 *(f"dragImpulse{axis} [N s]" for axis in "XYZ"),
                 "clippedVolume [m3]", "movedVolume [m3]", "hiddenVolume [m3]")
        self.table("powderBalance", 0, "\t".join(heads),
                   (1, 0, 8, 0, 8, 0, 9, 0, 0, 3, 0, 4, 0, 0, 0, 0, 0, 0),
                   (2, 4, 2, 1, 8, -2, 9, 0, 1, 0, 0, 0, 6, 8, 0, 7, 0, 5))
        found = self.measured()
        wanted = dict(spilled=1/8, massMissing=1/4, parcelsLost=1, clippedVolume=7, hiddenVolume=5,
                      momentumRemainder=0.5)
        self.assertEqual({name: found[name] for name in wanted}, wanted)


if __name__ == "__main__":
    unittest.main()
