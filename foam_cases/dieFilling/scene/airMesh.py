# SPDX-License-Identifier: GPL-3.0-or-later
"""How the mesh of the air is made, and which shapes of dies go with which."""
import dies
from wrong import refuse


def choose(p, d):
    """airMesh: blocks (the box by blockMesh), snapped (to the die by snappyHexMesh) or penalised (the box, and where
    the die fills it a solid)."""
    shape, own = p["dieShape"], p["dieSurface"] != "none"
    if shape != "rectangular" and shape not in dies.SHAPES:
        refuse("There is no such dieShape in system/caseParameters.", shape,
               "one of rectangular, " + ", ".join(dies.SHAPES), "Correct it, or give the shape as dieSurface.")
    if shape != "rectangular" and own:
        refuse("A die has either a dieShape or a dieSurface.", f"dieShape {shape} and dieSurface {p['dieSurface']}",
               "dieShape rectangular or dieSurface none", "Leave one of them in system/caseParameters.")
    if shape in ("rhombic", "gear") and d["rig"] == "slice":
        refuse(f"A slice is the same all along y, and a {shape} die is not.", f"sliceWidth {p['sliceWidth']:g} m",
               "sliceWidth 0, the full rig", "Set it in system/caseParameters.")
    if p["dieWallsInAir"] not in ("snapped", "penalised"):
        refuse("There is no such dieWallsInAir in system/caseParameters.", p["dieWallsInAir"],
               "snapped or penalised", "Correct it.")
    d["airMesh"] = p["dieWallsInAir"] if own or shape != "rectangular" else "blocks"
    if d["airMesh"] == "snapped" and p["shoeSurface"] == "none" and p["shoeWallThickness"] < 1.99*p["cellSize"]:
        # The solver compares with the finest cell, and cells beside the die's walls are smaller than those on the way.
        refuse("The shoe's walls must be at least two cells thick, or air leaks through them.",
               f"shoeWallThickness {p['shoeWallThickness']:g} m", f"at least {2*p['cellSize']:g} m",
               "Thicken them or make cellSize smaller, in system/caseParameters.")
