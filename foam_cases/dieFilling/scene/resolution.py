# SPDX-License-Identifier: GPL-3.0-or-later
"""What the sizes of parcels and cells make of a result, as far as it is known before a run: studies/accuracy.md."""

LEAST_SPREAD = 4.5  # of a parcel's volume, in its diameters
SHARE_TOLD = 0.95


def parcelShare(p, parcelDiameter):
    """What parcels let through the mouth over what grains do. An opening is narrower by 1.4 of them [W. A. Beverloo,
    H. A. Leniger & J. van de Velde, Chem. Eng. Sci. 15 (1961) 260-269]; the flow through a slot goes as its power 3/2,
    and walls that open and close it at an even speed make of that 5/2 of the whole length. What side walls
    of the full rig take from it is not counted."""
    def through(diameter):
        return max(0, 1 - 1.4*diameter/p["dieLength"])**2.5
    grains = through(parcelDiameter/p["coarseGraining"])
    return through(parcelDiameter)/grains if grains > 0 else 0


def spread(p, d):
    """Of a parcel's volume on the air, by kernel and smoothing together, in its diameters."""
    return (kernel(p) + d["smoothingWidth"])/d["parcelDiameter"]


def kernel(p):
    return 2*p["cellSize"] if p["deposit"] == "kernel" else 0


def told(p, d):
    """What passes the mouth, in a sentence; None if it is nearly what grains do."""
    if d.get("parcelShare", 1) >= SHARE_TOLD:
        return None
    return (f"Parcels of {1e3*d['parcelDiameter']:.3g} mm let {100*d['parcelShare']:.0f} % of grains' flow through a mouth of "
            f"{1e3*p['dieLength']:.3g} mm (Beverloo's law): compare runs with the same parcels, and do not quote one "
            "(studies/accuracy.md).")


def tell(p, d):
    if not d["parcelDiameter"] > 0:
        return
    if sentence := told(p, d):
        print(sentence)
    if p["air"] != "off" and spread(p, d) < LEAST_SPREAD - 1e-9:
        print(f"WARNING: a parcel's volume is spread over {spread(p, d):.2g} of its diameters (kernel and smoothing together): "
              f"below {LEAST_SPREAD:g} parcels pump air that the powder would not. smoothingDiameters "
              f"{LEAST_SPREAD + 0.5 - kernel(p)/d['parcelDiameter']:.2g} would do.")
