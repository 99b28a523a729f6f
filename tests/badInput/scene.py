# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes in the LIGGGHTS script, in steps, in the scene, in the command; and values that turn
into no number during a run."""
from judge import Mistake, main

SCRIPT = "powder.in"
CONTROL = "system/controlDict"
COUPLING = "constant/couplingProperties"


def script(name, text, replacement, *words):
    return Mistake(name, (SCRIPT, text, replacement), [SCRIPT, *words])


def liggghts(name, text, replacement, *words):
    return Mistake(name, (SCRIPT, text, replacement), ["LIGGGHTS stopped", SCRIPT, *words],
                   ours=False)


scripts = [
    script("no integrator", "fix             motion all nve/sphere", "", "moves the particles",
           "nve/sphere"),
    Mistake("no walls", [(SCRIPT, "fix             plate", "#"),
                         (SCRIPT, "fix             blockWall", "#")],
            [SCRIPT, "no fix wall/gran", "walls off", "key walls"]),
    script("no time step", "timestep        2e-6\nthermo          100000\nrun             0", "",
           "needs a time step", "timestep 1e-6"),
    liggghts("no stiffness", "fix             young all", "#", "youngsModulus"),
    liggghts("unknown command", "newton ", "newtn ", "newtn", "Unknown command"),
    liggghts("unknown contact model", "model hertz", "model hurtz", "hurtz"),
    liggghts("unknown variable", "${grainRadius}", "${grainSize}", "grainSize"),
    liggghts("no STL", "block.stl", "blocks.stl", "blocks.stl"),
    Mistake("a script that ends the program", (SCRIPT, "newton ", "quit\nnewton "),
            ["LIGGGHTS ended the program", SCRIPT], ours=False),
]

fixed = (CONTROL, "adjustTimeStep      on", "adjustTimeStep      off")
steps = [
    Mistake("DEM step too long", (COUPLING, "couplingNumber 0.2", "demStep 1e-5"),
            ["found   demStep 1e-05 s", "Rayleigh", COUPLING, "key demStep"]),
    Mistake("coupling step too long", [fixed, (CONTROL, "endTime             6e-4",
                                               "endTime             9"),
                                       (CONTROL, "5e-5", "0.3")],
            ["found   deltaT 0.3 s", "response time", CONTROL, "adjustTimeStep"]),
    Mistake("coupling step no multiple of the DEM step",
            [fixed, (COUPLING, "couplingNumber 0.2", "demStep 3e-6")],
            ["found   deltaT 5e-05 s", "whole number", CONTROL, "Set deltaT to"]),
    Mistake("endTime 0", (CONTROL, "endTime             6e-4", "endTime             0"),
            ["endTime", CONTROL, "more than the start"]),
    Mistake("end before the start", (CONTROL, "startTime           0;", "startTime           1;"),
            ["endTime", CONTROL, "more than the start"]),
    Mistake("deltaT 0", (CONTROL, "5e-5", "0"), ["deltaT", CONTROL]),
    Mistake("negative deltaT", (CONTROL, "5e-5", "-5e-5"), ["deltaT", CONTROL]),
    Mistake("writeInterval 0", (CONTROL, "writeInterval       6e-4", "writeInterval 0"),
            ["writeInterval", CONTROL]),
    Mistake("maxCo 0", (CONTROL, "maxDeltaT ", "maxCo 0;\nmaxDeltaT "), ["maxCo", CONTROL]),
    Mistake("maxDeltaT 0", (CONTROL, "1e-4", "0"), ["maxDeltaT", CONTROL]),
]

scenes = [
    Mistake("powder's box beside the mesh", [
        (SCRIPT, "block 0 2e-3", "block 0.1 0.102"),
        (SCRIPT, "block 0.1e-3 1.9e-3", "block 0.1 0.102"),
        (SCRIPT, "block.stl type 1", "block.stl type 1 move 0.1 0 0")],
            ["share space", "create_box", "blockMeshDict"]),
    Mistake("particles in millimetres", [("system/powderParameters", "1e-4", "1e-1"),
                                         (SCRIPT, "5e-5 bin", "1e-3 bin")],
            ["smaller than the domain", "0.2"]),
    Mistake("all particles beside the mesh", [
        (SCRIPT, "block 0 2e-3 0 2e-3 0 4e-3", "block 0 8e-3 0 2e-3 0 4e-3"),
        (SCRIPT, "block 0.1e-3 1.9e-3", "block 4.1e-3 5.9e-3")],
            ["share space", "particles", "blockMeshDict"]),
]

commands = [
    Mistake("-parallel forgotten", [], ["2 ranks", "-parallel", "decomposePar"], ranks=(2,),
            arguments=[]),
    Mistake("cut for another number of ranks", ("system/decomposeParDict", "2;", "3;"),
            ["specifies 3 processors", "2 processors"], ranks=(2,), ours=False),
    Mistake("unknown option", [], ["-paralel"], arguments=["-paralel"], ours=False),
    Mistake("LIGGGHTS cut for another number of ranks", (SCRIPT, "processors      * 1 1",
                                                         "processors      3 1 1"),
            ["LIGGGHTS stopped", "processors"], ours=False),
]

push = """group           one id 3
variable        push equal (step>100)*1e200*1e200
fix             kick one addforce v_push 0.0 0.0
fix             weight"""
running = [
    Mistake("no number in the air", ("0/U", "constant (0 0 0)",
                                     "table ((0 (0 0 0)) (3e-4 (0 0 0)) (4e-4 (0 0 1e300)))"),
            ["no number", "cell ", " of rank ", "was written before stopping"], state=True),
    Mistake("no number in the powder", (SCRIPT, "fix             weight", push),
            ["no number", "particle 3 ", "was written before stopping"], state=True),
]

if __name__ == "__main__":
    main(scripts + steps + scenes + commands + running)
