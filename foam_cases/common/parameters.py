# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of a case, and what follows from them: flat OpenFOAM dictionaries, read by every script of a case."""
import re

from wrong import refuse


class Parameters(dict):
    """A key that is missing is told, and is the end."""

    def __init__(self, where):
        super().__init__()
        self.where = where

    def __missing__(self, key):
        refuse("Each parameter must have a value.", f"no {key}   {self.where}", f"{key} and its value",
               "Add it, as it stands in the case that this is a copy of.")


def read(*paths):
    """Key -> number or word."""
    values = Parameters(", ".join(f"{path.parent.name}/{path.name}" for path in paths))
    for path in paths:
        text = re.sub(r"(//|#)[^\n]*", "", path.read_text())
        text = re.sub(r"FoamFile\s*{[^}]*}", "", text)
        for key, value in re.findall(r"(\w+)\s+([^;]+?)\s*;", text):
            try:
                values[key] = float(value)
            except ValueError:
                values[key] = value.strip('"')
    return values


def writeDerived(case, values, digits):
    """system/caseDerived, which takes the parameters in."""
    text = lambda v: f"{v:.{digits}g}" if isinstance(v, (int, float)) else v
    (case/"system/caseDerived").write_text(
        "// Written by prepare from caseParameters: change that file.\n"
        "FoamFile { version 2.0; format ascii; class dictionary; object caseDerived; }\n\n"
        '#include "caseParameters"\n\n'
        + "".join(f"{key:<19} {text(value)};\n" for key, value in values.items()))
