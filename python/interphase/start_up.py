# SPDX-License-Identifier: GPL-3.0-or-later
"""When the start-up of a run is over, as its series tell.

The rule is MSER-5 (K. P. White, Simulation 69 (1997) 323; K. P. White, M. J. Cobb, S. C. Spratt, Proc. Winter Simulation
Conf. 2000, 755): leave out the first d means of five samples that make the standard error of the mean of the rest, as if they were
independent, least. Where the least is in the latter half of a record, the record is too short to tell. Two changes: fewer than a tenth of
the means, or five, are never all that is left, as so few lie close to each other by chance; and records below 1,000 samples are taken
sample by sample. Of 300 steady AR(1) records of 20, 50, 100 and 300 samples each, neighbours correlated by 0.5, it calls 24, 13, 0 and 0 %
too short to tell; by 0.9, 39, 45, 26 and 3 %.

What is left of the start-up hardly moves the mean: of slugging series (0.4 s, 20 to 60 s long, some with a tenth of slow motion) and of decays that begin
1 to 10 deviations off and settle in 1 s, 95 % bars of what is left cover 89 to 96 %. Where it settles in a tenth of the record and the
record has no slugs, or in a seventh, they cover 84 to 88 %.
"""

import math
from dataclasses import dataclass
from typing import Optional

import numpy

from interphase.input_error import InputError
from interphase.matching_times import Matching

BATCH = 5
LEFT, LEFT_SHARE = 5, 0.1  # of the batches, that are left at least
FEWEST = 20  # samples
BATCHED_FROM = 1000  # samples
# Series of a run that come to a steady state when it does, with the words for them.
SERIES = {"pressure_drop": "pressure drop", "bed_height": "bed height", "kinetic_energy": "kinetic energy",
          "vertical_velocity": "vertical velocity", "particles": "number of particles"}
# Deviations of this share of the largest value are as good as none: else what comes to rest exponentially never would.
NEGLIGIBLE = 1e-3


@dataclass(frozen=True)
class StartUp:
    """`end`: the time from which on a record is steady [s], None where it does not tell; `reason` then says why, and
    `needed` is the time [s] to which the run would have to go at least (None: unknown). `by`: what settled last, "" if all were
    steady from the first row on."""

    end: Optional[float]
    by: str = ""
    reason: str = ""
    needed: Optional[float] = None


def truncation(series):
    """How many samples of a series [n] are its start-up; None where the record is too short to tell. Not finite: ValueError."""
    series = numpy.asarray(series, dtype=float)
    if series.ndim != 1 or not numpy.isfinite(series).all():
        raise ValueError("truncation needs a one-dimensional series, all finite")
    if len(series) < FEWEST:
        return None
    size = BATCH if len(series) >= BATCHED_FROM else 1
    count = len(series) // size
    means = series[:count * size].reshape(count, size).mean(axis=1)
    means = means - means.mean()  # or the sums of squares below would lose digits
    left = numpy.arange(count, 0, -1)
    sums, squares = means[::-1].cumsum()[::-1], (means**2)[::-1].cumsum()[::-1]
    floor = (NEGLIGIBLE * numpy.abs(series).max()) ** 2
    marginal = (numpy.maximum(squares / left - (sums / left) ** 2, 0.0) + floor) / left
    least = int(marginal[:count - max(LEFT, int(LEFT_SHARE * count)) + 1].argmin())
    return least * size if 2 * least <= count else None


def _and(words):
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def start_up_of(times, columns):
    """The `StartUp` of a record with rows at `times` [n], s, and `columns` {name: values [n]}; the latest of all columns counts.

    Columns that are not of `SERIES`, or hold NaN (no taps), do not count.
    """
    found = {words: numpy.asarray(columns[name]) for name, words in SERIES.items()
             if name in columns and numpy.isfinite(columns[name]).all()}
    if not found or not len(times):
        return StartUp(None, reason="no series tells of it")
    if len(times) < FEWEST:
        interval = (times[-1] - times[0]) / (len(times) - 1) if len(times) > 1 else None
        needed = None if interval is None else float(times[0] + (2 * FEWEST - 1) * interval)
        return StartUp(None, reason=f"{len(times)} rows of series, at least {FEWEST} are needed", needed=needed)
    cut = {words: truncation(values) for words, values in found.items()}
    moving = [words for words, at in cut.items() if at is None]
    if moving:
        span = f"{times[0]:.4g} to {times[-1]:.4g} s"
        return StartUp(None, _and(moving), f"{_and(moving)} not steady within {span}",
                       float(2 * times[-1] - times[0]))
    last = max(cut, key=cut.get)
    return StartUp(float(times[cut[last]]), last if cut[last] else "")


def start_up_of_run(run, end):
    """The `StartUp` of `Records` that is looked at until `end` [s] (None: to its end)."""
    try:
        series = run.series()
    except InputError as error:
        return StartUp(None, reason=str(error))
    if series is None:
        return StartUp(None, reason="there is no /series")
    times, columns = series
    where = Matching("time", None)
    inside = numpy.array([where.inside(time, None, end) for time in times], dtype=bool)
    return start_up_of(times[inside], {name: values[inside] for name, values in columns.items()})


def later_half(first, last):
    """The time [s] from which on a record is looked at that does not tell the end of its start-up."""
    return first + (last - first) / 2 if math.isfinite(last - first) else first
