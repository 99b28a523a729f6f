# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of a frozen bed whose void fraction is exactly uniform, free surfaces included.

Expected: alpha dp/L = beta U/alpha with the drag law itself, so dp/L inside the bed, and the sum of
it over the void fraction on the mesh, layer by layer, across the whole bed. Neither the coupling
step nor the size of parcels nor the number of ranks may change it.

A frozen grain gets the drag of a free one over a DEM step, 1 - x/2 of it with x = b dt/m: the DEM
steps are so short that this is below 1e-4.
"""
from harness.bench import main
from harness.case import Box, Case, lattice
from harness.laws import Powder, gidaspowHuilin

SPEED = 0.1  # superficial [m/s]
LAYERS = 20
BED = (6, 15)  # on 4 ranks cut across the flow, two have no grain
INSIDE = (8, 12)  # between the centres of these layers, more than a cell from both surfaces
EXACT = 1e-3
OVER_SURFACES = 5e-3
ALIKE = 1e-6


def bed(name, voidFraction, perCell, steps, cut="z", k=1, cells=2, **options):
    """steps: coupling step in response times of the powder."""
    powder = Powder(law=gidaspowHuilin)
    spacing = (3.14159265358979/6/(1 - voidFraction))**(1/3)*k*powder.diameter
    edge = perCell*spacing
    box = Box((cells*2*edge, cells*edge, LAYERS*edge), (cells*2, cells, LAYERS),
              ("periodic", "periodic", ("inlet", "outlet")))
    deltaT = steps*powder.bedResponse(voidFraction, SPEED)
    case = Case(name, box, powder, k=k, motion="frozen", U=(0, 0, SPEED), deltaT=deltaT,
                subSteps=max(1, round(5000*voidFraction**2*steps)), endTime=6*deltaT, slices=cut,
                timeStep="stabilityLimit 100;", positions=lattice(box, perCell, BED), **options)
    return case


def drops(bench, case, voidFraction):
    """Pressure drop inside and over the whole bed, measured and expected."""
    powder = case.powder
    height = case.box.cell[2]
    area = case.box.size[0]*case.box.size[1]
    force = powder.slope(voidFraction, SPEED)*voidFraction*area*height*(BED[1] - BED[0])
    run = bench.run(case, impulse=force*case.deltaT)
    p = run.pressureLayers()
    mapped = sum(powder.slope(alpha, SPEED)*height for alpha in run.layers("voidFraction"))
    return (run, p[INSIDE[0]] - p[INSIDE[1]],
            powder.slope(voidFraction, SPEED)*height*(INSIDE[1] - INSIDE[0]), p[0] - p[-1], mapped)


def verify(bench):
    whole, gradients = {}, []
    for voidFraction in (0.40, 0.45, 0.60, 0.79, 0.81):
        for steps in (0.02, 2):
            if bench.ranks > 1 and (voidFraction not in (0.40, 0.81) or steps == 2):
                continue
            name = f"bed {100*voidFraction:.0f} %, dt {steps:g} tau"
            case = bed(name, voidFraction, 2, steps)
            run, inside, expected, across, mapped = drops(bench, case, voidFraction)
            bench.near(run, "pressure drop inside [Pa]", expected, inside, EXACT)
            bench.near(run, "pressure drop over the bed [Pa]", mapped, across, OVER_SURFACES)
            whole[name] = across
            gradients.append((voidFraction, inside/case.box.cell[2]/(INSIDE[1] - INSIDE[0])))
    bench.curve("frozen beds", "void fraction", "pressure drop [Pa/m]", [
        (alpha, case.powder.slope(alpha, SPEED)) for alpha in (0.38 + 0.005*i for i in range(90))], gradients)

    along = bed("bed 40 %, cut along flow", 0.40, 2, 0.02, cut="x")
    run, inside, expected, across, mapped = drops(bench, along, 0.40)
    bench.near(run, "pressure drop inside [Pa]", expected, inside, EXACT)
    bench.near(run, "as when cut across the flow [Pa]", whole["bed 40 %, dt 0.02 tau"], across,
               ALIKE)

    # A parcel stands for 512 grains in the same cell; each has all its volume where its centre is.
    grains = bed("512 grains a cell", 0.40, 8, 0.02, deposit="centre", cells=1)
    run, inside, expected, across, mapped = drops(bench, grains, 0.40)
    bench.near(run, "pressure drop inside [Pa]", expected, inside, EXACT)
    parcels = bed("1 parcel a cell, k = 8", 0.40, 1, 0.02, deposit="centre", k=8, cells=1)
    run, inside, expected, ofParcels, mapped = drops(bench, parcels, 0.40)
    bench.near(run, "pressure drop as of grains [Pa]", across, ofParcels, ALIKE)


if __name__ == "__main__":
    main(verify)
