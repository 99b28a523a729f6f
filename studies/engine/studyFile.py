# SPDX-License-Identifier: GPL-3.0-or-later
"""A study file, read and checked: nothing runs before all of it is right."""
import re
from dataclasses import dataclass
from pathlib import Path

import studyCase
import yamlFile
from badInput import BadInput, nearest
from seeds import SEEDS
from shownAs import text
from studyCase import shown

KEYS = ("case", "title", "base", "vary", "together", "oneAtATime", "variants", "packings", "ranks", "measures",
        "reference", "keep")


@dataclass
class Study:
    name: str
    file: Path
    case: studyCase.Case
    title: str
    base: dict
    vary: dict  # key -> values
    together: dict  # key -> values, the first of each belonging together, the second, ...
    oneAtATime: dict
    variants: list  # of changes
    seeds: list  # [None]: the case has none
    measures: list
    reference: dict  # None: no differences
    keep: bool


def read(path):
    content = yamlFile.read(path)
    where = path.name
    for key in content:
        if key not in KEYS:
            raise BadInput(f"{where}: a study has no key '{key}'; " + nearest(key, KEYS))
    name = path.stem
    if not re.fullmatch(r"[A-Za-z0-9_.-]+", name):
        raise BadInput(f"{where}: the name of a study may have letters, digits, '_', '-' and '.' "
                       "only, as it becomes the name of folders: rename the file.")
    case = studyCase.Case(caseFolder(path, content))
    base = changes(case, content.get("base"), f"{where}, base")
    if "ranks" in content:
        if "ranks" in base:
            raise BadInput(f"{where}: 'ranks' stands in the study and in its base; keep one.")
        base["ranks"] = ranks(content["ranks"], where)
    reference = content.get("reference")
    if "reference" in content:
        reference = changes(case, reference, f"{where}, reference")
    return Study(
        name, path.resolve(), case, str(content.get("title") or name), base,
        lists(case, content.get("vary"), f"{where}, vary"),
        inStep(case, content, where),
        lists(case, content.get("oneAtATime"), f"{where}, oneAtATime"),
        listed(case, content, where), seeds(case, content, where), measures(case, content, where),
        reference, yes(content.get("keep", "no"), where))


def caseFolder(path, content):
    if "case" not in content:
        return studyCase.around(path)
    folder = path.parent/str(content["case"])
    if not folder.is_dir():
        raise BadInput(f"{path.name}, case: there is no folder {folder}; name it from where the "
                       "study file lies.")
    return folder.resolve()


def ranks(value, where):
    if not isinstance(value, int) or value < 1:
        raise BadInput(f"{where}: 'ranks' must be a whole number from 1, and is {shown(value)}.")
    return value


def checked(case, key, value, where):
    if key == "ranks":
        return ranks(value, where)
    if key == "seed":
        raise BadInput(f"{where}: 'seed' is varied by the packings of a study; write "
                       "'packings: [seed, seed, ...]'.")
    case.check(key, value, where)
    return value


def changes(case, content, where):
    """key: value, ..."""
    if content is None:
        return {}
    if not isinstance(content, dict):
        raise BadInput(f"{where}: 'parameter: value' is wanted, and it is {shown(content)}.")
    return {key: checked(case, key, value, where) for key, value in content.items()}


def lists(case, content, where, repeated=False):
    """key: [value, ...], ...; the same value twice only if `repeated`."""
    if content is None:
        return {}
    if not isinstance(content, dict):
        raise BadInput(f"{where}: 'parameter: [value, value]' is wanted, and it is "
                       f"{shown(content)}.")
    for key, values in content.items():
        if not isinstance(values, list):
            raise BadInput(f"{where}: '{key}' must have a list of values, as [1, 2], and has "
                           f"{shown(values)}.")
        if not values:
            raise BadInput(f"{where}: the list of '{key}' is empty; give it values or leave it out.")
        for value in values:
            checked(case, key, value, where)
        if not repeated:
            once(values, f"{where}: the list of '{key}'")
    return content


def inStep(case, content, where):
    together = lists(case, content.get("together"), f"{where}, together", repeated=True)
    lengths = {key: len(values) for key, values in together.items()}
    if len(set(lengths.values())) > 1:
        raise BadInput(f"{where}, together: the lists must be of one length, as their first values belong together, and "
                       "so on, and have " + ", ".join(f"{number} ({key})" for key, number in lengths.items())
                       + " values.")
    for key in together:
        if key in (content.get("vary") or {}):
            raise BadInput(f"{where}: '{key}' stands in 'vary' and in 'together'; keep one.")
    return together


def once(values, what):
    texts = [text(value) for value in values]
    for value in texts:
        if texts.count(value) > 1:
            raise BadInput(f"{what} has {value} twice; keep one.")


def listed(case, content, where):
    variants = content.get("variants")
    if "variants" not in content:
        return []
    if not isinstance(variants, list) or not variants:
        raise BadInput(f"{where}: 'variants' must be a list, as [{{shoeSpeed: 0.2}}], with one entry "
                       "at least; or leave it out.")
    return [changes(case, one, f"{where}, variants, entry {number}")
            for number, one in enumerate(variants, 1)]


def seeds(case, content, where):
    packings = content.get("packings", 1)
    own = case.parameters.get("seed")
    if own is None:
        if packings != 1:
            raise BadInput(f"{where}: the case {case.folder.name} has no parameter 'seed', so that "
                           "there is one packing only; leave 'packings' out.")
        return [None]
    if isinstance(packings, list):
        if not packings:
            raise BadInput(f"{where}: there are no packings, the list is empty; one seed is needed.")
        for seed in packings:
            if not isinstance(seed, int):
                raise BadInput(f"{where}, packings: a seed must be a whole number, and is "
                               f"{shown(seed)}.")
            case.check("seed", seed, f"{where}, packings")
        once(packings, f"{where}: the list of packings")
        return packings
    if not isinstance(packings, int) or packings < 1:
        raise BadInput(f"{where}: there must be one packing or more, and 'packings' is "
                       f"{shown(packings)}.")
    known = [own] + [seed for seed in SEEDS if seed != own]
    if packings > len(known):
        raise BadInput(f"{where}: {len(known)} packings at most have seeds known here, and "
                       f"'packings' is {packings}; list the seeds.")
    return known[:packings]


def measures(case, content, where):
    if "measures" not in content:
        return list(case.measures)
    chosen = content["measures"]
    if not isinstance(chosen, list) or not chosen:
        raise BadInput(f"{where}: 'measures' must be a list with one name at least; leave it out to "
                       "have all.")
    for name in chosen:
        if not isinstance(name, str) or name not in case.measures:
            raise BadInput(f"{where}, measures: the case {case.folder.name} has no measure "
                           f"'{name}'; " + nearest(name, case.measures))
    once(chosen, f"{where}: the list of measures")
    return chosen


def yes(value, where):
    words = {"yes": True, "true": True, "on": True, "no": False, "false": False, "off": False}
    if not isinstance(value, str) or value not in words:
        raise BadInput(f"{where}: 'keep' must be yes or no, and is {shown(value)}.")
    return words[value]
