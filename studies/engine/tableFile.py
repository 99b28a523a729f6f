# SPDX-License-Identifier: GPL-3.0-or-later
"""A study's table.csv: what of it belongs into a figure, and what its columns are called."""
import csv
import json
import math
import re

import shownAs
from badInput import BadInput, nearest
from groups import GROUPS
from shownAs import isNumber, labelled, text


class Table:
    """table.csv of a study and what its columns mean."""

    def __init__(self, path):
        try:
            with open(path, newline="") as file:
                self.rows = list(csv.DictReader(file))
            about = path.with_name("columns.json")
            self.about = json.loads(about.read_text()) if about.is_file() else {}
        except (OSError, ValueError) as reason:
            raise BadInput(f"The table {path} cannot be read: {reason}.")
        if not self.rows:
            raise BadInput(f"The table {path} has no rows: run its study first.")
        self.columns = list(self.rows[0])
        self.name = path.name

    def known(self, name):
        if name not in self.columns and name not in GROUPS:
            raise BadInput(f"{self.name} has no column or group '{name}'; "
                           + nearest(name, [*self.columns, *GROUPS]))

    def value(self, row, name):
        if name not in GROUPS or name in self.columns:
            return number(row[name])
        _, needed, formula = GROUPS[name]
        for key in needed:
            if key not in self.columns:
                raise BadInput(f"'{name}' follows from {', '.join(needed)}, and {self.name} has no "
                               f"column '{key}'.")
        values = [number(row[key]) for key in needed]
        return formula(*values)

    def label(self, name):
        if name in GROUPS and name not in self.columns:
            return GROUPS[name][0]
        about = self.about.get(name, {})
        words = readable(name) if about.get("kind") == "parameter" else about.get("text") or name
        symbol, unit = mathematics(about.get("symbol", "")), shownAs.unit(about)
        return f"{words} {symbol}".rstrip() + (f" [{superscripts(unit)}]" if unit else "")

    def nameOf(self, key, value):
        """Of a line: v = 0.1 m/s"""
        if key in GROUPS and key not in self.columns:
            return f"{GROUPS[key][0]} = {value:.4g}"
        symbol = mathematics(self.about.get(key, {}).get("symbol", ""))
        return f"{symbol or readable(key)} = {self.written(key, value, superscripts)}"

    def written(self, key, value, unitAs=str):
        """0.1 m/s"""
        about = self.about.get(key, {})
        tail = labelled(about, key, value).partition("=")[2]
        if isNumber(value) and abs(value) >= 1e6:
            tail = f"{value:.6g}"
        unit = about.get("unit", "")
        tail += f" {unitAs(unit)}" if unit not in ("", "1", "-", "m") else ""
        return re.sub(r"(\d)([mun]?m)$", r"\1 \2", tail).replace(" um", " µm")

    def chosen(self, conditions):
        """Rows that meet all `key=value`."""
        rows = self.rows
        for condition in conditions:
            key, equals, wanted = condition.partition("=")
            if not equals:
                raise BadInput(f"--where wants key=value, and has '{condition}'.")
            self.known(key)
            rows = [row for row in rows if text(self.value(row, key)) == text(number(wanted))]
            if not rows:
                there = sorted({row[key] for row in self.rows if key in row})
                raise BadInput(f"{self.name} has no row with {condition}"
                               + (f"; {key} is {', '.join(there)}." if there else "."))
        return rows


def number(word):
    try:
        return float(word)
    except ValueError:
        return word


def readable(key):
    """shoeSpeed: shoe speed"""
    return re.sub(r"(?<=[a-z])([A-Z])", lambda match: " " + match[1].lower(), key)


def mathematics(symbol):
    head, _, below = symbol.partition("_")
    if not head:
        return ""
    return f"${head}" + (rf"_{{\mathrm{{{below}}}}}" if below else "") + "$"


def superscripts(unit):
    return re.sub(r"(?<=[a-zA-Z])(-?\d)", r"$^{\1}$", unit)


def lines(table, chosen):
    """[(name, [(x, y, error)])]: one for each value of the parameter that makes lines."""
    for name in filter(None, (chosen.x, chosen.y, chosen.lines)):
        table.known(name)
    found, at = {}, {}
    for row in table.chosen(chosen.where):
        x, y = table.value(row, chosen.x), table.value(row, chosen.y)
        line = table.value(row, chosen.lines) if chosen.lines else ""
        if isinstance(y, str) or isinstance(x, str):
            if y == "":
                continue  # nothing was found there
            raise BadInput(f"'{chosen.x if isinstance(x, str) else chosen.y}' is no number in "
                           f"{table.name}, it is '{x if isinstance(x, str) else y}'.")
        if not (math.isfinite(x) and math.isfinite(y)):
            raise BadInput(f"'{chosen.y if math.isfinite(x) else chosen.x}' is not finite in "
                           f"{table.name}, variant '{row.get('variant', '')}': choose other rows by "
                           "--where, or empty that cell.")
        other = at.setdefault((line, round(x, 12)), row)
        if other is not row:
            raise BadInput(f"Two rows of {table.name} lie at {chosen.x} = {x:g} on one line; they "
                           f"differ in {differing(other, row)}: choose by --where or --lines.")
        error = number(row.get(f"{chosen.y}.error") or "0")
        found.setdefault(line, []).append((x, y, error))
    if not found:
        raise BadInput(f"{table.name} has no number '{chosen.y}' to draw: see the column 'status'.")
    ordered = sorted(found, key=lambda line: (isinstance(line, str), line))
    return [(line, sorted(found[line])) for line in ordered]


def differing(one, other):
    """The parameters; they stand left of the column 'status'."""
    keys = list(one)
    keys = keys[keys.index("variant") + 1:keys.index("status")] if "status" in keys else keys
    return ", ".join(key for key in keys if one[key] != other[key]) or "nothing"
