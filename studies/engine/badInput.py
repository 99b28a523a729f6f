# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user can get wrong, told in one sentence."""
import difflib


class BadInput(Exception):
    """One sentence for the user."""


def nearest(name, known):
    """The end of a sentence about a name that is not known."""
    close = difflib.get_close_matches(str(name), known, 1, 0.6)
    if close:
        return f"did you mean '{close[0]}'?"
    return "there are " + ", ".join(sorted(known)) + "."
