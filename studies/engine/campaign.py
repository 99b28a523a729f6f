# SPDX-License-Identifier: GPL-3.0-or-later
"""Has Snakemake run what has no result yet, and tells on screen how far it is."""
import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import shownAs
from badInput import BadInput

HERE = Path(__file__).resolve().parent
EVERY = 0.5  # seconds between two looks for new results


def resultOf(folder, run):
    """What a run left, or None."""
    try:
        return json.loads((folder/"runs"/run["id"]/"result.json").read_text())
    except (OSError, ValueError):
        return None


def write(path, content):
    """Beside, then renamed: a kill leaves the old file or the new one."""
    new = path.with_name(path.name + ".part")
    new.write_text(content)
    os.replace(new, path)


def hold(folder):
    """The lock of a results folder; it goes with this process and Snakemake, however they end."""
    folder.mkdir(parents=True, exist_ok=True)
    handle = open(folder/"lock", "w")
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise BadInput(f"Another study process is at work in {folder}: wait for it, or name another "
                       "folder by --results.")
    return handle


def version(folder):
    """Of the tree, if it is under git."""
    try:
        told = subprocess.run(["git", "describe", "--always", "--tags", "--dirty"], cwd=folder,
                              capture_output=True, text=True)
    except OSError:
        return ""
    return told.stdout.strip() if told.returncode == 0 else ""


def duration(seconds):
    minutes = round(seconds/60)
    if seconds < 60:
        return f"{seconds:.0f} s"
    return f"{minutes} min" if minutes < 60 else f"{minutes//60} h {minutes % 60} min"


class Progress:
    """One line for each run that has ended."""

    def __init__(self, plan, folder, cores):
        self.plan, self.folder, self.cores = plan, folder, cores
        self.waiting, self.failed = [], 0
        for run in plan["runs"]:
            result = resultOf(folder, run)
            if result is None:
                self.waiting.append(run)
            self.failed += result is not None and result["status"] == "failed"
        self.start, self.ended = time.monotonic(), 0

    def look(self):
        for run in list(self.waiting):
            if not (self.folder/"runs"/run["id"]/"result.json").exists():
                continue
            result = resultOf(self.folder, run)
            if result:
                self.waiting.remove(run)
                self.tell(run, result)

    def tell(self, run, result):
        self.ended += 1
        self.failed += result["status"] == "failed"
        whole = len(self.plan["runs"])
        # Those that run now are half done, on the whole.
        half = 0.5*min(self.cores - 1, len(self.waiting))
        left = (time.monotonic() - self.start)/(self.ended + half)*(len(self.waiting) - half)
        head = f"{whole - len(self.waiting)} of {whole} done, {self.failed} failed"
        if self.waiting:
            head += f", about {duration(left)} left"
        print(f"{head} | {run['label']}: {self.outcome(result)} in {result['seconds']:.3g} s",
              flush=True)

    def outcome(self, result):
        if result["status"] == "failed":
            return "FAILED, " + result["reason"][:150]
        name = self.plan["measures"][0]
        about = self.plan["about"][name]
        return f"{about.get('brief', name)} {shownAs.withUnit(result['measures'].get(name), about)}"


def retry(plan, folder):
    for run in plan["runs"]:
        result = resultOf(folder, run)
        if result and result["status"] == "failed":
            (folder/"runs"/run["id"]/"result.json").unlink()


def profilePath(name):
    own = HERE.parent/"profiles"/name
    path = Path(name) if Path(name).is_dir() else own
    if not (path/"config.yaml").is_file():
        raise BadInput(f"The profile {name} has no config.yaml: name its folder, or one of "
                       + ", ".join(sorted(p.name for p in own.parent.iterdir())) + ".")
    return path.resolve()


def snakemake(folder, cores, profile):
    program = shutil.which("snakemake")
    if not program:
        raise BadInput("Snakemake, which starts the runs, is not on the PATH: install Debian's "
                       "snakemake.")
    words = [program, "--snakefile", HERE/"Snakefile", "--directory", folder, "--nolock",
             "--rerun-incomplete", "--rerun-triggers", "mtime", "--scheduler", "greedy",
             "--keep-going", "--drop-metadata", "--nocolor",
             "--force-use-threads"]  # see the Snakefile
    words += ["--profile", profilePath(profile)] if profile else ["--cores", cores]
    return [str(word) for word in words]


def passOn(number, frame):
    """SIGTERM, told to this process, is for the runs as well if the group is its own."""
    if os.getpgrp() == os.getpid():
        signal.signal(number, signal.SIG_IGN)
        os.killpg(0, number)
    raise KeyboardInterrupt


def work(plan, folder, cores, profile, again, lock):
    """Runs what has no result; True if Snakemake came to its end."""
    (folder/"runs").mkdir(exist_ok=True)
    if again:
        retry(plan, folder)
    progress = Progress(plan, folder, cores)
    write(folder/"plan.json", json.dumps({**plan, "tree": version(Path(plan["case"]))}, indent=1))
    if not progress.waiting:
        print(f"All {len(plan['runs'])} runs were done before"
              + (f", {progress.failed} failed; --retry runs those again." if progress.failed
                 else "."))
        return True
    words = snakemake(folder, cores, profile)
    signal.signal(signal.SIGTERM, passOn)
    log = folder/"snakemake.log"
    with open(log, "w") as screen:
        started = subprocess.Popen(words, stdout=screen, stderr=screen, pass_fds=(lock.fileno(),))
        try:
            while started.poll() is None:
                time.sleep(EVERY)
                progress.look()
        except KeyboardInterrupt:
            print("Stopping ...", file=sys.stderr)
            started.terminate()  # it waits for runs that were not told to stop
            started.wait()
            raise
    progress.look()
    if started.returncode:
        print(f"Snakemake ended with status {started.returncode}, see {log}", file=sys.stderr)
    return started.returncode == 0
