# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of a small CSV file."""


def read(path):
    """(number of the line, its cells), without empty lines and what is behind a #."""
    lines = enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1)
    lines = [(i, line.split("#")[0].strip()) for i, line in lines]
    return [(i, [cell.strip() for cell in line.split(",")]) for i, line in lines if line]
