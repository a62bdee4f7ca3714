# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a report's page on runs that differ in nothing but where they begin."""

from interphase import replicates
from interphase.page_html import paragraph, table, text


def section(sheets, depth, to_run):
    """HTML, "" where there are no replicates. `to_run(name)`: the HTML of a link to a run."""
    return "".join(_group(some, depth, to_run) for some in replicates.groups(sheets))


def _group(sheets, depth, to_run):
    found = replicates.scatters(sheets, depth)
    names = ", ".join(to_run(sheet.name) for sheet in sheets)
    if not found:
        return paragraph(f"{names}: none of their quantities has an error to be trusted in all of them.")
    rows = [[text(f"{each.quantity} [{each.unit}]" if each.unit not in ("", "1") else each.quantity), text(f"{each.mean:.4g} +- {each.error:.2g}"),
             text(f"{each.ratio:.2f}"), text(f"{each.low:.2f} to {each.high:.2f}"), "" if each.holds else "outside"] for each in found]  # fmt: skip
    outside = sum(not each.holds for each in found)
    expected = (1 - replicates.CONFIDENCE) * len(found)
    return (paragraph(f"{len(sheets)} runs that differ in where they begin only: {names}. Of {len(found)} means {outside} scatter by more or less than the errors of single runs allow "
                      f"at 95 %; {expected:.1f} would by chance.")
            + table(["", "mean of the runs, error by their scatter", "scatter over claimed error", "in 95 % of cases", ""], rows))  # fmt: skip
