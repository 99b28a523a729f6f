# SPDX-License-Identifier: GPL-3.0-or-later
"""A die whose floor lets air through, into a room of lower pressure, from the moment on at which the shoe covers the die."""
from wrong import refuse

RISE = 1e-3  # until the suction is whole [s]


def derived(p, d, path):
    """dieFloorInAir, tight or porous, and dieFloorPatch, its kind in the mesh; of a porous one suctionHead [m2/s2], suctionFrom and suctionWhole [s]."""
    if p["suction"] == 0:
        return {"dieFloorInAir": "tight", "dieFloorPatch": "wall"}
    found = f"suction {p['suction']:g} Pa   system/caseParameters"
    if p["suction"] < 0:
        refuse("Suction is how far the pressure below the die is under that of the air around.", found, "0 or more",
               "Turn its sign.")
    if d["airMesh"] != "blocks":
        refuse("Only the floor of a rectangular die can be porous.", f"{found}, dieShape {p['dieShape']}, dieSurface "
               f"{p['dieSurface']}", "dieShape rectangular, dieSurface none", "Leave the suction out, or the shape.")
    if p["air"] == "off":
        refuse("Without air nothing can be sucked.", f"{found}, air off", "air auto or on",
               "Leave one of the two out.")
    covered = path.when(p["dieLength"] - d["shoeXHigh"]) if p["shoeLength"] >= p["dieLength"] else None
    if covered is None:
        refuse("Suction begins when the shoe covers the die.", f"{found}, a shoe of {p['shoeLength']:g} m that never covers "
               f"the die's {p['dieLength']:g} m", "a shoe that is long enough and goes so far", "Lengthen it or its way.")
    return {"dieFloorInAir": "porous", "dieFloorPatch": "patch", "suctionHead": -p["suction"]/p["airDensity"],
            "suctionFrom": covered, "suctionWhole": covered + RISE}
