# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a report's page on runs of one method that differ by the size of their parcels or of a step."""

from interphase import convergence, page_figures, trade
from interphase.page_html import listed, paragraph, table, text
from interphase.report_table import shown

# Of profiles the mean of the windows is drawn, where it means something.
DRAWN = ("granular temperature",)


def section(sheets, depth, to_run, distance_words):
    """HTML, "" where no runs make a family; the first of `sheets` is the reference. `to_run(name)`: the HTML of a link to a run."""
    parts = [_family(family, sheets[0], depth, to_run, distance_words) for family in convergence.families(sheets[1:])]
    return "".join(parts)


def _family(family, reference, depth, to_run, distance_words):
    found = convergence.limits(family, depth)
    far = convergence.distances(reference.report, found, depth)
    overall = trade.overall(far)
    of_limit = {each.quantity: each for each in far}
    of_runs = [{each.quantity: each for each in trade.distances(reference.report, sheet.report, depth)} for sheet in family.sheets]
    theirs = trade.quantities(reference.report, depth)
    ours = [trade.quantities(sheet.report, depth) for sheet in family.sheets]
    names = [name for name in theirs if any(name in each for each in of_runs)]

    values, figures = [], []
    for name in names:
        unit, means = theirs[name]
        if len(means) > 1 and name not in DRAWN:
            continue
        of_reference = trade.as_mean(means)
        of_each = [trade.as_mean(each[name][1]) if name in each else None for each in ours]
        at_limit = trade.as_mean(found[name].means) if name in found else None
        label = name + (", mean of the windows" if len(means) > 1 else "") + (f" [{unit}]" if unit not in ("", "1") else "")
        values.append([text(label), *(text(shown(mean)) for mean in of_each), text(shown(at_limit)), text(shown(of_reference))])
        figures.append(page_figures.convergence(family, of_each, at_limit, of_reference, label))

    distances = []
    for name in names:
        how = found.get(name)
        fit = "-" if how is None else {1: "line", 2: "parabola"}.get(how.degree, how.reason)
        distances.append([text(name), *(text(distance_words(each.get(name))) for each in of_runs), text(distance_words(of_limit.get(name))), text(fit)])
    distances.append(["<strong>overall</strong>", *(text(distance_words(trade.overall(list(each.values())))) for each in of_runs),
                      text(distance_words(overall)), ""])  # fmt: skip
    heads = [f"{to_run(sheet.name)}, {x:.3g}" for sheet, x in zip(family.sheets, family.values)]
    return (f"<h3>{text(family.title)}</h3>" + listed([text(_in_words(family, reference.name, far))]) + f'<div class="figures">{"".join(figures)}</div>'
            + table(["", *heads, "extrapolated", to_run(reference.name)], values)
            + table([f"distance to {to_run(reference.name)}", *heads, "extrapolated", "by"], distances)
            + paragraph(text(_how(family))))  # fmt: skip


def _how(family):
    used = sum(family.fitted)
    left = "" if used == len(family.sheets) else " The run at the limit is not among those that are fitted."
    return (f"In the figures: blue, the runs (a square is not fitted); red and hollow, extrapolated; grey, the reference; one standard error each. Extrapolated: the means of {used} runs over {family.by}, to {family.limit:g}, weighted by their errors, by a line, or by a parabola where the line is rejected at "
            f"{100 * convergence.LEVEL:g} %. That means go by a line is an assumption.{left}")  # fmt: skip


def _in_words(family, reference, far):
    if not far:
        return "Nothing can be extrapolated."
    return f"{family.method} at the limit: {trade.words_on(far, reference)}."
