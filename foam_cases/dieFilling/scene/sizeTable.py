# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of particle sizes, as CSV: diameters [m] and what there is of each, or (of a sieve) what is finer.

    # lines like this one are left out
    diameter, massFraction          or numberFraction: share of the particles of this diameter
    30e-6, 0.2
    40e-6, 0.5
    60e-6, 0.3

    diameter, massFiner             or numberFiner: share of what is finer, ascending from 0 to 1
    20e-6, 0
    45e-6, 0.4
    63e-6, 1
"""
import math

import numpy as np

import csvLines
from wrong import refuse, word

COLUMNS = ("massFraction", "numberFraction", "massFiner", "numberFiner")
TOLERANCE = 1e-3  # of a sum: fractions are rounded


def classes(path, name):
    """Diameters of the classes and their fractions by mass."""
    kind, rows = read(path, name)
    d, share = np.array(rows).T
    fractions = kind.endswith("Fraction")
    (checkFractions if fractions else checkFiner)(share, name)
    if fractions:
        volume = d**3
        amount = share
    else:
        amount = np.diff(share)
        low, high = d[:-1], d[1:]
        # Evenly over ln d between two sieves: mean of d^3 over number, or one over the mean of d^-3 over mass.
        width = 3*np.log(high/low)
        volume = (high**3 - low**3)/width if kind.startswith("number") else width/(low**-3 - high**-3)
    mass = amount*volume if kind.startswith("number") else amount
    some = amount > 0
    return np.cbrt(volume[some]), mass[some]/mass[some].sum()


def read(path, name):
    if not path.is_file():
        refuse("The table of particle sizes is not there.", f"sizeTable {name}   system/caseParameters",
               f"a file {path}", "Correct sizeTable, or choose another sizeDistribution than table.")
    lines = csvLines.read(path)
    head = lines[0][1] if lines else []
    if len(head) != 2 or head[0] != "diameter":
        refuse("The first line of a table of particle sizes names its columns.", f"{','.join(head)}   {name}",
               "diameter, and one of " + ", ".join(COLUMNS), "Add that line.")
    kind = word("The second column", head[1], COLUMNS, name)
    rows = [row(cells, f"line {i} of {name}") for i, cells in lines[1:]]
    if len(rows) < 2:
        refuse("A table of particle sizes needs two rows.", f"{len(rows)}   {name}", "2 or more",
               "Add rows, or choose sizeDistribution mono.")
    for before, (d, _) in zip(rows, rows[1:]):
        if not d > before[0]:
            refuse("Diameters in a table of particle sizes must ascend.", f"{d:g} after {before[0]:g}   {name}",
                   "a larger one", "Sort the rows.")
    return kind, rows


def row(cells, where):
    try:
        d, share = map(float, cells)
    except ValueError:
        d = share = math.nan
    if not (0 < d < 1 and 0 <= share < math.inf):
        refuse("A row of a table of particle sizes is a diameter in metres and a fraction.",
               f"{', '.join(cells)}   {where}", "two numbers, the first above 0 and below 1, the second not below 0",
               "Correct that row.")
    return d, share


def checkFractions(share, name):
    if abs(share.sum() - 1) > TOLERANCE:
        refuse("Fractions of particle sizes must sum to 1.", f"a sum of {share.sum():.6g}   {name}", "1",
               "Write fractions, not percent or masses." if share.sum() > 2 else "Correct or complete the table.")


def checkFiner(share, name):
    for before, after in zip(share, share[1:]):
        if after < before:
            refuse("What is finer can only grow with the diameter.", f"{after:g} after {before:g}   {name}",
                   f"{before:g} or more", "Correct the table.")
    if share[0] != 0 or abs(share[-1] - 1) > TOLERANCE:
        refuse("What is finer begins at 0 and ends at 1.", f"from {share[0]:g} to {share[-1]:g}   {name}",
               "from 0 to 1",
               "Write fractions, not percent." if share[-1] > 2 else
               "Add the diameter below which there is nothing, and the one below which there is all.")
