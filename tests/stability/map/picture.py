# SPDX-License-Identifier: GPL-3.0-or-later
"""The map as a picture, a panel for each slice, and as a table in Markdown."""
import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import Patch, Rectangle  # noqa: E402

COLOURS = {"stable": "#8cc5a2", "refused": "#f2d06b", "blew up": "#c8453b"}
INK = {"stable": "#123", "refused": "#123", "blew up": "white"}
WORDS = {"stable": "stable", "refused": "refused", "blew up": "blew\nup"}
COLUMNS = 3
NOTE = ("stable: ended by itself, nothing lost, no speed beyond 3 times what physics allows, "
        "no growing swing.   "
        "Small square: what lies beyond a refusal.   "
        "Per cent: end speed, off the formula.")


def draw(parts, results, path):
    rows = math.ceil(len(parts)/COLUMNS)
    columns = min(COLUMNS, len(parts))
    figure, axes = plt.subplots(rows, columns, figsize=(6.6*columns, 5.2*rows + 0.8), squeeze=False)
    for place in axes.flat[len(parts):]:
        place.axis("off")
    for place, part in zip(axes.flat, parts):
        panel(place, part, [found for found in results if found["slice"] == part.name])
    figure.legend(handles=[Patch(color=colour, label=word) for word, colour in COLOURS.items()],
                  loc="upper center", ncol=3, fontsize=13, frameon=False)
    figure.text(0.5, 0.005, NOTE, ha="center", fontsize=11)
    figure.tight_layout(rect=(0, 0.02, 1, 1 - 0.35/figure.get_figheight()))
    figure.savefig(path, dpi=110)
    plt.close(figure)


def panel(axes, part, results):
    for found in results:
        x, y = part.x.values.index(found["x"]), part.y.values.index(found["y"])
        word = found["word"]
        axes.add_patch(Rectangle((x, y), 1, 1, facecolor=COLOURS[word], edgecolor="white", lw=2))
        axes.text(x + 0.5, y + 0.56, WORDS[word], ha="center", va="center", fontsize=8.5,
                  color=INK[word], linespacing=0.95)
        if "beyond" in found:
            axes.add_patch(Rectangle((x + 0.38, y + 0.1), 0.24, 0.24, edgecolor="white", lw=1,
                                     facecolor=COLOURS[found["beyond"]["word"]]))
        elif "end" in found:
            off = round(100*found["end"] - 100, 1) + 0.0
            axes.text(x + 0.5, y + 0.22, f"{off:+.1f} %", ha="center", va="center", fontsize=6.5)
    axes.set(xlim=(0, len(part.x.values)), ylim=(0, len(part.y.values)), xlabel=part.x.label,
             ylabel=part.y.label)
    axes.set_title(part.title, fontsize=11)
    axes.set_xticks([i + 0.5 for i in range(len(part.x.values))], part.x.values)
    axes.set_yticks([i + 0.5 for i in range(len(part.y.values))], part.y.values)
    axes.tick_params(length=0)
    for side in axes.spines.values():
        side.set_visible(False)


def table(parts, results):
    text = "# Stability map\n"
    for part in parts:
        mine = {(found["x"], found["y"]): found for found in results if found["slice"] == part.name}
        text += f"\n## {part.name}: {part.title}\n\nAcross: {part.x.label}. Down: {part.y.label}.\n\n"
        text += "| | " + " | ".join(map(str, part.x.values)) + " |\n"
        text += "| --- " + "| --- "*len(part.x.values) + "|\n"
        for y in reversed(part.y.values):
            text += f"| {y} | " + " | ".join(entry(mine[x, y]) for x in part.x.values) + " |\n"
        reasons = {}
        for found in mine.values():
            if found["reason"]:
                reasons.setdefault((found["word"], found["reason"]), []).append(found)
        if reasons:
            text += "\n"
        for (word, reason), points in reasons.items():
            places = ", ".join(f"({found['x']}, {found['y']})" for found in points)
            text += f"- {word}: {reason} {places}\n"
    return text


def entry(found):
    if "beyond" in found:
        return f"{found['word']} (beyond: {found['beyond']['word']})"
    return found["word"]
