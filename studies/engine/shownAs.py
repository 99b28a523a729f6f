# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as files and people read them; a measure may say that it is shown in % or mm3/s."""

SHOWN = {"%": 100, "mm3/s": 1e9}
LARGE = 1e6  # from there on with a power of ten
PREFIXES = ((1, "m"), (1e-3, "mm"), (1e-6, "um"), (1e-9, "nm"))


def text(value):
    """As it stands in system/caseParameters, in names and in tables."""
    return value if isinstance(value, str) else f"{value:.12g}"


def isNumber(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def scale(about):
    return SHOWN.get(about.get("shown"), 1)


def unit(about):
    found = about.get("shown") or about.get("unit", "")
    return "" if found in ("1", "-") else found


def withUnit(value, about):
    if value is None:
        return "unknown"
    return f"{scale(about)*value:.3g} {unit(about)}".strip()


def name(key, about):
    """For axes and columns: key, symbol if there is one, unit."""
    words = f"{key} {about['symbol']}" if about.get("symbol") else key
    return f"{words} [{unit(about)}]" if unit(about) else words


def labelled(about, key, value):
    """For people: d_p=40um."""
    name, unit = about.get("symbol") or key, about.get("unit", "")
    if unit == "m" and isNumber(value) and value:
        scale, unit = next((pair for pair in PREFIXES if abs(value) >= 0.9999*pair[0]), PREFIXES[-1])
        return f"{name}={value/scale:.6g}{unit}"
    if isNumber(value) and abs(value) >= LARGE:
        return f"{name}={value:.6g}".replace("e+0", "e")
    return f"{name}={text(value)}"
