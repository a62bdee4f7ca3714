# SPDX-License-Identifier: GPL-3.0-or-later
"""Do two records of a chaotic flow have the same means, as far as their length lets one tell?

Two runs that differ in a last bit part ways within seconds; their statistics should not. Every series of
results.h5, and every measure of the particle snapshots, gives a mean with the error that time_statistics.py
estimates from its autocorrelation; the difference is tested by Welch's t.

Distributions of the particles' vertical velocity are compared through the time means of their quantiles. A
Kolmogorov-Smirnov test would need the number of independent particles, which nobody knows: neighbours move together
and stay together from one snapshot to the next. Quantiles as series need no such number.
"""

from dataclasses import dataclass
from typing import Optional

import numpy

from interphase import time_statistics as statistics
from interphase.time_statistics import Mean, MeanDifference

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
UNEVEN = 0.05

SAME, DIFFERENT, UNJUDGED = "indistinguishable", "different", "not judged"


@dataclass
class Comparison:
    """One quantity: means of a and b, their difference, and the verdict; `reason` where it is `not judged`."""

    name: str
    a: Optional[Mean]
    b: Optional[Mean]
    difference: Optional[MeanDifference] = None
    seen_from: float = 0.0
    verdict: str = UNJUDGED
    reason: str = ""


def snapshot_measures(state, weigh):
    """Scalars of one snapshot, by name: SI units, z upwards.

    With `weigh`, averages over particles are weighted by volume, taken from the diameter, so that they are means
    over the solid; quantiles are over the tracked particles.
    """
    quantities = state.quantities
    if not len(state.ids):
        return {}
    weights = quantities["diameter"] ** 3 if weigh else None

    def average(values):
        return float(numpy.average(values, weights=weights))

    measures = {"particles/number": float(len(state.ids))}
    if "position" in quantities:
        measures["particles/mean_height [m]"] = average(quantities["position"][:, 2])
    if "velocity" in quantities:
        velocity = quantities["velocity"]
        measures["particles/kinetic_energy_per_mass [J/kg]"] = average(0.5 * numpy.sum(velocity**2, axis=1))
        measures["particles/mean_vertical_velocity [m/s]"] = average(velocity[:, 2])
        if numpy.isfinite(velocity[:, 2]).all():
            for level, value in zip(QUANTILES, numpy.quantile(velocity[:, 2], QUANTILES)):
                measures[f"particles/vertical_velocity_quantile_{100 * level:g}% [m/s]"] = float(value)
    if "spin" in quantities:
        measures["particles/mean_square_spin [rad2/s2]"] = average(numpy.sum(quantities["spin"] ** 2, axis=1))
    return measures


def snapshot_series(source, matching, start, end, weigh):
    """(times [n], {name: values [n]}) over the frames of a source; times are steps where the solid step is unknown."""
    times, rows = [], []
    for frame in source.frames():
        if matching.within(frame, start, end):
            measures = snapshot_measures(frame.load(), weigh)
            if measures:
                at = matching.time(frame)
                times.append(frame.step if at is None else at)
                rows.append(measures)
    names = [name for name in (rows[0] if rows else ()) if all(name in row for row in rows)]
    return numpy.array(times, dtype=float), {name: numpy.array([row[name] for row in rows]) for name in names}


def uneven(times):
    """(least, largest) interval where they differ by more than 5 %, else None: means are over samples then."""
    steps = numpy.diff(times)
    if len(steps) and steps.max() > (1 + UNEVEN) * steps.min():
        return float(steps.min()), float(steps.max())
    return None


def compare(series_a, series_b, confidence):
    """`Comparison`s of the series that both dicts {name: values [n]} have.

    `confidence` holds for all of them together: with m quantities judged, each is tested at significance
    (1 - confidence) / m (Bonferroni), so that m comparisons of one and the same flow raise a false alarm with a
    chance of 1 - confidence at most.
    """
    found = [_means(name, series_a[name], series_b[name]) for name in series_a if name in series_b]
    judged = [c for c in found if c.difference is not None]
    for comparison in judged:
        level = (1 - confidence) / len(judged)
        comparison.seen_from = statistics.seen_from(comparison.difference, level)
        comparison.verdict = DIFFERENT if comparison.difference.chance < level else SAME
    return found


def _means(name, a, b):
    broken = [side for side, values in (("A", a), ("B", b)) if not numpy.isfinite(values).all()]
    if len(broken) == 1:
        return Comparison(name, None, None, verdict=DIFFERENT, reason=f"NaN or infinite values in {broken[0]} alone")
    if broken:
        return Comparison(name, None, None, reason="NaN or infinite values in A and B")
    if not len(a) or not len(b):
        return Comparison(name, None, None, reason="no samples")
    means = [statistics.mean_with_error(values) for values in (a, b)]
    comparison = Comparison(name, *means)
    reasons = [f"{side}: {mean.reason}" for side, mean in zip("AB", means) if mean.reason]
    if reasons:
        comparison.reason = "; ".join(reasons)
    else:
        comparison.difference = statistics.difference(*means)
    return comparison
