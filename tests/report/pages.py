# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes blocks of contents.py as Markdown or as one HTML file that needs no other."""
import base64
import html
import re

from contents import Figure, Heading, Quote, Table, Text

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #22303c; max-width: 76rem; margin: 2rem auto;
       padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; margin: 2em 0 .6em; } h1 { margin-top: 0; }
h2 { border-bottom: 1px solid #c8d0d8; }
table { border-collapse: collapse; font-size: 13px; margin: .6em 0; }
th, td { padding: .15em .7em; text-align: right; border-bottom: 1px solid #e3e8ec;
         font-variant-numeric: tabular-nums; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
.numbers th:nth-child(2), .numbers td:nth-child(2) { text-align: left; white-space: normal; }
tr.missed td { background: #b2182b; color: white; } tr.shown td { color: #6b7884; }
p.bad { color: #b2182b; } pre { color: #4a5864; border-left: 3px solid #c8d0d8; padding-left: 1em;
font-size: 13px; } summary { cursor: pointer; color: #4a5864; } img { max-width: 100%; }
figure { margin: 1em 0; } figcaption { color: #4a5864; max-width: 60rem; }
@media print { body { font-size: 10px; margin: 0; } table { font-size: 8px; } tr { break-inside:
avoid; } tr.missed td { color: #b2182b; background: none; font-weight: bold; } }
"""


def markdown(blocks):
    return "\n\n".join(MARKDOWN[type(block)](block) for block in blocks) + "\n"


def markdownTable(table):
    mark = lambda kind, cells: [f"**{cells[0]}**" if kind == "missed" and "*" not in cells[0]
                                else cells[0], *cells[1:]]
    words = ("case", "quantity", "test", "")
    lines = [table.header, ["---" if name in words else "---:" for name in table.header]]
    lines += [mark(*row) for row in table.rows]
    text = "\n".join("| " + " | ".join(map(cell, cells)) + " |" for cells in lines)
    if table.folded:
        return f"<details><summary>{table.folded}</summary>\n\n{text}\n\n</details>"
    return text


def plain(text):
    """Markdown would take it for a tag of HTML."""
    return text.replace("<", "&lt;")


def cell(text):
    return plain(text).replace("|", "\\|")


MARKDOWN = {
    Heading: lambda block: "#"*block.level + " " + block.text,
    Text: lambda block: plain(block.text),
    Quote: lambda block: "```text\n" + block.text + "\n```",
    Table: markdownTable,
    Figure: lambda block: f"![]({block.name})\n\n{plain(block.caption)}",
}


def page(blocks):
    body = "\n".join(HTML[type(block)](block) for block in blocks)
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width">'
            f"<title>Verification of Interstice</title><style>{STYLE}</style></head>\n"
            f"<body>\n{body}\n</body></html>\n")


def htmlTable(table):
    line = lambda cells, tag: "".join(f"<{tag}>{rich(cell)}</{tag}>" for cell in cells)
    rows = "\n".join(f'<tr class="{kind}">{line(cells, "td")}</tr>' for kind, cells in table.rows)
    kind = "numbers" if "quantity" in table.header else "summary"
    text = f'<table class="{kind}">\n<tr>{line(table.header, "th")}</tr>\n{rows}\n</table>'
    if table.folded:
        return f"<details><summary>{rich(table.folded)}</summary>{text}</details>"
    return text


def rich(text):
    return re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", html.escape(text))


def image(figure):
    data = base64.b64encode(figure.png).decode()
    return (f'<figure><img alt="{html.escape(figure.caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{rich(figure.caption)}</figcaption></figure>")


HTML = {
    Heading: lambda block: f"<h{block.level}>{rich(block.text)}</h{block.level}>",
    Text: lambda block: f'<p class="{"bad" if block.bad else "good"}">{rich(block.text)}</p>',
    Quote: lambda block: f"<pre>{html.escape(block.text)}</pre>",
    Table: htmlTable,
    Figure: image,
}
