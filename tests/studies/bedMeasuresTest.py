# SPDX-License-Identifier: GPL-3.0-or-later
"""The packed and the bubbling bed, and the die: what `measure` finds in folders whose answers are known by hand, and
what a study wants of the cases."""
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

from toyCase import ROOT, STUDY

GRAVITY = 9.81
# Tells its variables, and makes the bed.
SETTLE = """#!/bin/bash
while [ $# -gt 0 ]; do
    [ "$1" = -var ] && { declare "$2=$3"; shift 2; }
    shift
done
echo "$spheres $seed $demStep" >> SETTLED
touch "$case/preparation/bed.restart"
"""


class ACase(unittest.TestCase):
    name = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)
        self.case = self.work/"foam_cases"/self.name
        shutil.copytree(ROOT/"foam_cases"/self.name, self.case, ignore=shutil.ignore_patterns(
            "variants", "results", "preparation", "postProcessing", "caseDerived", "ranks", "polyMesh",
            "0.*", "log.*"))
        for shared in ("studies", "liggghts_scripts", "cmake", "foam_cases/common"):
            (self.work/shared).symlink_to(ROOT/shared)

    def change(self, **parameters):
        path = self.case/"system/caseParameters"
        lines = [f"{line.split()[0]} {parameters[line.split()[0]]:.17g};" if line.split()[:1] and
                 line.split()[0] in parameters else line for line in path.read_text().splitlines()]
        path.write_text("\n".join(lines) + "\n")

    def write(self, name, text):
        path = self.case/name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def table(self, name, rows, head="# time\n"):
        self.write(f"postProcessing/{name}", head + "".join(
            " ".join(f"{x:.17g}" if isinstance(x, float) else str(x) for x in row) + "\n" for row in rows))

    def ended(self, *words, **environment):
        return subprocess.run([str(word) for word in words], capture_output=True, text=True,
                              env={**os.environ, **environment})

    def measured(self):
        found = self.ended(self.case/"measure")
        self.assertEqual(found.stderr, "")
        return json.loads(found.stdout)

    def nothingIsNull(self):
        found = self.measured()
        self.assertEqual(set(found.values()), {None})
        self.assertEqual(list(found), list(json.loads(self.ended(self.case/"measure", "-list").stdout)))

    def canBeStudied(self, wanted):
        planned = self.ended(STUDY, ROOT/f"foam_cases/{self.name}/studies/accuracy.yaml", "--dry-run",
                             "--results", self.work/"results")
        self.assertEqual((planned.returncode, planned.stderr), (0, ""))
        self.assertIn(wanted, planned.stdout)

    def variant(self, name, *changes):
        made = self.ended(self.case/"variant", name, *changes)
        self.assertEqual(made.returncode, 0, made.stderr)
        return self.case/"variants"/name

    def derived(self, folder):
        words = [line.rstrip(";").split() for line in (folder/"system/caseDerived").read_text().splitlines()]
        return {pair[0]: pair[1] for pair in words if len(pair) == 2}


class PackedBed(ACase):
    """Two layers of 5 mm, void fraction 0.4, d = 1 mm, rho = 10, nu = 1.5e-4: Ergun's drop over both is
    12656.25 U + 1640.625 U^2 Pa, 63.322 Pa at 5 mm/s and 126.727 at 10. A net weight of 150 Pa is carried
    at 11.834 mm/s, so that 12 mm/s is too near to count."""
    name = "packedBed"
    ERGUN = staticmethod(lambda U: 12656.25*U + 1640.625*U*U)
    AREA = 1000*math.pi/6*1e-9*2000*GRAVITY/150

    def run_(self, drops, rise=0.0):
        """Drop at the end of each step of 10 ms: (U, drop); the last one lasts."""
        self.change(spheres=1000, particleDensity=2010, height=0.01)
        self.write("system/caseDerived", f"area {self.AREA:.17g};\nlayers 2;\nlayerHeight 0.005;\n")
        times = [1e-3*(i + 1) for i in range(10*len(drops))]
        at = [drops[i//10] for i in range(len(times))]
        self.table("pressureDrop/0/volFieldValue.dat", [
            (t, "(0", "0", f"{-self.AREA*(drop/10 + GRAVITY*0.01):.17g})") for t, (_, drop) in zip(times, at)])
        self.table("flow/0/surfaceFieldValue.dat", [(t, -U*self.AREA) for t, (U, _) in zip(times, at)])
        # Floor and wall pull the spheres down by 4.5 Pa; these gain 1.5 Pa of momentum a second.
        self.table("walls.dat", [(t, -1.5*self.AREA, -3.0*self.AREA) for t in times])
        self.table("momentumBudget/0/momentumBudget.dat", [(t, *[0.0]*5, 1.5*self.AREA*t, *[0.0]*3) for t in times])
        for i in range(len(drops)):
            self.fields(f"{0.01*(i + 1):.4g}", rise)

    def fields(self, time, rise):
        for name, values in (("voidFraction", (0.3, 0.5, 0.4)), ("Cz", (2e-3, 2.1e-3, 7e-3)), ("V", (1, 1, 2))):
            self.write(f"{time}/{name}", f"internalField nonuniform List<scalar>\n{len(values)}\n(\n"
                       + "\n".join(map(str, values)) + "\n)\n;\n")
        self.write(f"{time}/lagrangian/powder/positions", "1\n(\n(0 0 0.005) 0\n)\n")
        self.write(f"{time}/lagrangian/powder/U", f"1\n(\n(0 0 {rise})\n)\n")

    def testIsNullWhereThereIsNothing(self):
        self.nothingIsNull()

    def testIsComparedWithErgunAndWithWhatItCarries(self):
        """1 % above and 3 % below Ergun; 153 Pa and 156 carried: 150, less -4.5 that the walls hold, and
        1.5 of speed."""
        packed = [(0.005, 1.01*self.ERGUN(0.005)), (0.01, 0.97*self.ERGUN(0.01))]
        self.run_(packed + [(0.012, 140.0), (0.02, 153.0)])
        found = self.measured()
        onset = (math.sqrt(12656.25**2 + 4*1640.625*150) - 12656.25)/(2*1640.625)
        for name, value in (("ergunError", -0.01), ("ergunErrorLargest", 0.03), ("firstDrop", packed[0][1]),
                            ("dropSlope", (packed[1][1] - packed[0][1])/0.005), ("plateau", 1.02),
                            ("carriedError", 153/156 - 1)):
            self.assertAlmostEqual(found[name], value, 9, name)
        self.assertAlmostEqual(found["onset"], onset, 8)
        self.assertIsNone(found["massMissing"])

    def testFluidPassesSpheresThatRiseMoreSlowly(self):
        """1 mm/s of 10 is no slip."""
        self.run_([(0.01, self.ERGUN(0.009))], rise=0.001)
        found = self.measured()
        self.assertAlmostEqual(found["ergunError"], 0, 9)
        self.assertEqual([found[name] for name in ("plateau", "carriedError", "dropSlope")], [None]*3)

    def testCanBeStudied(self):
        self.canBeStudied("31 variants, 93 runs")
        about = json.loads(self.ended(self.case/"measure", "-list").stdout)
        self.assertEqual({name for name, words in about.items() if words.get("exact") == 0},
                         {"ergunError", "ergunErrorLargest", "carriedError"})

    def prepared(self, folder):
        program = self.work/"bin/liggghts"
        program.parent.mkdir(exist_ok=True)
        program.write_text(SETTLE.replace("SETTLED", str(self.work/"settled")))
        program.chmod(0o755)
        ended = self.ended(folder/"prepare", PATH=f"{program.parent}:{os.environ['PATH']}")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return self.derived(folder)

    def testHasOneKnobForAllDirectionsOfTheMesh(self):
        for size, cells in ((None, ("8", "4", "24")), (4.6e-3, ("4", "2", "12")), (3.07e-3, ("6", "3", "18")),
                            (1.84e-3, ("10", "5", "30"))):
            folder = self.variant("mesh", *[f"cellSize={size}"]*bool(size))
            found = self.prepared(folder)
            self.assertEqual(tuple(found[key] for key in ("core", "rim", "layers")), cells)

    def testSettlesTheSameBedForOtherNumericsOfTheRun(self):
        self.prepared(self.case)
        for changes in ("demStep=5e-6", "cellSize=4.6e-3", "couplingNumber=0.1"):
            self.prepared(self.variant("other", changes))
        self.prepared(self.variant("other", "seed=49979687", "demStep=5e-6"))
        self.assertEqual((self.work/"settled").read_text(), "10000 32452843 1e-05\n10000 49979687 1e-05\n")


class BubblingBed(ACase):
    """A net weight of 150 Pa: mass (1 - rho_g/rho_p) g over area. Gas of 1.2 kg/m3 in 450 mm."""
    name = "fluidisedBed"
    AREA = 2.25e-3
    MASS = 150*AREA/GRAVITY/(1 - 1.2/2526)

    def run_(self, drop, height):
        """Functions of time; time passes in steps of 1 and 2 ms by turns, heights every ms."""
        self.write("system/caseDerived", f"area {self.AREA};\n")
        times = [1.5e-3*i + 0.5e-3*(i % 2) for i in range(1, 1001)]
        self.table("pressureDrop/0/volFieldValue.dat", [
            (t, "(0", "0", f"{-self.AREA*(drop(t)/1.2 + GRAVITY*0.45):.17g})") for t in times])
        self.table("bedHeight.dat", [(1e-3*i, height(1e-3*i)) for i in range(1501)])
        heads = ("massInDie massInShoe massElsewhere massAtStart massMissing particles outside lost "
                 "momentumRemainderX momentumRemainderY momentumRemainderZ dragImpulseX dragImpulseY "
                 "dragImpulseZ clippedVolume movedVolume hiddenVolume").split()
        values = [0.0, 0.0, self.MASS, self.MASS, -2e-9*self.MASS, 5000.0, 0.0, 3.0, 0.0, 3e-6, 4e-6,
                  0.0, 0.0, 1e-3, 7e-9, 0.0, 0.0]
        self.table("powderBalance/0/powderBalance.dat", [(0.1, *values)],
                   "# time [s]\t" + "\t".join(f"{head} [-]" for head in heads) + "\n")
        self.write("log.demPimpleFoam", "".join(
            f"t = {t} s  10.0 %  left 9 s | 5000 particles | dt {dt} s ({why}, 20 DEM steps) | air max {u} m/s, "
            f"Co 0.5, p iterations {n}\n" for t, dt, why, u, n in (
                (0.1, 1e-4, "powder response", 3.5, 40), (0.2, 3e-4, "maxDeltaT", 2.5, 20))))

    def testIsNullWhereThereIsNothing(self):
        self.nothingIsNull()

    def testIsMeasuredFromWhenItBubbles(self):
        """Four waves in the second from 0.5 s on; what comes before does not count."""
        wave = lambda t: math.sin(8*math.pi*t) if t > 0.4999 else 40
        self.run_(lambda t: 153 + 30*wave(t), lambda t: 0.1 + 0.002*wave(t))
        found = self.measured()
        for name, value, within in (("dropOverWeight", 1.02, 1e-4), ("meanDrop", 153, 0.02),
                                    ("dropDeviation", 30/math.sqrt(2), 0.02), ("meanHeight", 0.1, 1e-8),
                                    ("heightDeviation", 0.002/math.sqrt(2), 1e-8), ("massMissing", 2e-9, 1e-18),
                                    ("parcelsLost", 3, 0), ("clippedVolume", 7e-9, 0), ("peakAirSpeed", 3.5, 0),
                                    ("momentumRemainder", 5e-3, 1e-15), ("meanDt", 2e-4, 1e-15),
                                    ("responseBound", 0.5, 0), ("pressureIterations", 30, 0)):
            self.assertAlmostEqual(found[name], value, delta=within, msg=name)

    def testTellsTheErrorOfAMeanFromOneRun(self):
        """16 pieces of 1/16 s, 10 above and below by turns: by their scatter 10 sqrt(16/15)/4 = 2.582; by
        that of the many shorter pieces it would be less, and by the 8 pairs 0."""
        piece = lambda t: 10*(-1)**int(16*(t - 0.5))
        self.run_(lambda t: 150 + piece(t), lambda t: 0.1 + 1e-4*piece(t))
        found = self.measured()
        self.assertAlmostEqual(found["dropOverWeightRunError"], 2.582/150, delta=0.03*2.582/150)
        self.assertAlmostEqual(found["meanHeightRunError"], 2.582e-4, delta=0.03*2.582e-4)

    def testIsNullIfTheRunEndedBefore(self):
        self.run_(lambda t: 150, lambda t: 0.1)
        self.change(meansFrom=2.0)
        self.assertIsNone(self.measured()["meanDrop"])

    def testCanBeStudied(self):
        self.canBeStudied("14 variants, 42 runs")

    def testHasOneKnobForAllDirectionsOfTheMesh(self):
        for size, cells in ((None, ("2", "30", "90")), (10e-3, ("1", "15", "45")), (3.333e-3, ("3", "45", "135"))):
            folder = self.variant("mesh", *[f"cellSize={size}"]*bool(size))
            self.assertEqual(self.ended(folder/"prepare").returncode, 0)
            found = self.derived(folder)
            self.assertEqual(tuple(found[key] for key in ("cellsDeep", "cellsWide", "cellsHigh")), cells)

    def testSpheresDoNotBeginInEachOther(self):
        """3 mm from centre to centre, 2.5 mm across."""
        self.assertEqual(self.ended(self.variant("most", "displacement=2.5e-4")/"prepare").returncode, 0)
        refused = self.ended(self.variant("more", "displacement=2.6e-4")/"prepare")
        self.assertEqual(refused.returncode, 1)
        for words in ("spheres of the lattice overlap", "found   0.00026 m", "wanted  0 to 0.00025 m"):
            self.assertIn(words, refused.stderr)

    def testSettlesForSoManySteps(self):
        """0.6 s of 0.01 ms."""
        folder = self.variant("lying", "settleTime=0.6")
        self.assertEqual(self.ended(folder/"prepare").returncode, 0)
        self.assertEqual(self.derived(folder)["settleSteps"], "60000")
        refused = self.ended(self.variant("backwards", "settleTime=-0.1")/"prepare")
        self.assertEqual(refused.returncode, 1)
        for words in ("settleTime in system/caseParameters", "found   -0.1 s", "wanted  0 s"):
            self.assertIn(words, refused.stderr)


class Die(ACase):
    name = "dieFilling"

    def testPressureAtTheFloorIsThatOfTheAir(self):
        """p is over density; of a run that was stopped at 3 s and goes on from 2 s, the later table counts: 10 m2/s2 from
        1 s to 4 s, after a rise: 35/4."""
        self.table("floorPressure/0/p", [(0.0, 0.0), (1.0, 10.0), (2.0, 10.0), (3.0, 50.0)], "# Probe\n")
        self.table("floorPressure/2/p", [(3.0, 10.0), (4.0, 10.0)], "# Probe\n")
        found = self.measured()
        self.assertAlmostEqual(found["floorPressurePeak"], 12.25)
        self.assertAlmostEqual(found["floorPressureMean"], 1.225*35/4)

    def testParcelShareIsWhatPrepareFound(self):
        self.assertIsNone(self.measured()["parcelShare"])
        self.write("system/caseDerived", "FoamFile { }\nparcelDiameter 4e-4;\nparcelShare 0.849;\n")
        self.assertEqual(self.measured()["parcelShare"], 0.849)

    def refused(self, pattern, line, *words):
        """What `prepare` says of the parameters with another line in the place of one."""
        path = self.case/"system/caseParameters"
        text = path.read_text()
        path.write_text(re.sub(rf"^{pattern} .*$", line, text, flags=re.M))
        ended = self.ended(self.case/"prepare")
        path.write_text(text)
        self.assertEqual(ended.returncode, 1)
        self.assertNotIn("Traceback", ended.stderr)
        for word in words:
            self.assertIn(word, ended.stderr)

    def testCohesionWantsItsNumbers(self):
        for key, line, found in (("hamaker", "", "no hamaker"), ("hamaker", "hamaker -1;", "hamaker -1"),
                                 ("asperityRadius", "asperityRadius 0;", "asperityRadius 0"),
                                 ("contactGap", "contactGap near;", "contactGap near")):
            self.refused(key, line, f"cohesion off, {found}", f"wanted  {key} of")


if __name__ == "__main__":
    unittest.main()
