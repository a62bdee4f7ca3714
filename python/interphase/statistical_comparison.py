# SPDX-License-Identifier: GPL-3.0-or-later
"""Do two records of a chaotic flow have the same means, as far as their length lets one tell?

Two runs that differ in a last bit part ways within seconds; their statistics should not. Every series of
results.h5, and every measure of the particle snapshots, gives a mean with the error that time_statistics.py
estimates from its autocorrelation; the difference is tested by Welch's t. Where the errors cannot be estimated, what
is left is whether the ranges of the two records lie apart, and how likely that is for records worth so few samples.

What is constant on both sides says nothing of a flow and does not count. Holm's procedure (Scand. J. Stat. 6 (1979) 65)
holds the chance of any false alarm among all quantities, however they depend on each other, to what is asked for.

Distributions of the particles' vertical velocity are compared through the time means of their quantiles. A
Kolmogorov-Smirnov test would need the number of independent particles, which nobody knows: neighbours move together
and stay together from one snapshot to the next. Quantiles as series need no such number.
"""

import math
from dataclasses import dataclass
from typing import Optional

import numpy
from scipy import special, stats

from interphase import time_statistics as statistics
from interphase.snapshot_measures import snapshot_measures
from interphase.time_statistics import Mean, MeanDifference

UNEVEN = 0.05
# Sums over particles and cells are off by this much of their size; what varies by no more is constant.
ROUND_OFF = 1e-12

SAME, DIFFERENT, UNJUDGED = "indistinguishable", "different", "not judged"
CONSTANT, GROSS = "constant", "differ grossly"
# Of a single quantity: with many of them some are apart by chance. What all together say is up to --confidence.
GROSS_LEVEL = 0.05
# A test that sees no difference below this many standard deviations in time judges nothing: a mean a tenth of another lies
# about so far away where both fluctuate by a third.
BLUNT = 3.0


@dataclass
class Comparison:
    """One quantity: means of a and b, their difference, and the verdict; `reason` where it is `not judged`.

    `chance` of what was seen, or more, in one and the same flow (None: not tested). `apart`: the ranges of the two
    records do not overlap. `longer`: by how many times the record would have to be longer to be judged. `certain`: called
    different at the confidence that holds for all quantities together.
    """

    name: str
    a: Optional[Mean]
    b: Optional[Mean]
    difference: Optional[MeanDifference] = None
    seen_from: float = 0.0
    verdict: str = UNJUDGED
    reason: str = ""
    chance: Optional[float] = None
    apart: bool = False
    longer: Optional[float] = None
    certain: bool = False


def snapshot_series(source, matching, start, end, weigh, place=None):
    """(times [n], {name: values [n]}) over the frames of a source; times are steps where the solid step is unknown."""
    times, rows = [], []
    for frame in source.frames():
        if matching.within(frame, start, end):
            measures = snapshot_measures(frame.load(), weigh, place)
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

    `confidence` holds for all of them together (Holm): comparing one and the same flow with itself, any quantity at all is
    called different with a chance of 1 - confidence at most.
    """
    found = [_tested(name, series_a[name], series_b[name]) for name in series_a if name in series_b]
    tested = sorted((c for c in found if c.chance is not None), key=lambda c: c.chance)
    level, rejecting = 1 - confidence, True
    for rank, comparison in enumerate(tested):
        if rejecting:
            level = (1 - confidence) / (len(tested) - rank)
            rejecting = comparison.chance < level
        if comparison.difference is not None:
            comparison.verdict = DIFFERENT if rejecting else SAME
        elif comparison.chance < GROSS_LEVEL:
            comparison.verdict = GROSS
        comparison.certain = rejecting
    for comparison in tested:
        if comparison.difference is not None:
            comparison.seen_from = _seen_from(comparison, level)
            deviation = max(comparison.a.deviation, comparison.b.deviation)
            if comparison.verdict == SAME and comparison.seen_from > BLUNT * deviation:
                comparison.verdict = UNJUDGED
                comparison.longer = (comparison.seen_from / (BLUNT * deviation)) ** 2
                comparison.reason = f"no difference below {comparison.seen_from / deviation:.2g} of its deviations in time would show"
    return found


def _tested(name, a, b):
    broken = [side for side, values in (("A", a), ("B", b)) if not numpy.isfinite(values).all()]
    if len(broken) == 1:
        return Comparison(name, None, None, verdict=DIFFERENT, certain=True, reason=f"NaN or infinite values in {broken[0]} alone")
    if broken:
        return Comparison(name, None, None, reason="NaN or infinite values in A and B")
    if not len(a) or not len(b):
        return Comparison(name, None, None, reason="no samples")
    size = max(float(numpy.abs(a).max()), float(numpy.abs(b).max()))
    if max(float(numpy.ptp(a)), float(numpy.ptp(b))) <= ROUND_OFF * size:
        apart = abs(float(a[0] - b[0])) > ROUND_OFF * size
        means = (statistics.mean_with_error(numpy.full(len(x), x[0])) for x in (a, b))
        return Comparison(name, *means, verdict=DIFFERENT if apart else CONSTANT,
                          reason="two constants" if apart else "", certain=apart)
    means = [statistics.mean_with_error(values) for values in (a, b)]
    comparison = Comparison(name, *means)
    reasons = [f"{side}: {mean.reason}" for side, mean in zip("AB", means) if mean.reason]
    if not reasons:
        comparison.difference = statistics.difference(*means)
        comparison.chance = _chance(comparison.difference, means)
        return comparison
    comparison.reason = "; ".join(reasons)
    comparison.longer = max(statistics.longer_by(values) for values in (a, b))
    comparison.apart = bool(a.max() < b.min() or b.max() < a.min())
    comparison.chance = _chance_of_apart(a, b) if comparison.apart else 1.0
    return comparison


def _chance(difference, means):
    """Chance of a larger ratio in one flow, by `_freedom`."""
    return float(2 * stats.t.sf(abs(difference.ratio), _freedom(*means)))


def _freedom(a, b):
    """Degrees of freedom for the difference of two `Mean`s: the fewer of both (Welch's are up to their sum), which is on the safe side.

    Prewhitening leaves a bias in records that are just long enough. On white noise and AR series of 100 to 2,000 samples, 31 to 210 times their memory,
    differences that Welch's t gives 0.05 % came up to 3.2 times as often; by this, 1.4 times.
    """
    return min(a.freedom, b.freedom)


def _seen_from(comparison, level):
    """The smallest |b - a| that would have had a chance below `level`."""
    if comparison.difference.error == 0:
        return 0.0
    return float(stats.t.isf(level / 2, _freedom(comparison.a, comparison.b))) * comparison.difference.error


def _chance_of_apart(a, b):
    """Chance that the ranges of two records of one flow lie apart: all of m + n independent samples, which may be exchanged,
    lie in this order, or the reverse, in 2 of C(m + n, m) cases; m, n: what the records are worth.

    """
    m, n = (statistics.worth(values) for values in (a, b))
    # Nothing tells how many samples a constant is worth; no more than what varies, surely.
    m, n = (min(m, n) if not numpy.ptp(values) else worth for worth, values in ((m, a), (n, b)))
    return min(1.0, 2 / special.comb(m + n, m)) if m and n else 1.0


def needed(comparisons):
    """How many times longer records must be, about, for half of what varies to be judged; None where that is not known."""
    varying = [c for c in comparisons if c.verdict != CONSTANT]
    missing = math.ceil(len(varying) / 2) - sum(c.verdict in (SAME, DIFFERENT) for c in varying)
    factors = sorted(c.longer for c in varying if c.verdict in (UNJUDGED, GROSS) and c.longer is not None)
    return factors[missing - 1] if 0 < missing <= len(factors) else None
