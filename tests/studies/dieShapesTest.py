# SPDX-License-Identifier: GPL-3.0-or-later
"""Dies of other shapes: closed bodies of known volume, what is refused of a user's own, and how uniformly a cavity
is filled, on packings whose answer is known."""
import math
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True

import numpy as np

from program import loaded

ROOT = Path(__file__).resolve().parents[2]
prepare = loaded(ROOT/"foam_cases/dieFilling/prepare")  # which makes the modules below known

import airMesh
import dies
import geometry
import stl
import uniformity
import walls
from cavity import Cavity

L, D = 8e-3, 5e-3
# In plan [m2]: a square less half of it in the lower half; half the product of diagonals; eight times tip, two
# flanks and root as triangles at the middle, of 1/3, 1/6, 1/6, 1/3 of the pitch, 45 degrees.
PITCH = math.pi/4
MOUTH = {"stepped": L*L, "rhombic": 0.5*L*L*math.tan(math.pi/6),
         "gear": 8*0.5*((L/2)**2*math.sin(PITCH/3) + (3*L/8)**2*math.sin(PITCH/3)
                        + 2*(L/2)*(3*L/8)*math.sin(PITCH/6))}
VOLUME = {"stepped": 0.75*L*L*D, "rhombic": MOUTH["rhombic"]*D, "gear": MOUTH["gear"]*D}


def numbers(**changes):
    p = dict(prepare.read(), sliceWidth=0, **changes)
    return p, geometry.rig(p)


class TheBody(unittest.TestCase):
    def testIsClosedAndHoldsWhatIsLeftOfItsBox(self):
        for shape, volume in VOLUME.items():
            p, d = numbers(dieShape=shape)
            body = dies.body(p, d)
            self.assertEqual(len(stl.openEdges(body)), 0, shape)
            low, high, bottom = dies.extent(p, d)
            box = float(np.prod(high - low))*-bottom
            self.assertAlmostEqual((box - stl.volume(body))/volume, 1, 6, shape)

    def testHasACavityOfKnownVolumeAndMouth(self):
        for shape in dies.SHAPES:
            p, d = numbers(dieShape=shape)
            volume, mouth = stl.cavity(dies.body(p, d), d)
            self.assertAlmostEqual(volume/VOLUME[shape], 1, 9, shape)
            self.assertAlmostEqual(mouth/MOUTH[shape], 1, 9, shape)

    def testInASliceHasTheSlicesVolume(self):
        p = dict(prepare.read(), dieShape="stepped", sliceWidth=2e-3)
        d = geometry.rig(p)
        volume, mouth = stl.cavity(dies.body(p, d), d)
        self.assertAlmostEqual(volume/(0.75*L*2e-3*D), 1, 9)
        self.assertAlmostEqual(mouth/(L*2e-3), 1, 9)

    def testOfARhombusHasCornersOf60Degrees(self):
        (loop,), _ = dies.rhombic(*numbers(dieShape="rhombic"))
        a, b, c, _ = np.array(loop)
        sharp = (b - a) @ (loop[3] - a)/np.linalg.norm(b - a)/np.linalg.norm(loop[3] - a)
        self.assertAlmostEqual(math.degrees(math.acos(sharp)), 60, 9)

    def testInCubesHasItsVolume(self):
        """81 cubes along the mouth: to half a cube at each wall."""
        for shape, volume in VOLUME.items():
            p, d = numbers(dieShape=shape)
            cavity = Cavity.of(d, dies.body(p, d))
            self.assertLess(abs(cavity.room.sum()*cavity.cube()/volume - 1), 0.015, shape)
        # What lies below the step of a stepped die is body where x is in its first or last quarter.
        p, d = numbers(dieShape="stepped")
        room = Cavity.of(d, dies.body(p, d)).room
        self.assertEqual(room[10, 40].tolist(), [z >= room.shape[2]//2 for z in range(room.shape[2])])
        self.assertTrue(room[40].all())


class AUsersSurface(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = Path(folder.name)
        self.p, self.d = numbers(dieShape="rhombic")
        self.p.update(dieShape="rectangular", dieSurface="own.stl", shoeSurface="own.stl")
        self.body = dies.body(dict(self.p, dieShape="rhombic"), self.d)

    def read(self, triangles, name="die"):
        stl.write(self.case/"own.stl", [tuple(map(tuple, t)) for t in triangles])
        return walls.given(self.case, self.p, name)

    def refused(self, *wanted, **how):
        with self.assertRaises(SystemExit) as raised:
            self.read(how["triangles"], how.get("name", "die")) if "triangles" in how else \
                walls.meetsTable(self.p, self.d, how["body"])
        for words in (*wanted, "own.stl", "found", "wanted"):
            self.assertIn(words, str(raised.exception))

    def testIsTakenIfItIsClosedAndMeetsTheTable(self):
        body = self.read(self.body)
        walls.meetsTable(self.p, self.d, body)
        self.assertAlmostEqual(stl.cavity(body, self.d)[0]/VOLUME["rhombic"], 1, 6)

    def testIsRefusedIfItIsNotClosed(self):
        for name in ("die", "shoe"):
            self.refused(f"{name}Surface must be closed", "3 others", triangles=self.body[1:], name=name)
            turned = self.body.copy()
            turned[0] = turned[0, ::-1]
            self.refused(f"{name}Surface must be closed", triangles=turned, name=name)
            self.refused(f"{name}Surface must have its normals outwards", triangles=self.body[:, ::-1], name=name)

    def testIsRefusedIfItDoesNotMeetTheTable(self):
        self.refused("does not meet the table: its rim", "0.0001 m", body=self.body + [0, 0, 1e-4])
        self.refused("does not meet the table: its rim", body=self.body - [0, 0, 1e-4])
        self.refused("outside the box of the die in x", "Correct dieLength", body=self.body + [1e-3, 0, 0])
        self.refused("outside the box of the die in y", "Correct dieWidth", body=self.body + [0, 3e-3, 0])
        self.refused("outside the box of the die in z", "-0.00625", body=self.body*[1, 1, 1.25])
        plate = np.array(walls.box((-1, -1, -1), (1, 1, 0)))
        self.refused("must have a cavity", body=plate)

    def testIsRefusedIfItIsNoStl(self):
        (self.case/"own.stl").write_bytes(b"no triangles")
        with self.assertRaisesRegex(SystemExit, "must be an STL file"):
            walls.given(self.case, self.p, "shoe")

    def testGoesWithNoShapeAndAGearWithNoSlice(self):
        for changes, wanted in ((dict(dieShape="gear"), "either a dieShape or a dieSurface"),
                                (dict(dieShape="gaer", dieSurface="none"), "one of rectangular, stepped"),
                                (dict(dieWallsInAir="off"), "snapped or penalised")):
            with self.assertRaisesRegex(SystemExit, wanted):
                airMesh.choose({**self.p, **changes}, self.d)
        with self.assertRaisesRegex(SystemExit, "at least two cells thick"):
            airMesh.choose(dict(self.p, cellSize=0.8e-3, shoeSurface="none"), self.d)  # walls of 1.5 mm
        with self.assertRaisesRegex(SystemExit, "sliceWidth 0, the full rig"):
            airMesh.choose(dict(self.p, dieShape="gear", dieSurface="none", sliceWidth=2e-3), dict(rig="slice"))


def lattice(pitch, low, high):
    """Centres a whole number of pitches apart that fill a box evenly."""
    axes = [low[n] + pitch*(np.arange(round((high[n] - low[n])/pitch)) + 0.5) for n in range(3)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


class Uniformity(unittest.TestCase):
    def fill(self, shape, points, diameter=0.25e-3, **changes):
        p, d = numbers(dieShape=shape, **changes)
        body = () if shape == "rectangular" else dies.body(p, d)
        return uniformity.between({**p, **d, "parcelDiameter": diameter}, points, body)

    def cubic(self, pitch=1/3*1e-3):
        """Eight pitches a bin in plan, five in height: 0.25 mm spheres, solid fraction pi/6 (3/4)^3 = 0.2209."""
        return lattice(pitch, (0, -4e-3, -5e-3), (8e-3, 4e-3, 0))

    def testOfALatticeVariesNowhere(self):
        fill = self.fill("rectangular", self.cubic())
        density, room = fill.density()
        self.assertAlmostEqual(room.sum()/(L*L*D), 1, 9)
        self.assertAlmostEqual(fill.powder.sum()/(len(self.cubic())*math.pi/6*0.25e-3**3), 1, 9)
        self.assertLess(np.abs(density/(math.pi/6*0.75**3) - 1).max(), 0.03)
        found = fill.numbers()
        self.assertLess(found["uniformity"], 0.02)
        self.assertGreater(found["worstCorner"], 0.97)

    def testFindsAnEmptyCorner(self):
        """One bin of 27 with nothing: mean 26/27, variation sqrt(26)/26."""
        points = self.cubic()
        corner = (points[:, 0] > 2/3*L) & (points[:, 1] > L/6) & (points[:, 2] < -2/3*D)
        found = self.fill("rectangular", points[~corner]).numbers()
        self.assertAlmostEqual(found["uniformity"], math.sqrt(26)/26, 2)
        self.assertLess(found["worstCorner"], 0.02)
        for axis, middle in zip("XYZ", (5/6*L, L/3, -5/6*D)):
            self.assertAlmostEqual(found[f"worst{axis}"], middle, 4)

    def testFindsAnEmptyTooth(self):
        """The tooth at y = -4 mm, at 3/4 of a turn; centre of its bin on the axis x = 4 mm, at half a layer."""
        points = lattice(0.25e-3, (0, -4e-3, -5e-3), (8e-3, 4e-3, 0))
        u, v = points[:, 0] - L/2, points[:, 1]
        tooth = (np.hypot(u, v) > 3e-3) & (np.abs(u) < -v*math.tan(PITCH/2)) & (points[:, 2] > -D/3)
        found = self.fill("gear", points[~tooth], 0.25e-3).numbers()
        self.assertLess(found["worstCorner"], 0.1)
        self.assertAlmostEqual(found["worstX"], L/2, 4)
        self.assertAlmostEqual(found["worstY"], -3.45e-3, 4)
        self.assertAlmostEqual(found["worstZ"], -D/6, 4)

    def testTellsAGapAtTheWalls(self):
        """Nothing within 0.5 mm, evenly filled elsewhere: of a layer of 1 mm in a square of 8 mm, 64 - 36 mm2, 13 mm2
        hold powder."""
        points = lattice(0.25e-3, (0.5e-3, -3.5e-3, -5e-3), (7.5e-3, 3.5e-3, 0))
        fill = self.fill("rectangular", points, 0.25e-3)
        fill.parcel = 1e-3  # as if of large parcels
        self.assertAlmostEqual(fill.wallGap(), 13/28, delta=0.02)  # cubes of 0.1 mm
        full = self.fill("rectangular", lattice(0.25e-3, (0, -4e-3, -5e-3), (8e-3, 4e-3, 0)), 0.25e-3)
        full.parcel = 1e-3
        self.assertAlmostEqual(full.wallGap(), 1, delta=0.02)
        # The lower, narrower half of a stepped die full, the upper one empty: no gap at any height.
        stem = self.fill("stepped", lattice(0.25e-3, (2e-3, -4e-3, -5e-3), (6e-3, 4e-3, -2.5e-3)), 0.25e-3)
        stem.parcel = 1e-3
        self.assertAlmostEqual(stem.wallGap(), 1, delta=0.02)

    def testTakesEachParcelsDiameter(self):
        """As OpenFOAM writes them, by two ranks: 0.5 mm, and twice 0.25 mm in a list of one value."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        head = "FoamFile\n{{\n    format      {};\n}}\n// * * * //\n\n"
        one = b"1\n(" + np.array([0.5e-3]).tobytes() + b")"
        for rank, kind, points, d in ((0, "binary", ["(2e-3 0 -2e-3) 0"], one),
                                      (1, "ascii", ["(6e-3 0 -2e-3) 0", "(6e-3 0 -3e-3) 0"], b"2{0.25e-3}")):
            powder = Path(folder.name)/f"processor{rank}/0.1/lagrangian/powder"
            powder.mkdir(parents=True)
            (powder/"positions").write_text(head.format("ascii") + f"{len(points)}\n(\n" + "\n".join(points)
                                            + "\n)\n")
            (powder/"d").write_bytes(head.format(kind).encode() + d + b"\n")
        home = Path(folder.name)
        self.assertEqual(uniformity.cloud.diameters(home).tolist(), [0.5e-3, 0.25e-3, 0.25e-3])
        p, d = numbers(dieShape="rectangular")
        fill = uniformity.between({**p, **d, "parcelDiameter": 1e-3}, uniformity.cloud.parcels(home), (),
                                  uniformity.cloud.diameters(home))
        half = fill.powder.shape[0]//2
        self.assertAlmostEqual(fill.powder[:half].sum()/(math.pi/6*0.5e-3**3), 1, 9)
        self.assertAlmostEqual(fill.powder[half:].sum()/(math.pi/3*0.25e-3**3), 1, 9)

    def testOfASliceGoesOnBeyondItsEnds(self):
        """A parcel at one end: half of it lies at the other, and there are no side walls there."""
        p = dict(prepare.read(), sliceWidth=2e-3)
        d = geometry.rig(p)
        fill = uniformity.between({**p, **d, "parcelDiameter": 0.5e-3}, [(4e-3, 1e-3, -3e-3)], ())
        self.assertAlmostEqual(fill.powder.sum()/(math.pi/6*0.5e-3**3), 1, 9)
        half = fill.powder.shape[1]//2
        self.assertAlmostEqual(fill.powder[:, :half].sum()/fill.powder.sum(), 0.5, 1)
        self.assertTrue(fill.cavity.core(0.5e-3)[40].all())


if __name__ == "__main__":
    unittest.main()
