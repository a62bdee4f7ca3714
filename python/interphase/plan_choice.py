# SPDX-License-Identifier: GPL-3.0-or-later
"""Which method to take, by what it costs and by what was measured of it in scenes like this one."""

import re
import statistics
from dataclasses import dataclass

from interphase import evidence
from interphase.durations import told
from interphase.input_error import InputError

UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
REFERENCE = "DEM"  # what the others are held against, wherever it was run


@dataclass(frozen=True)
class Planned:
    """A method with its `weight` and steps in a collision (None: it has none), what it will take by the clock, `wall` [s], and the numbers of its parcels in
    this scene, `numbers` of PlannedScene.of_parcels; `calibration`: how that is known."""

    method: str
    weight: float
    steps_per_collision: float
    wall: float
    numbers: dict
    calibration: object = None

    @property
    def name(self):
        return self.method + (f" W = {self.weight:g}" if self.weight != 1 else "")

    def evidence(self, trades):
        """The `Trade`s of the method."""
        return evidence.of_method(trades, self.method, self.weight, self.steps_per_collision)

    def near(self, trades):
        """Those of scenes like this one."""
        return [each for each in self.evidence(trades) if evidence.is_near(each, self.numbers)]


def duration(text):
    """Seconds of `2h`, `90 min`, `30s`, `1.5 d`; InputError where it is none."""
    found = re.fullmatch(r"\s*([\d.]+(?:e[+-]?\d+)?)\s*(s|min|h|d)\s*", text)
    try:
        value = float(found[1]) * UNITS[found[2]]
    except (TypeError, ValueError):
        value = 0.0
    if not 0 < value < float("inf"):
        raise InputError(f"--within {text}: give a time above 0 with its unit, s, min, h or d, such as 2h")
    return value


def accuracy(text, trades):
    """(quantity, share) of `pressure_drop 5%`; InputError where it is none, or nothing of that name was measured."""
    found = re.fullmatch(r"\s*(\S+)\s+([\d.]+)\s*%\s*", text)
    try:
        share = float(found[2]) / 100
    except (TypeError, ValueError):
        share = 0.0
    if not share > 0:
        raise InputError(f"--accuracy {text}: give a quantity and the share that it may be off, such as 'pressure_drop_deviation 20%'")
    return evidence.checked_quantity(found[1], trades), share


def verdict(planned, trades, asked):
    """(whether `planned` is within what is `asked` [(quantity, share)], words on why): None where nothing near was measured."""
    words, held = [], True
    for quantity, share in asked:
        if planned.method == REFERENCE:
            words.append("it is the reference")
            continue
        near = [each for each in planned.near(trades) if each.quantity == quantity]
        if not near:
            return None, nothing_near(planned, trades, quantity)
        best = min(near, key=lambda each: evidence.distance(each, planned.numbers))
        fits = best.at_worst <= share
        held = held and fits
        words.append(f"{best.scene} (parcel/depth {best.parcel_over_depth:.2g}, U/U_mf {best.velocity_over_minimum:.3g}): {best.words} of "
                     f"{best.reference}'s, at worst {100 * best.at_worst:.0f} %" + ("" if fits else f", above {100 * share:g} %"))
    return held, "; ".join(words)


def nothing_near(planned, trades, quantity=None):
    """Words: what is nearest, and what of it is far."""
    known = [each for each in planned.evidence(trades) if quantity in (None, each.quantity)]
    far = evidence.nearest_scene(known, planned.numbers)
    of = f" of its {quantity}" if quantity else ""
    return f"nothing near was measured{of}" + (f"; nearest is {far[0]}: {far[1]}" if far else "")


def cheapest(all_planned, trades, asked, within):
    """(the `Planned` to take or None, lines that say why) for the accuracy `asked` [(quantity, share)] and the time `within` [s] by the clock (None:
    any)."""
    lines = []
    in_time = [each for each in all_planned if within is None or each.wall <= within]
    if not in_time:
        least = min(all_planned, key=lambda each: each.wall)
        return None, [f"none is done in {told(within)}: the cheapest, {least.name}, takes {told(least.wall)}. Take larger parcels, a shorter --until, "
                      "more --ranks or a coarser mesh"]
    for late in (each for each in all_planned if each not in in_time):
        lines.append(f"{late.name}: too late, {told(late.wall)}")
    if asked:
        return _within_accuracy(in_time, trades, asked, lines)
    known = [(each, _typical(each, trades)) for each in in_time]
    for each, off in known:
        lines.append(f"{each.name}: " + (f"typically {100 * off[0]:.0f} % off ({off[1]} quantities of {off[2]})" if off else
                                        nothing_near(each, trades)))  # fmt: skip
    known = [(each, off) for each, off in known if off]
    if not known:
        return None, [*lines, "no method is named: nothing near to this scene was measured"]
    return min(known, key=lambda each: (each[1][0], each[0].wall))[0], lines


def _within_accuracy(in_time, trades, asked, lines):
    fit = []
    for each in sorted(in_time, key=lambda each: each.wall):
        held, why = verdict(each, trades, asked)
        lines.append(f"{each.name}: {'within' if held else 'not known' if held is None else 'not within'}: {why}")
        fit += [each] if held else []
    if not fit:
        return None, [*lines, "no method is known to be that accurate in a scene like this one"]
    return fit[0], lines


def _typical(planned, trades):
    """(median of |deviation|, number of quantities, scenes) of what near was measured; 0 of the reference; None where nothing was."""
    if planned.method == REFERENCE:
        return 0.0, "all", "which the others are held against"
    near = planned.near(trades)
    if not near:
        return None
    return statistics.median(abs(each.deviation) for each in near), len({each.quantity for each in near}), ", ".join(sorted({each.scene for each in near}))
