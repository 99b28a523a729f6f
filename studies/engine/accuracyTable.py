# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a study's table as choices of the numerics: what each is worth, and what it takes.

A *knob* is a parameter that some variants change alone against the reference; of parameters that are
changed in step, the first stands for all. Standard errors of few packings are taken together (scatter),
and so are those of times. Of some measures the *exact* answer is
known: the case says so, or the user. Time is that of the solver, if the table tells it: whether a bed
had to be poured anew for a variant is no matter of its knob.
"""
import math
from dataclasses import dataclass, field

import scatter
from badInput import BadInput, nearest
from shownAs import isNumber, text
from tableFile import number


@dataclass
class Variant:
    label: str
    parameters: dict
    changes: dict  # against the reference
    times: dict  # column of the table -> s, or None if there is no good run
    seconds: float  # the one that counts
    secondsError: float  # of it
    packings: int
    values: dict = field(default_factory=dict)  # measure -> mean or None
    errors: dict = field(default_factory=dict)  # measure -> standard error or None


class Choices:
    """The variants of a table, the reference among them, and the knobs."""

    def __init__(self, table, reference=(), measures=None, knobs=None, trustErrors=False,
                 exact=None, inStep=()):
        self.table = table
        for column in ("variant", "status", "seconds"):
            if column not in table.columns:
                raise BadInput(f"{table.name} has no column '{column}': take the table.csv of a "
                               "study, as studies/study writes it.")
        self.clock = "seconds.solver" if any(row.get("seconds.solver") for row in table.rows) else "seconds"
        self.measures = self.chosenMeasures(measures)
        self.exact = self.exactAnswers(exact or {})
        keys = table.columns[table.columns.index("variant") + 1:table.columns.index("status")]
        self.variants = [self.variant(row, keys) for row in table.rows]
        self.reference = self.chosenReference(reference)
        for variant in self.variants:
            variant.changes = {key: value for key, value in variant.parameters.items()
                               if value != self.reference.parameters[key]}
        self.followLeader(inStep)
        self.knobs = self.chosenKnobs(knobs)
        if knobs:
            self.variants = [variant for variant in self.variants
                             if all(key in self.knobs for key in variant.changes)]
        self.pooled, self.apart = {}, {}  # measure -> standard deviation of one packing, variants that scatter more
        if not trustErrors:
            self.takeTogether()

    def chosenMeasures(self, wanted):
        there = [column[:-len(".error")] for column in self.table.columns
                 if column.endswith(".error") and column.split(".")[0] != "seconds"]
        for name in wanted or ():
            if name not in there:
                raise BadInput(f"{self.table.name} has no measure '{name}' with its error; "
                               + nearest(name, there))
        if not there:
            raise BadInput(f"{self.table.name} has no measures (columns NAME and NAME.error): take "
                           "the table.csv of a study, as studies/study writes it.")
        return list(wanted or there)

    def exactAnswers(self, given):
        """Measure -> what it would be without errors."""
        for name in given:
            if name not in self.measures:
                raise BadInput(f"--exact: there is no measure '{name}' among those of {self.table.name}; "
                               + nearest(name, self.measures))
        told = {name: self.table.about.get(name, {}).get("exact") for name in self.measures}
        return {**{name: value for name, value in told.items() if isNumber(value)}, **given}

    def variant(self, row, keys):
        parameters = {key: number(row[key]) for key in keys}
        times = {column: self.cell(row, column) for column in row if column.split(".")[0] == "seconds"}
        found = Variant(row["variant"], parameters, {}, times, times[self.clock], times.get(f"{self.clock}.error"),
                        int(self.cell(row, "packings") or 0) if "packings" in row else 0)
        for key in self.measures:
            found.values[key] = self.cell(row, key)
            found.errors[key] = self.cell(row, f"{key}.error")
        return found

    def cell(self, row, column):
        word = row.get(column)
        if column not in row:
            raise BadInput(f"{self.table.name} has no column '{column}': make it again by "
                           "studies/study FILE.yaml --tables-only.")
        value = number(word or "")
        if value == "":
            return None
        if isinstance(value, str) or not math.isfinite(value):
            raise BadInput(f"{self.table.name}, variant '{row['variant']}': '{column}' is '{word}' "
                           "and must be a finite number, or empty; run that variant again.")
        return value

    def chosenReference(self, conditions):
        rows = self.table.rows
        if conditions:
            rows = self.table.chosen(conditions)
        else:
            # studies/study leaves the differences of the reference empty.
            empty = [row for row in rows if row["status"] in ("ok", "partly") and all(
                row.get(f"{key}.difference") == "" for key in self.measures)]
            rows = empty if len(empty) == 1 else [self.middle()]
        if len(rows) > 1:
            raise BadInput(f"{len(rows)} rows of {self.table.name} have {' '.join(conditions)}: the "
                           "reference must be one; add more key=value to --reference.")
        found = next(v for row, v in zip(self.table.rows, self.variants) if row is rows[0])
        if not found.seconds or all(value is None for value in found.values.values()):
            raise BadInput(f"The reference '{found.label}' in {self.table.name} has no good run: run "
                           "it (studies/study, --retry), or name another by --reference KEY=VALUE.")
        return found

    def middle(self):
        """The row from which the most others differ in one parameter; the first of such."""
        def around(one):
            return sum(differences(one, other) == 1 for other in self.variants)
        counts = [around(variant) for variant in self.variants]
        return self.table.rows[counts.index(max(counts))]

    def followLeader(self, inStep):
        for key in inStep:
            self.table.known(key)
        seen = {}
        for variant in self.variants:
            if len(inStep) > 1 and inStep[0] in variant.changes:
                variant.changes = {key: value for key, value in variant.changes.items()
                                   if key not in inStep[1:]}
                other = seen.setdefault(tuple(variant.changes.items()), variant.label)
                if other != variant.label:
                    raise BadInput(f"--inStep {' '.join(inStep)}: '{other}' and '{variant.label}' in {self.table.name} "
                                   f"have the same {inStep[0]}, so that these do not change in step; leave it out.")

    def chosenKnobs(self, wanted):
        found = {}
        for variant in self.variants:
            if len(variant.changes) == 1:
                found.setdefault(next(iter(variant.changes)), []).append(variant)
        if not found:
            raise BadInput(f"No parameter of {self.table.name} is varied alone against the reference "
                           f"'{self.reference.label}': a study with oneAtATime does that.")
        for name in wanted or ():
            if name not in found:
                raise BadInput(f"'{name}' is not varied alone in {self.table.name}; "
                               + nearest(name, found))
        order = lambda variant, key: (isinstance(variant.changes[key], str), variant.changes[key])
        return {key: sorted(variants, key=lambda v, k=key: order(v, k))
                for key, variants in found.items() if not wanted or key in wanted}

    def takeTogether(self):
        """Errors of few packings, and of their times in shares of these, become those of all rows together."""
        for measure in self.measures:
            found = scatter.together([(variant.packings, variant.errors[measure]) for variant in self.variants])
            for variant, error in zip(self.variants, found.errors):
                variant.errors[measure] = error
            if found.onePacking is not None:
                self.pooled[measure] = found.onePacking
                self.apart[measure] = [self.variants[i] for i in found.apart]
        timed = [variant for variant in self.variants if variant.seconds]
        found = scatter.together([(variant.packings, variant.secondsError and variant.secondsError/variant.seconds)
                                  for variant in timed])
        for variant, error in zip(timed, found.errors):
            variant.secondsError = error and error*variant.seconds

    def timeRatio(self, variant):
        return variant.seconds/self.reference.seconds if variant.seconds else None

    def timeRatioError(self, variant):
        """Standard error, or None."""
        both = (variant, self.reference)
        if not all(one.seconds and one.secondsError is not None for one in both):
            return None
        return self.timeRatio(variant)*math.hypot(*(one.secondsError/one.seconds for one in both))

    def nameOf(self, variant):
        return " ".join(f"{key}={text(value)}" for key, value in variant.changes.items()) or "reference"


def differences(one, other):
    return sum(value != other.parameters[key] for key, value in one.parameters.items())
