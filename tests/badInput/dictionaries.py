# SPDX-License-Identifier: GPL-3.0-or-later
"""Mistakes in the dictionaries of a case: keys, names, signs, dimensions, files."""
from judge import Mistake, main

COUPLING = "constant/couplingProperties"
TRANSPORT = "constant/transportProperties"


def coupling(name, text, replacement, *words):
    return Mistake(name, (COUPLING, text, replacement), [COUPLING, *words])


def floor(value):
    return coupling(f"void fraction floor {value}", "minimum 0.3", f"minimum {value}",
                    f"found   {value}", "between zero and one", "key minimum")


keys = [
    coupling("misspelt required key", "script", "scirpt", "no key script", "Is scirpt a misspelt"),
    coupling("misspelt optional key", "coarseGraining", "coarsegraining",
             "Did you mean coarseGraining?"),
    coupling("misspelt key of a group", "couplingNumber", "couplingNumbr",
             "Did you mean couplingNumber?", "stabilityLimit"),
    coupling("misspelt key of a solid", "surface", "surfce", "no key surface"),
    coupling("misspelt group", "voidFraction ", "voidfraction ", "Did you mean voidFraction?"),
    coupling("misspelt required group", "powder  ", "podwer  ", "no key powder",
             "Is podwer a misspelt"),
    coupling("misspelt switch", "air    ", "aire   ", "Did you mean air?"),
    coupling("missing group", 'powder          { script "powder.in"; parameters '
             '"system/powderParameters"; coarseGraining 1; }', "", "no key powder", "Add it."),
    coupling("missing key", 'script "powder.in";', "", "no key script", "Add it."),
    coupling("value in place of a group", "{ law GidaspowHuilin; }", "GidaspowHuilin;",
             "A group of keys", "found   GidaspowHuilin", "key drag"),
    Mistake("missing nu", (TRANSPORT, "nu ", "// nu "), [TRANSPORT, "no key nu", "Add it."]),
    Mistake("misspelt nu", (TRANSPORT, "nu ", "nuu "), [TRANSPORT, "no key nu"]),
    Mistake("missing rho", (TRANSPORT, "rho ", "// rho "), [TRANSPORT, "no key rho", "Add it."]),
    Mistake("compressible air of no pressure", (TRANSPORT, "rho ", "compressibility isothermal; rho "),
            [TRANSPORT, "no key pressure", "Add it."]),
    Mistake("misspelt rho", (TRANSPORT, "rho ", "rhoo "),
            [TRANSPORT, "no key rho", "Is rhoo a misspelt rho?"]),
]

# Has the dimensions of a velocity.
BODY_FORCE = """FoamFile { version 2.0; format ascii; class volVectorField; object bodyForce; }
dimensions      [0 1 -1 0 0 0 0];
internalField   uniform (1 0 0);
boundaryField
{
    ".*"            { type zeroGradient; }
    "proc.*"        { type processor; value uniform (1 0 0); }
}
"""

names = [
    coupling("unknown drag law", "GidaspowHuilin", "GidaspowHulin", "found   GidaspowHulin",
             "KochHill", "Beetstra", "Did you mean GidaspowHuilin?", "key law"),
    coupling("unknown choice for an effect", "drag  ", "effects { shearLift maybe; }\ndrag  ", "found   maybe",
             "auto", "key shearLift"),
    coupling("unknown effect", "drag  ", "effects { shearLfit on; }\ndrag  ",
             "Did you mean shearLift?"),
    coupling("turbulence of a laminar air", "drag  ", "effects { turbulence on; }\ndrag  ", "turbulence on here, off by",
             "key simulationType", "effects, key turbulence"),
    coupling("no pressure force", "drag  ", "effects { pressureGradient off; }\ndrag  ", "pressureGradient off", "on or auto",
             "effects, key pressureGradient"),
    coupling("walls in the air, and not", "drag  ", "effects { movingWalls off; }\ndrag  ", "on by the group solids",
             "effects, key movingWalls"),
    coupling("what is not available", "drag  ", "effects { history on; }\ndrag  ", "history on", "not available",
             "effects, key history"),
    coupling("unknown deposit", "kernel", "kernal", "found   kernal", "centre",
             "Did you mean kernel?", "key deposit"),
    coupling("unknown mesh wall", "block {", "shoe {", "found   shoe", "block", "mesh wall"),
    Mistake("unknown viscosity model", (TRANSPORT, "Newtonian", "Newtonain"),
            ["Newtonain", "CrossPowerLaw", TRANSPORT]),
    Mistake("unknown turbulence", ("constant/turbulenceProperties", "laminar", "laminer"),
            ["laminer", "RAS", "turbulenceProperties"]),
    Mistake("unknown boundary condition", ("0/U", "slip", "slipp"),
            ["slipp", "noSlip", "0/U"]),
    Mistake("unknown time scheme", ("system/fvSchemes", "Euler", "backward"),
            ["found   backward", "wanted  Euler", "fvSchemes"]),
    Mistake("unknown compressibility", (TRANSPORT, "rho ", "compressibility isotherml; rho "),
            [TRANSPORT, "found   isotherml", "Did you mean isothermal?", "key compressibility"]),
    Mistake("no predictor", ("system/fvSolution", "momentumPredictor yes", "momentumPredictor no"),
            ["found   momentumPredictor off", "fvSolution"]),
    Mistake("unknown linear solver", ("system/fvSolution", "PCG", "PCGG"),
            ["PCGG", "GAMG", "fvSolution"]),
]

values = [
    floor("0"), floor("1"), floor("1.2"), floor("-0.3"),
    coupling("void fraction floor for drag 1.5", "minimum 0.3", "minimumForDrag 1.5",
             "found   1.5", "key minimumForDrag"),
    coupling("negative width", "smoothingWidth 0", "smoothingWidth -1e-3", "found   -0.001 m",
             "not below zero", "key smoothingWidth"),
    coupling("k of zero", "coarseGraining 1", "coarseGraining 0", "above zero",
             "key coarseGraining"),
    coupling("coupling number of zero", "couplingNumber 0.2", "couplingNumber 0", "above zero",
             "key couplingNumber"),
    coupling("negative DEM step", "couplingNumber 0.2", "demStep -1e-6", "found   -1e-06 s",
             "key demStep"),
    coupling("a word for a number", "minimum 0.3", "minimum low", "found   low", "key minimum"),
    coupling("unknown choice for the air", "air             on", "air twoway", "found   twoway",
             "Did you mean twoWay?", "key air"),
    coupling("a word for a switch", "{ script", "{ walls perhaps; script", "found   perhaps", "on or off",
             "key walls"),
    Mistake("negative nu", (TRANSPORT, "1.5e-5", "-1.5e-5"), [TRANSPORT, "found   -1.5e-05", "key nu"]),
    Mistake("nu of zero", (TRANSPORT, "1.5e-5", "0"), [TRANSPORT, "found   0", "key nu"]),
    Mistake("negative pressure", (TRANSPORT, "rho ", "compressibility isothermal; pressure -1e5; rho "),
            [TRANSPORT, "found   -100000", "key pressure"]),
    Mistake("negative rho", (TRANSPORT, "1.2", "-1.2"), [TRANSPORT, "found   -1.2", "key rho"]),
    Mistake("dimensions of nu", (TRANSPORT, "1.5e-5", "[1 -1 -1 0 0 0 0] 1.8e-5"),
            [TRANSPORT, "found   [1 -1 -1 0 0 0 0]", "[0 2 -1 0 0 0 0]", "key nu"]),
    Mistake("dimensions of rho", (TRANSPORT, "1.2", "[0 0 0 0 0 0 0] 1.2"),
            [TRANSPORT, "found   [0 0 0 0 0 0 0]", "[1 -3 0 0 0 0 0]", "key rho"]),
    Mistake("dimensions of U", ("0/U", "[0 1 -1 0 0 0 0]", "[0 2 -2 0 0 0 0]"),
            ["found   [0 2 -2 0 0 0 0]", "wanted  [0 1 -1 0 0 0 0]", "0/U"]),
    Mistake("dimensions of p", ("0/p", "[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]"),
            ["found   [1 -1 -2 0 0 0 0]", "wanted  [0 2 -2 0 0 0 0]", "0/p"]),
    Mistake("dimensions of bodyForce", ("0/bodyForce", None, BODY_FORCE),
            ["found   [0 1 -1 0 0 0 0]", "wanted  [0 1 -2 0 0 0 0]", "0/bodyForce"]),
]

files = [
    Mistake("no couplingProperties", (COUPLING, "", None), [COUPLING]),
    Mistake("no transportProperties", (TRANSPORT, "", None), [TRANSPORT]),
    Mistake("no field U", ("0/U", "", None), ["0/U"]),
    Mistake("patch missing in p", ("0/p", "sides", "others"), ["sides", "0/p"]),
    Mistake("no mesh", [(f"constant/polyMesh/{name}", "", None) for name in
                        ("points", "faces", "owner", "neighbour", "boundary")], ["A case needs a mesh", "constant/polyMesh", "blockMesh"]),
    coupling("no LIGGGHTS script", "powder.in", "powders.in", "powders.in", "script"),
    coupling("no LIGGGHTS script there", "powder.in", "/nowhere/powder.in", "wanted  a file /nowhere/powder.in",
             "script"),
    coupling("no surface of a solid", "block.stl", "blocks.stl", "blocks.stl", "key surface"),
    coupling("no parameters", "powderParameters", "powderParameter", "key parameters",
             "powderParameter"),
]

if __name__ == "__main__":
    main(keys + names + values + files)
