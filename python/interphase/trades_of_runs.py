# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of evidence for tools/plan, made of runs that were measured: how far each lies off its reference, in which scene."""

import csv
import dataclasses
import io
import math

from interphase import evidence, plan_scene, trade, whole_file
from interphase.evidence import Trade
from interphase.input_error import InputError
from interphase.run import Run
from interphase.run_report import FREQUENCY

PERCENTILE = "overlap, percentile 97"
STEPS = "steps_per_collision"


def likeness(folder, account):
    """{name: number or None} of the run in `folder`, of which `account` tells the weight: what evidence.NEAR compares, and STEPS of the solids in a collision (None where
    collisions have no duration). All None where the folder does not tell what the scene is."""
    run = Run(folder)
    duration = float(run.meta.get("contact_duration", math.nan))
    steps = float(f"{duration / account.solid_step:.3g}") if duration > 0 and math.isfinite(duration) else None
    try:
        scene = plan_scene.of_run(run).of_parcels(account.weight)
    except (InputError, OSError, KeyError):
        scene = dict.fromkeys(evidence.NEAR)
    return {STEPS: steps, **scene}


def with_likeness(sheets, folders):
    """The `run_sheet.Sheet`s, each with the likeness of its run; `folders` {name: path}."""
    return [dataclasses.replace(sheet, likeness=likeness(folders[sheet.name], sheet.account)) for sheet in sheets]


def trades_of(sheets, depth):
    """[`Trade`] of each `run_sheet.Sheet` but the first, the reference. What has no error that is to be trusted is no evidence and is left out, and so is a run that
    is not placed. InputError where one was stored without its likeness."""
    reference, found = sheets[0], []
    for sheet in sheets[1:]:
        if not is_placed(sheet):
            continue
        account = sheet.account
        for quantity, (deviation, error) in _deviations(reference.report, sheet.report, depth).items():
            found.append(Trade(scene=account.case, method=account.method, weight=account.weight, quantity=quantity, deviation=deviation, error=error,
                               reference=reference.account.method, command=account.command, **sheet.likeness))  # fmt: skip
    return found


def is_placed(sheet):
    """Whether other scenes can be told to be near that of the `run_sheet.Sheet`. InputError where it was stored without its likeness."""
    if not sheet.likeness:
        raise InputError(f"--trades: {sheet.name} was stored by a version that did not keep what tools/plan compares; store it again: tools/report RUN --store DIR")
    return all(sheet.likeness[name] for name in evidence.NEAR)


def _deviations(reference, report, depth):
    """{quantity: (deviation, error)}, shares of the reference's."""
    ours, theirs = trade.quantities(report, depth), trade.quantities(reference, depth)
    pairs = {name.replace(",", "").replace(" ", "_"): (means[0], theirs[name][1][0]) for name, (_, means) in ours.items()
             if len(means) == 1 and name in theirs and name != FREQUENCY}  # fmt: skip
    name = "granular temperature"
    if name in ours and name in theirs:
        pairs["granular_temperature"] = trade.as_mean(ours[name][1]), trade.as_mean(theirs[name][1])
    widest = [next((each.mean for each in some.overlaps if each.name == PERCENTILE), None) for some in (report, reference)]
    if all(widest):
        pairs["overlap_percentile_97"] = tuple(widest)
    found = {name: _ratio(*pair) for name, pair in pairs.items()}
    name = "vertical velocity"
    if name in ours and name in theirs:
        found["vertical_velocity"] = _amplitude(ours[name][1], theirs[name][1])
    return {name: each for name, each in found.items() if each is not None and all(map(math.isfinite, each))}


def _ratio(mean, reference):
    if mean is None or reference is None or mean.reason or reference.reason or not reference.value:
        return None
    ratio = mean.value / reference.value
    return ratio - 1, math.hypot(mean.error / reference.value, ratio * reference.error / reference.value)


def _amplitude(means, reference):
    """Of a profile that is the reference's times a factor, least squares, that factor less 1; the reference's own error in first order."""
    pairs = [(a, b) for a, b in zip(means, reference) if a is not None and b is not None]
    square = sum(b.value**2 for _, b in pairs)
    if not square or any(each.reason for pair in pairs for each in pair):
        return None
    factor = sum(a.value * b.value for a, b in pairs) / square
    variance = sum((b.value * a.error) ** 2 + ((a.value - 2 * factor * b.value) * b.error) ** 2 for a, b in pairs) / square**2
    return factor - 1, math.sqrt(variance)


def write(path, trades):
    """The table that evidence.read reads, numbers to four digits."""
    stream = io.StringIO()
    rows = csv.writer(stream, lineterminator="\n")
    rows.writerow(evidence.COLUMNS)
    for each in trades:
        values = [getattr(each, name) for name in evidence.COLUMNS]
        rows.writerow(["" if value is None else f"{value:.4g}" if isinstance(value, (int, float)) else value for value in values])
    whole_file.write(path, stream.getvalue())
