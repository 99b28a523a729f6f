# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that function objects write, of all starts of a run: a resumed one begins a new file in the folder of its time."""


def files(case, pattern):
    """In the order of the starts: (start time, path). `pattern` is below postProcessing, as "fillingRatio/*/moments.dat"."""
    found = (case/"postProcessing").glob(pattern)
    return sorted((float(path.parent.name), path) for path in found)


def rows(path):
    """Lists of words; lines of comment and empty ones left out."""
    return [line.split() for line in path.read_text().splitlines() if line and line[0] != "#"]


def joined(case, pattern):
    """Rows of all starts, their first word a time: what a resumed run made again takes the place of what was there."""
    found = []
    for start, path in files(case, pattern):
        found = [row for row in found if float(row[0]) <= start] + rows(path)
    return found
