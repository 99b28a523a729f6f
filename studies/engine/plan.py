# SPDX-License-Identifier: GPL-3.0-or-later
"""From a study to its variants and runs, as plain data that goes into plan.json."""
import hashlib
import itertools
import json
import re

from badInput import BadInput
from shownAs import labelled, text


class Variants:
    """In the order of the study file; each once."""

    def __init__(self, study):
        self.study = study
        self.found = {}  # identity -> values of all parameters and ranks
        self.referenceOf = {}  # identity -> identity, or None

    def add(self, changes, inVary=False, again=False):
        values = self.values(changes)
        one = identity(values)
        if one in self.found:
            if not again:
                raise BadInput(f"{self.study.file.name}: the variant {written(changes)} stands there "
                               "twice; keep one.")
            return
        self.found[one] = values
        if self.study.reference is not None:
            start = changes if inVary and self.study.reference else self.study.base
            self.referenceOf[one] = identity(self.values({**start, **self.study.reference}))

    def values(self, changes):
        return {**self.study.case.parameters, "ranks": 1, **changes}


def identity(values):
    return tuple(text(value) for value in values.values())


def written(changes):
    return " ".join(f"{key}={text(value)}" for key, value in changes.items()) or "without changes"


def variantsOf(study):
    """Values of all parameters of each variant, and the number of its reference."""
    variants = Variants(study)
    for changes in combinations(study):
        variants.add({**study.base, **changes}, inVary=True)
    if study.oneAtATime or not variants.found and not study.variants:
        variants.add(study.base, again=True)
    for key, values in study.oneAtATime.items():
        for value in values:
            # The base's own value may stand in the list.
            same = text(value) == text(variants.values(study.base)[key])
            variants.add({**study.base, key: value}, again=same)
    for changes in study.variants:
        variants.add({**study.base, **changes})
    numbers = {one: number for number, one in enumerate(variants.found)}
    for one, reference in variants.referenceOf.items():
        if reference not in numbers:
            raise BadInput(f"{study.file.name}: the reference {written(study.reference)} of "
                           f"variant {numbers[one] + 1} is not among the variants; add it to "
                           "'variants', or name one that is.")
    references = [numbers.get(variants.referenceOf.get(one)) for one in variants.found]
    return list(variants.found.values()), references


def combinations(study):
    """Of all values in `vary`, and of each of them with each set of `together`; none if the study has neither."""
    axes = [[{key: value} for value in values] for key, values in study.vary.items()]
    if study.together:
        axes.append([dict(zip(study.together, values)) for values in zip(*study.together.values())])
    return [{key: value for part in parts for key, value in part.items()}
            for parts in itertools.product(*axes)] if axes else []


def planOf(study):
    all_, references = variantsOf(study)
    varied = [key for key in all_[0] if len({text(values[key]) for values in all_}) > 1]
    variants, runs = [], []
    for number, (values, reference) in enumerate(zip(all_, references)):
        label = " ".join(labelled(study.case.about.get(key, {}), key, values[key])
                         for key in varied) or "base"
        variants.append({"label": label, "parameters": values, "reference": reference})
        for packing, seed in enumerate(study.seeds, 1):
            runs.append(run(study, number, label, values, packing, seed))
    about = {key: {"kind": "parameter", **words} for key, words in study.case.about.items()}
    about["ranks"] = {"kind": "parameter", "symbol": "", "unit": "", "text": "MPI processes"}
    about.update({key: {"kind": "measure", **study.case.measures[key]} for key in study.measures})
    return {"study": study.name, "title": study.title, "case": str(study.case.folder),
            "keep": study.keep, "varied": varied, "measures": study.measures, "about": about,
            "variants": variants, "runs": runs}


def run(study, number, label, values, packing, seed):
    own = study.case.parameters
    changes = {key: text(value) for key, value in values.items()
               if key != "ranks" and text(value) != text(own[key])}
    values = dict(values)
    if seed is not None:
        values["seed"] = seed
        if text(seed) != text(own["seed"]):
            changes["seed"] = text(seed)
        label += f" seed {packing}"
    return {"id": name(values, changes), "variant": number, "label": label, "packing": packing,
            "seed": seed, "ranks": values["ranks"], "changes": changes}


def name(values, changes):
    """Readable, and the same whatever else is in the study. The hash is of all values, so that a
    result is not taken for one made with other defaults."""
    whole = json.dumps({key: text(value) for key, value in values.items()}, sort_keys=True)
    digest = hashlib.sha256(whole.encode()).hexdigest()[:10]
    ranks = [f"ranks{values['ranks']}"] if values["ranks"] != 1 else []
    words = "_".join([key + value for key, value in changes.items()] + ranks) or "base"
    return re.sub(r"[^A-Za-z0-9.-]+", "_", words)[:80] + "_" + digest


def code(name):
    """The same for the same run, whatever the study calls it."""
    return name[-10:]
