#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when an include points the wrong way between the rooms, when a file has grown too long,
or when a page points at nothing.

usage: architectureTest.py <root of the repository>
"""
import re
import sys
from pathlib import Path

# What each room may include of this repository besides itself.
ARROWS = {
    "coupling/laws": [],
    "coupling/exchange": ["coupling/laws"],
    "coupling/dem": ["coupling/laws"],
    "coupling/mesh": ["coupling/laws", "coupling/exchange"],
    "coupling/effects": ["coupling/laws"],
    "coupling/forces": ["coupling/laws", "coupling/effects", "coupling/exchange", "coupling/dem", "coupling/mesh"],
    "coupling/report": ["coupling/laws"],
}
# Engines a room must not see: the headers' own style gives them away.
FOREIGN = {
    "coupling/laws": r'mpi\.h|lammps|.*\.H$',
    "coupling/exchange": r'lammps|.*\.H$',
    "coupling/dem": r'.*\.H$',
    "coupling/mesh": r'lammps|fix_.*\.h$',
    "coupling/effects": r'mpi\.h|lammps|.*\.H$',
    "coupling/forces": r'lammps|fix_.*\.h$',
    "coupling/report": r'lammps|.*\.H$',
}
LONGEST = 400
CODE = {".hpp", ".cpp", ".H", ".C"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def complaints(root):
    for top in ("coupling", "solvers", "tests"):
        for path in sorted((root / top).rglob("*")):
            if path.is_file() and path.suffix in CODE | {".py", ".sh", ".cmake", ".txt"}:
                name = path.relative_to(root).as_posix()
                lines = path.read_text().splitlines()
                if len(lines) > LONGEST:
                    yield f"{name}: {len(lines)} lines; at most {LONGEST} are wanted: split it"
                if path.suffix in CODE:
                    yield from wrongArrows(name, lines)


def deadLinks(root):
    """Of the pages in the repository; what a build made has none of ours."""
    for page in sorted(root.rglob("*.md")):
        name = page.relative_to(root)
        if name.parts[0] != "build" and "results" not in name.parts:
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
                if not (page.parent / target).exists():
                    yield f"{name.as_posix()}: there is no {target}"


def wrongArrows(name, lines):
    room = "/".join(name.split("/")[:2]) if re.match(r"coupling/\w+/", name) else None
    if room and room not in ARROWS:
        yield f"{name}: {room} is a new room: write into {Path(__file__).name} what it may include"
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = match.group(1)
        here = f"{name}:{number}: {line.strip()}"
        if target.startswith("../"):
            yield f"{here}: name it from the root of the repository"
        elif room and target.startswith(("coupling/", "solvers/", "tests/")):
            allowed = [room] + ARROWS[room]
            if not any(target.startswith(place + "/") for place in allowed):
                yield f"{here}: {room} may include only {', '.join(allowed)}"
        elif room and re.match(FOREIGN[room], target):
            yield f"{here}: {room} must not know that engine"
        elif name.startswith("solvers/") and re.match(r"coupling/\w+/", target):
            yield f"{here}: solvers see the front of the library (coupling/*.hpp) only"


root = Path(sys.argv[1])
found = [*complaints(root), *deadLinks(root)]
print("\n".join(found) or "Every include points the right way, no file is too long, and no link is dead.")
sys.exit(bool(found))
