# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of tools/report: a column per run, and whether the others agree with the first."""

import math
from dataclasses import dataclass

from interphase import tables, time_statistics as statistics
from interphase.run_report import COMPONENTS, Quantity

AGREE, DIFFER, UNJUDGED = "agree", "differ", "not judged"


@dataclass(frozen=True)
class Judgement:
    """`ratio`: difference over its error; `verdict` with the reason where it is `not judged`."""

    verdict: str
    ratio: float = math.nan
    reason: str = ""


def quantities(report, depth):
    """[(heading, [Quantity])] of a `RunReport`, windows at one depth."""
    found = [("", report.series)]
    if report.windows is not None:
        profile = report.profiles[depth]

        def over_windows(name, unit, means):
            # Headed by place, so that runs are compared window by window.
            return [Quantity(f"  x = {x:.4f} m", unit, mean) for x, mean in zip(report.windows, means)]

        for component in reversed(COMPONENTS):
            means = profile.velocity[component]
            found.append((f"{component} velocity [m/s]", over_windows(component, "", means)))
        found.append(("granular temperature [m2/s2]", over_windows("temperature", "", profile.temperature)))
        found.append(("spheres in a window", over_windows("number", "", profile.number)))
    found += [("", report.overlaps), ("", report.voidages)]
    return [(heading, some) for heading, some in found if some]


def judged(first, others, confidence):
    """`Judgement`s [quantity][other run] from lists of `Mean`s or None.

    `confidence` is for all quantities of a run together (Bonferroni, as in statistical_comparison.py).
    """
    columns = []
    for other in others:
        reasons = [_comparable(a, b) for a, b in zip(first, other)]
        differences = [None if why else statistics.difference(a, b) for a, b, why in zip(first, other, reasons)]
        count = sum(d is not None for d in differences)
        column = []
        for difference, reason in zip(differences, reasons):
            if difference is None:
                column.append(Judgement(UNJUDGED, reason=reason))
                continue
            differs = difference.chance < (1 - confidence) / count
            column.append(Judgement(DIFFER if differs else AGREE, difference.ratio))
        columns.append(column)
    return list(zip(*columns)) if columns else [() for _ in first]


def _comparable(a, b):
    """The reason why two means cannot be compared, "" if they can."""
    if a is None or b is None:
        return "nothing to compare"
    return "; ".join(mean.reason for mean in (a, b) if mean.reason)


def shown(mean, times=1.0):
    """A `Mean` with its error, to two digits of the error; a question mark where that is not to be trusted."""
    if mean is None:
        return "-"
    value, error = mean.value * times, mean.error * times
    if math.isnan(error):
        return f"{value:.4g} +- ?"
    if error == 0:
        return f"{value:.6g} +- 0" + (" ?" if mean.reason else "")
    digits = min(max(1 - math.floor(math.log10(error)), 0), 12)
    if abs(value) >= 1e-3 or value == 0:
        text = f"{value:.{digits}f} +- {error:.{digits}f}"
    else:
        power = math.floor(math.log10(abs(value)))
        digits = max(digits + power, 1)
        text = f"({value / 10**power:.{digits}f} +- {error / 10**power:.{digits}f})e{power}"
    return text + (" ?" if mean.reason else "")


def text(names, reports, depth, confidence):
    """Lines of the table. All reports measure the same scene."""
    sections = [quantities(report, depth) for report in reports]
    keys = list(dict.fromkeys((h, q.name) for section in sections for h, some in section for q in some))
    found = [{(h, q.name): q for h, some in section for q in some} for section in sections]
    any_of = {key: next(each[key] for each in found if key in each) for key in keys}
    means = [[each[key].mean if key in each else None for key in keys] for each in found]
    # The number of spheres tells real particles from parcels, not agreement.
    judgeable = [at for at, (heading, _) in enumerate(keys) if heading != "spheres in a window"]
    verdicts = dict(zip(judgeable, judged(*_picked(means, judgeable), confidence)))

    letters = [chr(ord("A") + at) if at < 26 else str(at + 1) for at in range(len(names))]
    titles = [f"{letter}: {name}" for letter, name in zip(letters, names)]
    rows = [["", *titles, *(f"{letter} - {letters[0]}" for letter in letters[1:])]]
    rows.append(["rows of /statistics" if all(report.of_rows for report in reports) else "snapshots", *(str(report.snapshots) for report in reports)])
    heading = ""
    for at, key in enumerate(keys):
        if key[0] != heading and key[0]:
            rows.append([key[0]])
        heading = key[0]
        quantity = any_of[key]
        name = f"{quantity.name} [{quantity.unit}]" if quantity.unit not in ("", "1") else quantity.name
        cells = [shown(column[at], quantity.shown_times) for column in means]
        rows.append([name, *cells, *map(_verdict, verdicts.get(at, ()))])
        if key[1] == "overlapping pairs per sphere":
            rows.append(["largest overlap [% d]", *(
                "-" if report.largest_overlap is None else f"{100 * report.largest_overlap:.3g}" for report in reports)])
    lacking = [line for letter, report in zip(letters, reports) if (line := _lacking(letter, report, depth))]
    return tables.columns(rows) + _legend(names, letters, means, verdicts, confidence) + lacking


def times_needed(report, depth):
    """[(time [s] or None, name)] of each quantity without an error that is to be trusted: how far the run, or each of its replicates, would have to go for
    one, about, as far as the record shows; None where it does not."""
    found = []
    for heading, some in quantities(report, depth):
        of_series = some is report.series
        count, first, last = report.rows if of_series else (report.snapshots, report.first, report.last)
        for quantity in some:
            if quantity.mean is None or not quantity.mean.reason:
                continue
            interval = (last - first) / (count / report.pieces - 1) if count > report.pieces else None
            name = " ".join(filter(None, (heading.split(" [")[0], quantity.name.strip())))
            found.append((None if interval is None else first + quantity.mean.longer * count / report.pieces * interval, name))
    return found


def _lacking(letter, report, depth):
    """What this run is too short for, and how long would do; None where all has an error."""
    every = sum(q.mean is not None for _, some in quantities(report, depth) for q in some)
    needed = times_needed(report, depth)
    known = sorted(pair for pair in needed if pair[0] is not None)
    if not needed:
        return None
    line = f"{letter}: {len(needed)} of {every} means have no error that is to be trusted"
    if not known:
        return f"{line}: one sample only; let the run record more (`snapshotInterval`), or go on"
    earliest = report.needed or 0.0
    half, (last, name) = max(known[(len(known) - 1) // 2][0], earliest), known[-1]
    return (f"{line}; as far as the record shows, half of them have one when {'each run' if report.pieces > 1 else 'the run'} goes to t = {half:.3g} s, all at "
            f"{max(last, earliest):.3g} s (last: {name})")


def _picked(means, places):
    columns = [[column[at] for at in places] for column in means]
    return columns[0], columns[1:]


def _verdict(judgement):
    return judgement.verdict if judgement.verdict == UNJUDGED else f"{judgement.ratio:+.1f} {judgement.verdict}"


def _legend(names, letters, means, verdicts, confidence):
    lines = ["", "value +- standard error of the mean, autocorrelation taken in"]
    unsure = [mean for column in means for mean in column if mean is not None and mean.reason]
    if unsure:
        lines.append(f"?: no error, or one not to be trusted, such as: {unsure[0].reason}")
    for at, letter in enumerate(letters[1:]):
        column = [each[at] for each in verdicts.values()]
        counts = {v: sum(j.verdict == v for j in column) for v in (AGREE, DIFFER, UNJUDGED)}
        lines.append(
            f"{letter} against {letters[0]}: {counts[AGREE]} agree, {counts[DIFFER]} differ, {counts[UNJUDGED]} "
            f"not judged (difference over its standard error; {100 * confidence:g} % confidence for all together)"
        )
    return lines
