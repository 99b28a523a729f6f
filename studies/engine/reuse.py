# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes from other studies of the same case what they found of the same run."""
import json
import os
from collections import Counter

import campaign
import plan as plans
from badInput import BadInput


def fromOthers(plan, folder):
    """Copies good results with all measures of the plan from the folders beside `folder`; counts them by the version
    that made them."""
    if plan["keep"]:
        raise BadInput("The study keeps the folders of its runs ('keep: yes'), and other studies have results only: leave "
                       "out --reuse or 'keep'.")
    wanted = {plans.code(run["id"]): run for run in plan["runs"] if campaign.resultOf(folder, run) is None}
    taken = Counter()
    for path in sorted(folder.parent.glob("*/runs/*/result.json")):
        run = wanted.get(plans.code(path.parent.name))
        result = run and goodResult(path, plan["case"])
        if result and set(plan["measures"]) <= set(result["measures"]):
            del wanted[plans.code(run["id"])]
            own = folder/"runs"/run["id"]
            own.mkdir(parents=True, exist_ok=True)
            campaign.write(own/"result.json", json.dumps({**result, "id": run["id"], "label": run["label"]}, indent=1))
            taken[result["versions"].get("tree") or "unknown"] += 1
    return taken


def goodResult(path, case):
    """None if the run failed, is torn, or is of another case."""
    try:
        result = json.loads(path.read_text())
        ofCase = json.loads((path.parents[2]/"plan.json").read_text())["case"]
        return result if result["status"] == "ok" and os.path.samefile(ofCase, case) else None
    except (OSError, ValueError, KeyError):
        return None
