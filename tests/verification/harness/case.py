# SPDX-License-Identifier: GPL-3.0-or-later
"""A box of air with grains in it: written from the template, run, and read back."""
import os
import pathlib
import re
import shutil
import subprocess
import time

from .laws import Powder

TEMPLATE = pathlib.Path(__file__).resolve().parent.parent/"template"
AXES = "xyz"
PATCHES = {"x": ("west", "east"), "y": ("south", "north"), "z": ("bottom", "top")}
FACES = {"west": "0 4 7 3", "east": "1 2 6 5", "south": "0 1 5 4", "north": "3 7 6 2",
         "bottom": "0 3 2 1", "top": "4 5 6 7"}


class Failed(Exception):
    """A program that should have run to its end did not."""


class Box:
    """size [m] and cells in x, y, z. `sides` names what bounds each axis: "periodic", or a pair of
    "slip", "noSlip", "inlet" and "outlet" (a single one stands for both)."""

    def __init__(self, size, cells, sides=("periodic", "periodic", "periodic")):
        self.size = size
        self.cells = cells
        self.sides = [side if isinstance(side, tuple) else (side, side) for side in sides]

    @property
    def cell(self):
        return [length/n for length, n in zip(self.size, self.cells)]

    @property
    def volume(self):
        return self.size[0]*self.size[1]*self.size[2]

    def patches(self):
        for axis, kinds in zip(AXES, self.sides):
            pair = PATCHES[axis]
            for name, kind, other in zip(pair, kinds, reversed(pair)):
                yield name, kind, other


def lattice(box, perCell, layers=None):
    """Positions of a simple cubic lattice, so many along each edge of a cubic cell, in all cells or
    in those of the layers [first, last) along z. Every cell then holds the same."""
    step = box.cell[0]/perCell
    first, last = layers or (0, box.cells[2])
    return [((i + 0.5)*step, (j + 0.5)*step, (k + 0.5)*step)
            for k in range(first*perCell, last*perCell)
            for j in range(box.cells[1]*perCell)
            for i in range(box.cells[0]*perCell)]


class Case:
    """What a run depends on. Lengths of parcels are k times those of the powder's grains."""

    def __init__(self, name, box, powder=None, **options):
        self.name = name
        self.box = box
        self.powder = powder or Powder()
        self.positions = []
        self.velocity = (0.0, 0.0, 0.0)  # of the grains, or a function of a grain's position
        self.spin = (0.0, 0.0, 0.0)  # of the grains [rad/s]
        self.motion = "free"  # or frozen; prescribed: each keeps its velocity; or tied: one rigid
        # body that moves along z
        self.k = 1
        self.lawName = "GidaspowHuilin"
        self.gravity = (0.0, 0.0, 0.0)  # on the grains
        self.airGravity = (0.0, 0.0, 0.0)
        self.compressibility = ""  # keys of transportProperties
        self.U = (0.0, 0.0, 0.0)  # of the air, at the start and through an inlet
        self.deposit = "kernel"
        self.smoothingWidth = 0.0
        self.minimum = 0.2
        self.deltaT = 1e-4
        self.adjustTimeStep = False
        self.subSteps = 1
        self.endTime = 1e-3
        self.writeInterval = None
        self.timeStep = ""
        self.air = "on"
        # Most closed forms know drag and pressure only. With an empty text all effects are auto.
        self.effects = "shearLift off; spinLift off; virtualMass off; viscousForce off;"
        self.pressureTolerance = 1e-12
        self.correctors = 1
        self.outer = 1
        self.slices = "z"
        self.processors = "* * *"
        self.recordEvery = 0  # DEM steps between records of the grains
        for key, value in options.items():
            if not hasattr(self, key):
                raise TypeError(f"a case has no {key}")
            setattr(self, key, value)

    @property
    def demStep(self):
        return self.deltaT/self.subSteps

    @property
    def diameter(self):
        return self.k*self.powder.diameter

    def write(self, folder, ranks):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(TEMPLATE, folder)
        values = self.values(ranks)
        for path in folder.rglob("*"):
            if path.is_file():
                path.write_text(re.sub(r"@(\w+)@", lambda m: values[m.group(1)],
                                       path.read_text()))
        if self.positions:
            (folder/"powder.data").write_text(self.grains())

    def values(self, ranks):
        air = self.powder.air
        numbers = {
            "endTime": self.endTime, "deltaT": self.deltaT, "demStep": self.demStep,
            "writeInterval": self.writeInterval or self.endTime, "ranks": ranks, "k": self.k,
            "correctors": self.correctors, "outer": self.outer,
            "nu": air.viscosity/air.density, "rho": air.density,
            "smoothingWidth": self.smoothingWidth, "minimum": self.minimum,
            "pressureTolerance": self.pressureTolerance, "X": self.box.size[0],
            "Y": self.box.size[1], "Z": self.box.size[2], "skin": 0.02*min(self.box.size)}
        texts = {
            "adjustTimeStep": "on" if self.adjustTimeStep else "off",
            "slices": " ".join(str(ranks) if a == self.slices else "1" for a in AXES),
            "airGravity": spaced(self.airGravity), "law": self.lawName, "deposit": self.deposit,
            "timeStep": self.timeStep, "effects": self.effects, "air": self.air,
            "compressibility": self.compressibility, "cells": " ".join(map(str, self.box.cells)),
            "U": spaced(self.U), "processors": self.processors}
        texts.update({key: format(value, ".15g") for key, value in numbers.items()})
        texts.update(self.boundaries())
        texts.update(self.script())
        return texts

    def boundaries(self):
        mesh, velocities, pressures = [], [], []
        speed = f"value uniform ({spaced(self.U)});"
        rules = {
            "periodic": ("cyclic", "type cyclic;", "type cyclic;"),
            "slip": ("wall", "type slip;", "type zeroGradient;"),
            "noSlip": ("wall", "type noSlip;", "type zeroGradient;"),
            "inlet": ("patch", "type fixedValue; " + speed, "type zeroGradient;"),
            "outlet": ("patch", "type pressureInletOutletVelocity; " + speed,
                       "type fixedValue; value uniform 0;")}
        for name, kind, other in self.box.patches():
            patch, velocity, pressure = rules[kind]
            neighbour = f" neighbourPatch {other};" if kind == "periodic" else ""
            mesh.append(f"    {name} {{ type {patch};{neighbour} faces (({FACES[name]})); }}")
            velocities.append(f"    {name} {{ {velocity} }}")
            pressures.append(f"    {name} {{ {pressure} }}")
        return {"boundary": "\n".join(mesh), "velocities": "\n".join(velocities),
                "pressures": "\n".join(pressures)}

    def script(self):
        size = self.box.size
        edges = ["p" if side[0] == "periodic" else "f" for side in self.box.sides]
        pull = sum(g*g for g in self.gravity)**0.5
        motions = {
            "free": "fix integrate all nve/sphere",
            "frozen": "group moving subtract all all\nfix integrate moving nve/sphere",
            "prescribed": "fix integrate all nve/noforce",
            "tied": "fix integrate all rigid single force 1 off off on torque 1 off off off"}
        return {
            "dem_boundary": " ".join(edges),
            "particles": '"read_data powder.data"' if self.positions else
                f'"region box block 0 {size[0]:.15g} 0 {size[1]:.15g} 0 {size[2]:.15g} units box" '
                '"create_box 1 box"',
            "gravity": f"fix g all gravity {pull:.15g} vector {spaced(self.gravity)}"
                if pull and self.positions else "",
            "motion": motions[self.motion] if self.positions else motions["free"],
            "dump": f"dump record all custom {self.recordEvery} record.txt id x y z vx vy vz\n"
                'dump_modify record sort id format "%d %.15g %.15g %.15g %.15g %.15g %.15g"'
                if self.recordEvery else ""}

    def grains(self):
        lines = ["grains", "", f"{len(self.positions)} atoms", "1 atom types", ""]
        lines += [f"0 {length:.15g} {a}lo {a}hi" for a, length in zip(AXES, self.box.size)]
        lines += ["", "Atoms", ""]
        lines += [f"{i} 1 {self.diameter:.15g} {self.powder.density:.15g} {spaced(x)}"
                  for i, x in enumerate(self.positions, 1)]
        velocities = [self.velocity(x) if callable(self.velocity) else self.velocity
                      for x in self.positions]
        if any(map(any, velocities)) or any(self.spin):
            lines += ["", "Velocities", ""]
            lines += [f"{i} {spaced(v)} {spaced(self.spin)}" for i, v in enumerate(velocities, 1)]
        return "\n".join(lines) + "\n"


def spaced(numbers):
    return " ".join(format(x, ".15g") for x in numbers)


def fill(path, kind, values):
    """Gives a field these values in the cells, as texts."""
    lines = path.read_text().splitlines()
    end = next(i for i, line in enumerate(lines) if line.startswith("boundaryField"))
    start = next(i for i, line in enumerate(lines) if line.startswith("internalField"))
    inside = [f"internalField nonuniform List<{kind}>", str(len(values)), "("] + values + [");"]
    path.write_text("\n".join(lines[:start] + inside + lines[end:]) + "\n")


class Run:
    """A case that was run, in its folder."""

    def __init__(self, case, folder, ranks, seconds, log):
        self.case = case
        self.folder = folder
        self.ranks = ranks
        self.seconds = seconds
        self.log = log

    def times(self):
        return sorted((p.name for p in self.folder.iterdir()
                       if re.fullmatch(r"[0-9][0-9.e-]*", p.name) and p.name != "0"), key=float)

    def field(self, name, time=None):
        """Cell values [x fastest, then y, then z] of a field, the last one written by default."""
        text = (self.folder/(time or self.times()[-1])/name).read_text()
        cells = self.case.box.cells
        count = cells[0]*cells[1]*cells[2]
        uniform = re.search(r"internalField\s+uniform\s+([^;]+);", text)
        if uniform:
            return [value(uniform.group(1))]*count
        found = re.search(r"internalField\s+nonuniform\s+List<\w+>\s+\d+\s*\((.*?)\)\s*;", text,
                          re.S)
        # Short lists stand on one line.
        return [value(cell) for cell in re.findall(r"\([^)]*\)|[^\s()]+", found.group(1))]

    def layers(self, name, time=None):
        """Mean of a scalar field, or of the z component of a vector field, in each layer along z."""
        values = self.field(name, time)
        cells = self.case.box.cells
        area = cells[0]*cells[1]
        scalars = [v[-1] if isinstance(v, tuple) else v for v in values]
        return [sum(scalars[i*area:(i + 1)*area])/area for i in range(cells[2])]

    def pressureLayers(self, time=None):
        rho = self.case.powder.air.density
        return [rho*p for p in self.layers("p", time)]

    def budget(self):
        """Rows of time, air, powder, remainder: momentum [N s]."""
        rows = self.table("momentumBudget")
        return [(r[0], tuple(r[1:4]), tuple(r[4:7]), tuple(r[7:10])) for r in rows]

    def table(self, name):
        """Rows of numbers of a function object. A run that was resumed has a table for each
        start; of an earlier one counts what lies before the next start."""
        rows = []
        paths = (self.folder/"postProcessing").glob(f"{name}/*/*")
        for path in sorted((p for p in paths if p.name != "moments.dat"),
                           key=lambda p: float(p.parent.name)):
            rows = [row for row in rows if row[0] <= float(path.parent.name)]
            rows += [list(map(float, line.split())) for line in path.read_text().splitlines()
                     if not line.startswith("#")]
        return rows

    def record(self):
        """The grains by time: {time: {id: (position, velocity)}}."""
        frames = {}
        blocks = (self.folder/"record.txt").read_text().split("ITEM: TIMESTEP\n")[1:]
        for block in blocks:
            lines = block.splitlines()
            grains = {}
            for line in lines[8:]:
                numbers = line.split()
                x = tuple(map(float, numbers[1:7]))
                grains[int(numbers[0])] = (x[:3], x[3:])
            frames[int(lines[0])*self.case.demStep] = grains
        return frames


def value(text):
    text = text.strip()
    return tuple(map(float, text[1:-1].split())) if text.startswith("(") else float(text)


def environment(folder):
    env = dict(os.environ, PWD=str(folder))
    env.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    env.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
               OMPI_MCA_mpi_yield_when_idle="1")
    return env


def execute(folder, command, log, timeout=300):
    with open(folder/log, "w") as out:
        code = subprocess.run(command, cwd=folder, env=environment(folder), stdout=out,
                              stderr=subprocess.STDOUT, timeout=timeout).returncode
    text = (folder/log).read_text()
    if code:
        raise Failed(f"{command[0]} ended with {code} in {folder}\n" + text[-3000:])
    return text


def run(case, folder, ranks, solver):
    """Writes and runs a case; raises Failed with the log's end if a program fails."""
    case.write(folder, ranks)
    execute(folder, ["blockMesh"], "log.blockMesh")
    command = [solver]
    if ranks > 1:
        execute(folder, ["decomposePar"], "log.decomposePar")
        command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), solver,
                   "-parallel"]
    start = time.monotonic()
    log = execute(folder, command, "log.demPimpleFoam")
    seconds = time.monotonic() - start
    if ranks > 1:
        execute(folder, ["reconstructPar"], "log.reconstructPar")
    return Run(case, folder, ranks, seconds, log)


def goOn(run, time_, solver):
    """From a time that a run on one rank wrote to its end once more, in a copy that knows nothing later."""
    folder = run.folder.with_name(run.folder.name + "_goes_on")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(run.folder, folder)
    for name in run.times():
        if float(name) > float(time_):
            shutil.rmtree(folder/name)
    control = folder/"system/controlDict"
    control.write_text(re.sub("startFrom .*;", "startFrom latestTime;", control.read_text()))
    start = time.monotonic()
    log = execute(folder, [solver], "log.demPimpleFoam")
    return Run(run.case, folder, 1, time.monotonic() - start, log)
