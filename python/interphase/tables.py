# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as text: columns in line for a terminal, or Markdown for a page."""


def columns(rows, right=(), indent=0):
    """Lines of `rows` of texts, which may differ in length, each column as wide as its widest cell; those numbered in `right` flush right, all
    `indent` characters in."""
    width = [max(len(row[at]) for row in rows if at < len(row)) for at in range(max(map(len, rows), default=0))]
    return [" " * indent + "  ".join(cell.rjust(width[at]) if at in right else cell.ljust(width[at]) for at, cell in enumerate(row)).rstrip() for row in rows]


def markdown_row(cells):
    """A line of a table in Markdown; a bar in a cell parts none."""
    return "|" + "".join(f" {cell} |" if cell else " |" for cell in (str(each).replace("|", "\\|") for each in cells))


def markdown_head(names):
    """The two lines that a table in Markdown begins with."""
    return markdown_row(names) + "\n" + "|" + "---|" * len(names)
