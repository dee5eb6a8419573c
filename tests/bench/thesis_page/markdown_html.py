"""The little Markdown that the measuring programs write, as HTML: headings, tables, lists and paragraphs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import html
import re


def inline(text):
    """Emphasis and code."""
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    return re.sub(r"(?<!\*)\*([^*]+)\*(?!\*)", r"<i>\1</i>", text)


def cells(line):
    """What stands between the bars of a table's row."""
    return [inline(cell.strip()) for cell in line.strip().strip("|").split("|")]


def table(lines):
    """A table with its head; columns with `--:` are aligned right."""
    right = [cell.strip().endswith(":") for cell in lines[1].strip().strip("|").split("|")]
    out = ["<table><thead><tr>" + "".join(f"<th>{cell}</th>" for cell in cells(lines[0])) + "</tr></thead><tbody>"]
    for line in lines[2:]:
        row = cells(line)
        out.append(
            "<tr>"
            + "".join(f'<td{" class=r" if k < len(right) and right[k] else ""}>{cell}</td>' for k, cell in enumerate(row))
            + "</tr>"
        )
    return "".join(out) + "</tbody></table>"


def to_html(markdown):
    """All of it; headings begin at h3 whatever their level is."""
    out = []
    for block in re.split(r"\n\s*\n", markdown.strip()):
        lines = block.splitlines()
        if lines[0].startswith("#"):
            level = min(5, lines[0].count("#", 0, 6))
            out.append(f"<h{level}>{inline(lines[0].lstrip('# '))}</h{level}>")
            lines = lines[1:]
        if not lines:
            continue
        if lines[0].startswith("|") and len(lines) > 1:
            rows = [line for line in lines if line.startswith("|")]
            out.append(table(rows))
            lines = [line for line in lines if not line.startswith("|")]
        if lines and lines[0].startswith("- "):
            out.append("<ul>" + "".join(f"<li>{inline(line[2:])}</li>" for line in lines) + "</ul>")
        elif lines:
            out.append("<p>" + inline(" ".join(lines)) + "</p>")
    return "\n".join(out)
