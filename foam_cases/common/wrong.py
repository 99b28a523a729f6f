# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong in a parameter or table, told once and clearly; then the end."""
import difflib
import sys


def refuse(rule, found, wanted, remedy):
    sys.exit(f"{rule}\n    found   {found}\n    wanted  {wanted}\n{remedy}")


def word(key, value, known, where="system/caseParameters"):
    """One of the known words."""
    if value in known:
        return value
    close = difflib.get_close_matches(str(value), known, 1, 0.5)
    refuse(f"{key} must be one of some words.", f"{key} {value}   {where}", ", ".join(known),
           f"Did you mean {close[0]}?" if close else "Choose one of them.")
