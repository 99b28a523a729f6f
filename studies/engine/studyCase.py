# SPDX-License-Identifier: GPL-3.0-or-later
"""A case that can be studied: it has parameters, and makes, runs and measures its variants.

    variant NAME key=value...   makes variants/NAME
    run [-np RANKS]             in a variant's folder: one run
    measure                     there, after the run: one JSON object {name: number or null}
    measure -list               {name: {unit, text, symbol, shown}}
    system/caseParameters       keys and their default values
    studies/ranges.yaml         optional: key: [lowest, highest], or key: [word, word, ...]
"""
import json
import re
import subprocess

import yamlFile
from badInput import BadInput, nearest
from shownAs import isNumber, text

LINE = re.compile(r"^(\w+)\s+([^;{]+?)\s*;\s*(?://\s*(.*))?$", re.M)
SYMBOL = re.compile(r"([A-Za-z](?:_\w+)?)\s*(?=[\[:,])")
UNIT = re.compile(r"\[([^\]]*)\]")
# Columns of the tables; no parameter or measure may have such a name.
COLUMNS = ("ranks", "id", "variant", "packing", "packings", "status", "reason", "particles",
           "seconds")
NEEDED = ("variant", "run", "measure", "system/caseParameters")


class Case:
    def __init__(self, folder):
        self.folder = folder
        for name in NEEDED:
            if not (folder/name).is_file():
                raise BadInput(f"The case {folder} cannot be studied, it has no {name}: studies/"
                               "README.md says what a case must have.")
        self.parameters, self.about = {}, {}
        for key, value, comment in LINE.findall((folder/"system/caseParameters").read_text()):
            self.parameters[key] = (yamlFile.number(value) if yamlFile.NUMBER.match(value)
                                    else value.strip('"'))
            self.about[key] = told(comment)
        self.ranges = self.readRanges()
        self.measures = self.listMeasures()
        names = [*self.parameters, *self.measures]
        for name in names:
            if name in COLUMNS or names.count(name) > 1:
                raise BadInput(f"The case {folder} cannot be studied: '{name}' is the name of more "
                               "than one column of the tables; rename that parameter or measure.")

    def readRanges(self):
        path = self.folder/"studies/ranges.yaml"
        ranges = yamlFile.read(path) if path.is_file() else {}
        for key, value in ranges.items():
            if key not in self.parameters:
                raise BadInput(f"{path}: the case has no parameter '{key}'; "
                               + nearest(key, self.parameters))
            numbers = isinstance(value, list) and len(value) == 2 and all(map(isNumber, value))
            words = isinstance(value, list) and value and all(isinstance(v, str) for v in value)
            if not (numbers or words):
                raise BadInput(f"{path}: the range of '{key}' must be [lowest, highest] or a list "
                               "of words.")
        return ranges

    def listMeasures(self):
        try:
            listed = subprocess.run([self.folder/"measure", "-list"], cwd=self.folder, text=True,
                                    capture_output=True, check=True)
            measures = json.loads(listed.stdout)
            if not measures or not all(isinstance(about, dict) for about in measures.values()):
                raise ValueError("a list of {unit, text, symbol} is wanted")
        except subprocess.CalledProcessError as reason:
            raise BadInput(f"'{self.folder}/measure -list' failed: "
                           + " ".join(reason.stderr.split()[-30:]))
        except (OSError, ValueError, AttributeError) as reason:
            raise BadInput(f"'{self.folder}/measure -list' tells no measures: {reason}.")
        return measures

    def check(self, key, value, where):
        """That a value may stand for a parameter; `where` begins the sentence if not."""
        where = f"{where}: "
        if key not in self.parameters:
            raise BadInput(f"{where}the case {self.folder.name} has no parameter '{key}'; "
                           + nearest(key, [*self.parameters, "ranks"]))
        default = self.parameters[key]
        if isNumber(default):
            if not isNumber(value):
                raise BadInput(f"{where}'{key}' must be a number, as {text(default)} in "
                               f"system/caseParameters, and is {shown(value)}.")
        elif not isinstance(value, str) or not re.fullmatch(r"[^\s;|&\\]+", value):
            raise BadInput(f"{where}'{key}' must be a word, as '{default}' in "
                           f"system/caseParameters, and is {shown(value)}.")
        self.checkRange(key, value, where)

    def checkRange(self, key, value, where):
        limits = self.ranges.get(key)
        if limits and isinstance(limits[0], str):
            if value not in limits:
                raise BadInput(f"{where}'{key}' cannot be {shown(value)}; "
                               + nearest(value, limits))
        elif limits and isNumber(value):
            low, high = limits
            if not low <= value <= high:
                raise BadInput(f"{where}'{key}' must lie between {text(low)} and {text(high)}, and "
                               f"is {text(value)}.")
        elif isNumber(value) and self.parameters[key] > 0 and not value > 0:
            raise BadInput(f"{where}'{key}' must be greater than zero, as {text(self.parameters[key])}"
                           f" in system/caseParameters, and is {text(value)}.")


def told(comment):
    """Symbol and unit from the comment beside a parameter, as in '// d_p [m]'."""
    symbol, unit = SYMBOL.match(comment), UNIT.search(comment)
    return {"symbol": symbol.group(1) if symbol else "", "unit": unit.group(1) if unit else "",
            "text": comment}


def shown(value):
    if value is None:
        return "empty"
    return f"'{value}'" if isinstance(value, str) else text(value) if isNumber(value) else str(value)


def around(path):
    """The folder of the case in which a study file lies."""
    for folder in path.resolve().parents:
        if (folder/"system/caseParameters").is_file():
            return folder
    raise BadInput(f"{path.name} lies in no case (no folder above it has system/caseParameters): "
                   "move it beside a case, or name one by 'case: ...'.")
