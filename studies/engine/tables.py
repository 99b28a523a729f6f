# SPDX-License-Identifier: GPL-3.0-or-later
"""What the runs found: runs.csv, a row a run; table.csv and table.md, a row a variant;
columns.json, what the columns mean. What differs each time, the seconds, comes last."""
import csv
import io
import json
import math

import shownAs
from campaign import resultOf, write
from shownAs import text

NOTHING = {"status": "not run", "reason": "", "measures": {}, "seconds": None}


def make(plan, folder):
    """Writes the tables; how many runs are ok, failed, not run."""
    results = [resultOf(folder, run) or NOTHING for run in plan["runs"]]
    variants = summarised(plan, results)
    write(folder/"columns.json", json.dumps(plan["about"], indent=1) + "\n")
    write(folder/"runs.csv", sheet(runRows(plan, results)))
    write(folder/"table.csv", sheet([flat(plan, variant) for variant in variants]))
    write(folder/"table.md", markdown(plan, variants))
    states = [result["status"] for result in results]
    return tuple(states.count(state) for state in ("ok", "failed", "not run"))


def sheet(rows):
    out = io.StringIO()
    writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: cell(value) for key, value in row.items()} for row in rows)
    return out.getvalue()


def cell(value):
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.10g}"


def stagesOf(results):
    return list(dict.fromkeys(stage for result in results for stage in result.get("stages", {})))


def secondsOf(result, stages):
    """Of the run, of the solver in it, and of the solver's stages: what was poured before is in the first alone."""
    return {"seconds": result["seconds"], "seconds.solver": result.get("wallSeconds"),
            **{f"seconds.{stage}": result.get("stages", {}).get(stage) for stage in stages}}


def runRows(plan, results):
    stages, rows = stagesOf(results), []
    for run, result in zip(plan["runs"], results):
        variant = plan["variants"][run["variant"]]
        versions = result.get("versions", {})
        row = {"id": run["id"], "variant": variant["label"], **variant["parameters"]}
        if run["seed"] is not None:
            row["seed"] = run["seed"]
        row.update(packing=run["packing"], status=result["status"], reason=result["reason"])
        row.update({key: result["measures"].get(key) for key in plan["measures"]})
        row["particles"] = result.get("particles")
        row.update({f"version.{key}": versions.get(key, "")
                    for key in ("tree", "OpenFOAM", "LIGGGHTS")})
        row.update(secondsOf(result, stages))
        rows.append(row)
    return rows


def meanAndError(values):
    """Of the mean: std/sqrt(n), with n - 1 in the standard deviation."""
    values = [value for value in values if value is not None]
    n = len(values)
    if not n:
        return None, None
    mean = math.fsum(values)/n
    if n < 2:
        return mean, None
    return mean, math.sqrt(math.fsum((value - mean)**2 for value in values)/(n - 1)/n)


def summarised(plan, results):
    """One dictionary a variant: its parameters, state, means, errors and differences."""
    variants, stages = [], stagesOf(results)
    for number, variant in enumerate(plan["variants"]):
        own = [result for run, result in zip(plan["runs"], results) if run["variant"] == number]
        good = [result for result in own if result["status"] == "ok"]
        variants.append({
            **variant, "status": state(own, good), "packings": len(good),
            "means": {key: meanAndError([result["measures"].get(key) for result in good])
                      for key in plan["measures"]},
            "seconds": meanSeconds([secondsOf(result, stages) for result in good], secondsOf(NOTHING, stages))})
    for number, variant in enumerate(variants):
        reference = variant["reference"]
        if reference is not None:
            variant["differences"] = {
                key: (None, "", None) if reference == number else
                (*difference(variant["means"][key], variants[reference]["means"][key]),
                 pairedError(plan, results, key, number, reference))
                for key in plan["measures"]}
    return variants


def meanSeconds(results, keys):
    """With errors of the whole ones: what else the machine does is in them."""
    means = {key: meanAndError([result[key] for result in results]) for key in keys}
    return {**{key: mean for key, (mean, _) in means.items()},
            **{f"{key}.error": means[key][1] for key in ("seconds", "seconds.solver")}}


def pairedError(plan, results, key, number, reference):
    """Standard error of the mean difference between runs of the same packing, or None: less than the combined errors if
    two runs that start from one bed stay alike."""
    own, other = ({run["packing"]: result["measures"].get(key) for run, result in zip(plan["runs"], results)
                   if run["variant"] == one and result["status"] == "ok"} for one in (number, reference))
    return meanAndError([own[packing] - other[packing] for packing in own
                         if None not in (own[packing], other.get(packing))])[1]


def state(own, good):
    if len(good) == len(own):
        return "ok"
    if good:
        return "partly"
    return "failed" if any(result["status"] == "failed" for result in own) else "not run"


def difference(one, other):
    """To the reference, and whether it is more than twice the combined errors."""
    if one[0] is None or other[0] is None:
        return None, ""
    found = one[0] - other[0]
    if one[1] is None or other[1] is None:
        return found, ""
    return found, "yes" if abs(found) > 2*math.hypot(one[1], other[1]) else "no"


def flat(plan, variant):
    row = {"variant": variant["label"],
           **{key: value for key, value in variant["parameters"].items() if key != "seed"},
           "status": variant["status"], "packings": variant["packings"]}
    for key in plan["measures"]:
        row[key], row[f"{key}.error"] = variant["means"][key]
        if "differences" in variant:
            row[f"{key}.difference"], row[f"{key}.resolved"], row[f"{key}.pairedError"] = variant["differences"][key]
    row.update(variant["seconds"])
    return row


def markdown(plan, variants):
    """What varies and what was found; what all have in common below."""
    about, varied = plan["about"], plan["varied"]
    head = ([shownAs.name(key, about[key]) for key in varied] + ["status", "packings"]
            + [shownAs.name(key, about[key]) for key in plan["measures"]] + ["seconds"])
    rows = [head, ["---"]*len(head)]
    for variant in variants:
        seconds = variant["seconds"]["seconds"]
        rows.append([text(variant["parameters"][key]) for key in varied]
                    + [variant["status"], str(variant["packings"])]
                    + [withError(variant, key, about[key]) for key in plan["measures"]]
                    + ["" if seconds is None else f"{seconds:.3g}"])
    common = ", ".join(f"{key} {text(value)}" for key, value in variants[0]["parameters"].items()
                       if key not in varied and key != "seed")
    note = ("Mean ± standard error over the packings; bold: differs from the reference by more than "
            "twice the combined errors.")
    return (f"# {plan['title']}\n\n" + "\n".join("| " + " | ".join(row) + " |" for row in rows)
            + f"\n\n{note}\n\nThe same in all: {common}.\n")


def withError(variant, key, about):
    mean, error = variant["means"][key]
    if mean is None:
        return ""
    scale = shownAs.scale(about)
    words = f"{scale*mean:.4g}" + ("" if error is None else f" ± {scale*error:.2g}")
    resolved = variant.get("differences", {}).get(key, (None, "", None))[1] == "yes"
    return f"**{words}**" if resolved else words
