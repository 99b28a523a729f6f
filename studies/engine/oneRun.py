# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of a study, called by the Snakefile: makes the variant, runs and measures it, and writes
its result.json: whole or not at all. A run that fails is a result too, with the reason; one that is
stopped from outside leaves none.
"""
import fcntl
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

STOPPED = 130, 143, -2, -15  # exit statuses of what was interrupted or told to end


class Stopped(Exception):
    """From outside."""


class Failed(Exception):
    """The reason of a row that failed."""


def locked(path):
    """Held by this process and what it starts for the run: a second study, or one that goes on after
    only a part of the first was killed, waits here until the folder is free."""
    path.parent.mkdir(parents=True, exist_ok=True)
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        fcntl.flock(handle, fcntl.LOCK_EX)
        try:
            if os.fstat(handle).st_ino == os.stat(path).st_ino:
                return handle
        except FileNotFoundError:
            pass
        os.close(handle)  # its last holder has removed it


def command(words, folder, output, lock, environment=None):
    with open(output, "ab") as screen:
        status = subprocess.run([str(word) for word in words], cwd=folder, env=environment,
                                stdin=subprocess.DEVNULL, stdout=screen, stderr=screen,
                                pass_fds=(lock,)).returncode
    if status in STOPPED:
        raise Stopped(f"{words[0]} was stopped")
    if status:
        raise Failed(Path(words[0]).name)


def oneLine(words, folder):
    return " ".join(words.replace(f"{folder}/", "").split())


def reason(folder, output, stage):
    """The last block that begins with ERROR in a log of the run, else the last line on screen."""
    logs = [*folder.glob("log.*"), *folder.glob("*/log.*"), output]
    logs = sorted((log for log in logs if log.is_file()), key=lambda log: -log.stat().st_mtime)
    for log in logs:
        tail = log.read_bytes()[-100000:].decode(errors="replace")
        blocks = re.findall(r"^(?:--> FOAM FATAL (?:IO )?)?ERROR:?\s.*?(?=\n\s*\n|\Z)", tail,
                            re.M | re.S)
        if blocks:
            return oneLine(blocks[-1], folder)
    lines = [line for line in output.read_text(errors="replace").splitlines() if line.strip()]
    return oneLine(f"{stage}: " + (lines[-1] if lines else "it failed without a word"), folder)


def measured(folder, output, lock):
    command([folder/"measure"], folder, folder/"log.measure", lock)
    try:
        numbers = json.loads((folder/"log.measure").read_text(), parse_constant=lambda _: None)
        return {str(key): None if value is None else float(value)
                for key, value in numbers.items()}
    except (ValueError, TypeError, AttributeError) as wrong:
        output.write_text(f"no JSON object of numbers: {wrong}\n")
        raise Failed("measure")


def timed(folder):
    """What the solver says of its time and its powder, if it does."""
    try:
        report = json.loads((folder/"postProcessing/time.json").read_text())
    except (OSError, ValueError):
        return {}
    return {"stages": {key: stage["mean"] for key, stage in report.get("stages", {}).items()},
            "wallSeconds": report.get("wallSeconds"), "particles": report.get("particles"),
            "time": report.get("time"), "endTime": report.get("endTime")}


def versions(folder):
    found = {}
    for log in sorted(folder.glob("log.*")):
        with open(log, errors="replace") as file:
            head = file.read(4000)
        for key, pattern in (("OpenFOAM", r"^Build\s*:\s*(.+)$"),
                             ("LIGGGHTS", r"Version LIGGGHTS-PUBLIC ([^,)]+)")):
            match = re.search(pattern, head, re.M)
            if match:
                found.setdefault(key, match.group(1).strip())
    return found


def attempt(plan, run, name, output, lock):
    """What goes into the result, and the variant's folder."""
    case = Path(plan["case"])
    folder = case/"variants"/name
    environment = {"OMPI_MCA_hwloc_base_binding_policy": "none",  # else all runs take the first core
                   **os.environ, "INTERSTICE_BED_STORE": plan["bedStore"]}
    output.write_bytes(b"")
    stage, result = "variant", {"status": "ok", "reason": "", "measures": {}}
    try:
        changes = [f"{key}={value}" for key, value in run["changes"].items()]
        command([case/"variant", name] + changes, case, output, lock)
        stage = "run"
        # Programs of Open MPI that begin and end at the same time stumble over a common folder in /tmp.
        with tempfile.TemporaryDirectory(prefix="interstice.") as own:
            command([folder/"run", "-np", run["ranks"]], folder, output, lock, {**environment, "TMPDIR": own})
        result.update(timed(folder))
        if (result.get("time") or 0) < 0.99*(result.get("endTime") or 0):
            output.write_text(f"it ended at {result['time']:g} s of {result['endTime']:g} s\n")
            raise Failed("run")
        stage = "measure"
        result["measures"] = measured(folder, output, lock)
    except (Failed, OSError) as failure:
        if isinstance(failure, OSError):
            output.write_text(f"{failure}\n")
        result.update(status="failed", reason=reason(folder, output, stage))
    result["versions"] = versions(folder)
    return result, folder


def clear(plan, result, folder, output, kept):
    """Of a run that failed the logs are kept; of another nothing, unless the study says so."""
    shutil.rmtree(kept, ignore_errors=True)
    if result["status"] == "failed":
        kept.mkdir()
        for log in [output, *folder.glob("log.*"), *folder.glob("*/log.*")]:
            if log.is_file():
                shutil.copy(log, kept/log.name)
    output.unlink()
    if result["status"] == "failed" or not plan["keep"]:
        shutil.rmtree(folder, ignore_errors=True)


def make(plan, run, home):
    """Writes home/result.json."""
    target = home/"result.json"
    name = f"{plan['study']}.{run['id']}"
    path = Path(plan["case"])/f"variants/{name}.lock"
    lock = locked(path)
    try:
        if not target.is_file():  # which another may have made while this one waited
            write(target, made(plan, run, name, home, lock))
        path.unlink()  # not if it was stopped: what it started may live on, and holds the lock
    finally:
        os.close(lock)


def made(plan, run, name, home, lock):
    start = time.monotonic()
    home.mkdir(parents=True, exist_ok=True)
    output = home/"log.screen"
    result, folder = attempt(plan, run, name, output, lock)
    clear(plan, result, folder, output, home/"logs")
    result["versions"]["tree"] = plan["tree"]
    result["seconds"] = round(time.monotonic() - start, 3)
    return {**{key: run[key] for key in ("id", "label", "seed", "ranks", "changes")}, **result}


def write(target, result):
    """Beside, then renamed: a kill leaves nothing, or all of it."""
    new = target.with_name(target.name + ".part")
    with open(new, "w") as file:
        file.write(json.dumps(result, indent=1) + "\n")
        file.flush()
        os.fsync(file.fileno())
    os.replace(new, target)
