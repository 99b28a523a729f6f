# SPDX-License-Identifier: GPL-3.0-or-later
"""A bed that takes long to settle, made once for all runs that start from it.

It stays in its folder as long as it is wanted with the same `key`, which stands in the file madeWith. If INTERSTICE_BED_STORE
names a folder, beds are kept there for other runs, also those at the same time.
"""
import contextlib
import fcntl
import hashlib
import os
import shutil
from pathlib import Path


def bed(folder, key, files, make):
    """make() writes `files` into the folder, or ends the program. Tells what was done."""
    folder.mkdir(exist_ok=True)
    stamp = folder/"madeWith"
    if stamp.is_file() and stamp.read_text() == key:
        print("bed: made before, with the same parameters")
        return
    stamp.unlink(missing_ok=True)
    with stored(key) as kept:
        if kept and kept.is_dir():
            copy(kept, folder, files)
            print("bed: made before by another run, with the same parameters")
            return
        make()
        stamp.write_text(key)
        if kept:
            part = Path(f"{kept}.part")
            copy(folder, part, files)
            part.rename(kept)  # so that what has this name is whole


@contextlib.contextmanager
def stored(key):
    """Where the store keeps what has this key, if there is a store; no other run makes it meanwhile."""
    store = os.environ.get("INTERSTICE_BED_STORE")
    if not store:
        yield None
        return
    kept = Path(store)/hashlib.sha256(key.encode()).hexdigest()
    kept.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{kept}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield kept


def copy(source, target, files):
    """The stamp last, as it says that the rest is there."""
    target.mkdir(exist_ok=True)
    for name in (*files, "madeWith"):
        shutil.copy(source/name, target)
