# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the base case with one mistake in it, and judges how the solver refuses it."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

BASE = pathlib.Path(__file__).resolve().parent/"base"
PATIENCE = 20  # seconds; whatever takes longer hangs


class Mistake:
    """One thing done wrong, and the words of the message that it must get.

    edits: (file, text, replacement) each; replacement None removes the file, text None
    makes a new one. command: replaces the
    solver's arguments. state: the run has to leave its last good state on disk.
    """

    def __init__(self, name, edits, words, ranks=(1, 2), arguments=None, state=False, ours=True):
        self.name = name
        self.edits = edits if isinstance(edits, list) else [edits]
        self.words = words
        self.ranks = ranks
        self.arguments = arguments
        self.state = state
        self.ours = ours  # else LIGGGHTS or OpenFOAM's start tells it, in its own form

    def make(self, prepared, folder):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(prepared, folder)
        for name, text, replacement in self.edits:
            # Fields lie in the folders of the ranks, too.
            roots = [folder, *folder.glob("processor*")]
            if text is None:
                for root in roots:
                    (root/name).write_text(replacement)
                continue
            paths = [root/name for root in roots if (root/name).is_file()]
            if not paths:
                sys.exit(f"{self.name}: the base case has no file {name}")
            for path in paths:
                if replacement is None:
                    path.unlink()
                    continue
                content = path.read_text()
                if text not in content:
                    sys.exit(f"{self.name}: no '{text}' in {path}")
                path.write_text(content.replace(text, replacement, 1))


def environment(folder):
    env = dict(os.environ, PWD=str(folder))
    env.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    env.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
               OMPI_MCA_mpi_yield_when_idle="1")
    return env


def execute(folder, command):
    """Exit code (None: it hung), what was printed, seconds."""
    start = time.monotonic()
    process = subprocess.Popen(command, cwd=folder, env=environment(folder), text=True, errors="replace",
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True)
    try:
        text, _ = process.communicate(timeout=PATIENCE)
        code = process.returncode
    except subprocess.TimeoutExpired:
        process.terminate()  # mpirun then ends its ranks
        text, _ = process.communicate()
        code = None
    return code, text, time.monotonic() - start


def prepare(folder, ranks):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(BASE, folder)
    for command in (["blockMesh"], ["decomposePar"])[:2 if ranks > 1 else 1]:
        code, text, _ = execute(folder, command)
        if code:
            sys.exit(f"{command[0]} failed:\n{text}")


def command(solver, ranks, arguments):
    parallel = ["-parallel"] if ranks > 1 else []
    launcher = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)]
    return (launcher if ranks > 1 else []) + [solver] + (
        parallel if arguments is None else arguments)


def lastState(folder):
    """Complaints about the state that a failed run left behind."""
    times = [p for p in folder.glob("processor0/*" if (folder/"processor0").is_dir() else "*")
             if re.fullmatch(r"[0-9.e-]+", p.name) and float(p.name) > 0]
    if len(times) != 1:
        return [f"{len(times)} states on disk, 1 is wanted"]
    complaints = []
    for name in ("U", "p", "voidFraction", "lagrangian/powder/U"):
        path = times[0]/name
        if not path.is_file():
            complaints.append(f"no {name} in {path.parent}")
        elif re.search(r"\b(nan|inf)\b", path.read_text()):
            complaints.append(f"{path} has values that are no number")
    return complaints


def complaintsAbout(mistake, code, text, folder):
    if code is None:
        return [f"it hung for {PATIENCE} s"]
    complaints = [] if code else ["its exit code is 0"]
    complaints += [f"the message lacks '{word}'" for word in mistake.words if word not in text]
    if mistake.ours:
        told = text.count("\nERROR: ")
        complaints += [f"told {told} times"] if told != 1 else []
    complaints += ["it has rubbish in it"] if "\ufffd" in text else []
    if re.search(r"Segmentation fault|Foam::error::printStack|should not have happened", text):
        complaints.append("it crashed")
    return complaints + (lastState(folder) if mistake.state else [])


def judge(mistake, prepared, work, chosen):
    """Name, what was printed, seconds, complaints. None: no mistake, which must run, or the mistakes
    prove nothing."""
    name = mistake.name if mistake else "(no mistake)"
    folder = work/re.sub(r"[^A-Za-z0-9]+", "_", name)
    (mistake or Mistake(name, [], [])).make(prepared, folder)
    code, text, seconds = execute(
        folder, command(chosen.solver, chosen.ranks, mistake and mistake.arguments))
    (folder/"log").write_text(text)
    complaints = complaintsAbout(mistake, code, text, folder) if mistake else \
        ["it does not run"] if code or "\nEnd" not in text else []
    return name, text, seconds, complaints


def main(mistakes):
    options = argparse.ArgumentParser()
    options.add_argument("--solver", required=True, help="path of demPimpleFoam")
    options.add_argument("--work", required=True, help="folder for the runs")
    options.add_argument("--ranks", type=int, default=1)
    options.add_argument("--only", help="of the mistakes whose name has this text")
    options.add_argument("--show", action="store_true", help="the messages, too")
    chosen = options.parse_args()
    work = pathlib.Path(chosen.work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    prepared = work/"prepared"
    prepare(prepared, chosen.ranks)

    wanted = [None] + [m for m in mistakes
                       if chosen.ranks in m.ranks and (chosen.only or "") in m.name]
    failed = 0
    # mpirun waits a second for the ranks of a failed run to end: another run uses it.
    with concurrent.futures.ThreadPoolExecutor(chosen.ranks) as pool:
        for name, text, seconds, complaints in pool.map(lambda m: judge(m, prepared, work, chosen), wanted):
            print(f"{name:58s} {chosen.ranks} ranks {seconds:5.1f} s  "
                  f"{'; '.join(complaints) or 'good'}", flush=True)
            if chosen.show or complaints:
                tail = text[text.find("\nERROR"):] if "\nERROR" in text else text[-1500:]
                print("    | " + tail.strip().replace("\n", "\n    | "))
            failed += bool(complaints)
    sys.exit(f"{failed} mistakes are not refused as they should" if failed else 0)
