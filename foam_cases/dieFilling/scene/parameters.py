# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of flat OpenFOAM dictionaries."""
import re


def read(*paths):
    """Key -> number or word."""
    values = {}
    for path in paths:
        text = re.sub(r"(//|#)[^\n]*", "", path.read_text())
        text = re.sub(r"FoamFile\s*{[^}]*}", "", text)
        for key, value in re.findall(r"(\w+)\s+([^;]+?)\s*;", text):
            try:
                values[key] = float(value)
            except ValueError:
                values[key] = value.strip('"')
    return values
