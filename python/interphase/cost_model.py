# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run will cost, of what the first part of it, or a part of one like it, has cost: processor seconds, phase by phase.

Times of simulation in s, costs in seconds of processors, all ranks together.
"""

import math
from dataclasses import dataclass, field

import numpy

from interphase.input_error import InputError

PHASES = ("solids", "gas", "mapping", "exchange", "output", "waiting")  # set-up apart, which is paid once
BLOCKS = 6  # of the shortest calibration: each long enough to even out when lists are renewed, and enough of them to see a trend
MOST_BLOCKS = 24
SHAPE_ERROR = 0.1  # of what is taken from another method's pace: 0.91 to 1.10 on sscp1, DEM by CGPM, TDHS and CGPM by CGHS, all from W = 8
FEWEST = 2 * BLOCKS  # gas steps


@dataclass(frozen=True)
class Pace:
    """What a phase costs per simulated second: `rates` [k] about the times `at` [k], of spans `width` [k], all in s; `doubt` [k]: standard
    errors of what was not measured but taken from another method, shares of the rates, of one sign all together; 0 where it was measured."""

    at: numpy.ndarray
    rates: numpy.ndarray
    width: numpy.ndarray
    doubt: numpy.ndarray

    @property
    def end(self):
        """Up to where it was measured [s]."""
        return float(self.at[-1] + self.width[-1] / 2)

    @property
    def last(self):
        """The rate that goes on: the mean over the last half of what was measured, as a bed comes to its pace after a start of its own."""
        late = self._late
        return float(numpy.average(self.rates[late], weights=self.width[late]))

    @property
    def _late(self):
        return slice(len(self.rates) // 2, None)

    @property
    def error_of_last(self):
        """Standard error of it: by the scatter of its blocks, and by what the halves of them differ, as a trend may go on. Rather too large: without a trend
        twice the scatter of the mean."""
        late = self.rates[self._late]
        if len(late) < 2:
            return math.nan
        scatter = float(late.std(ddof=1)) / math.sqrt(len(late))
        half = len(late) // 2
        trend = abs(float(late[half:].mean() - late[:half].mean()))
        return math.hypot(scatter, trend)

    def between(self, early, late):
        """What was measured from `early` to `late` [s] cost [s]."""
        return float(self._costs(early, late).sum())

    def _costs(self, early, late):
        start, end = self.at - self.width / 2, self.at + self.width / 2
        return numpy.clip(numpy.minimum(end, late) - numpy.maximum(start, early), 0, None) * self.rates

    def seconds(self, until):
        """(cost, standard error) of a run from 0 to `until` [s]: what was measured where it was measured, the last rate beyond."""
        beyond = max(0.0, until - self.end)
        known, more = self._costs(0.0, until), beyond * self.last
        doubt = float((self.doubt * known).sum() + self.doubt[-1] * more)
        return float(known.sum()) + more, math.hypot(beyond * self.error_of_last, doubt) if beyond > 0 else doubt


def pace(time, seconds):
    """The `Pace` of the cumulative `seconds` [n] at the times `time` [n] of the rows, in 6 to 24 blocks. InputError where there are too few rows."""
    time, seconds = numpy.asarray(time, dtype=float), numpy.asarray(seconds, dtype=float)
    blocks = max(BLOCKS, min(MOST_BLOCKS, (len(time) - 1) // 4))
    if len(time) < blocks + 1:
        raise InputError(f"{len(time) - 1} gas steps were made, {BLOCKS} are needed to know a pace: give the calibration more time (--calibrate)")
    edges = numpy.unique(numpy.round(numpy.linspace(0, len(time) - 1, blocks + 1)).astype(int))
    width = numpy.diff(time[edges])
    return Pace((time[edges[:-1]] + time[edges[1:]]) / 2, numpy.diff(seconds[edges]) / width, width, numpy.zeros(len(width)))


def shaped(own, shape, work=0.0, doubt=SHAPE_ERROR):
    """The `Pace` of a costly method beyond what of it was measured, `own`: as that of a cheap one of the same kind, `shape`, goes on. Beds of parcels and of
    particles loosen alike from the same start: the number of contacts and how often neighbours change follow from the bed, and rise by 2.1 to
    2.7 in the first 0.4 s of sscp1. So what `shape` rises by after the time that `own` was measured in is added, times a factor. That is the ratio of both over that time, if
    all of a cost rises; or `work`, what `own` has of spheres times solid steps per second over what `shape` has, if only that does which each sphere costs:
    a step of few parcels mostly costs what steps cost in any case. Where the second is larger, the middle of both is taken, and half their difference
    is an error beside `doubt`. `own` where the other went no further."""
    end = own.end
    beyond = shape.at - shape.width / 2 >= end - 1e-12
    if not beyond.any():
        return own
    middle = float(own.at[len(own.at) // 2] - own.width[len(own.at) // 2] / 2)  # what comes is more like the later half
    level, of_shape = (each.between(middle, end) / (end - middle) for each in (own, shape))
    if not of_shape > 0:
        return own
    at, rates, width = shape.at[beyond], shape.rates[beyond], shape.width[beyond]
    first = float(at[0] - width[0] / 2)
    if first > end:  # the block of the other that `own` ends in
        inside = shape.rates[~beyond][-1:] if not beyond.all() else shape.rates[:1]
        at, rates, width = (numpy.concatenate(pair) for pair in (([(first + end) / 2], at), (inside, rates), ([first - end], width)))
    ratio = level / of_shape
    low, high = (numpy.maximum(0.0, level + factor * (rates - of_shape)) for factor in (ratio, max(ratio, work)))
    taken = (low + high) / 2
    bounds = numpy.divide(high - low, 2 * taken, out=numpy.zeros(len(taken)), where=taken > 0)
    return Pace(*(numpy.concatenate(pair) for pair in ((own.at, at), (own.rates, taken), (own.width, width), (own.doubt, numpy.hypot(bounds, doubt)))))


@dataclass(frozen=True)
class Output:
    """What is written: seconds for a row and for a snapshot, bytes of each and of the gas's fields; `intervals` [s] of row, snapshot, fields: how
    often the case asks for them (infinity: never)."""

    row: float
    snapshot: float
    row_bytes: float
    snapshot_bytes: float
    field_bytes: float
    intervals: tuple

    def seconds(self, until):
        return until / self.intervals[0] * self.row + (1 + until / self.intervals[1]) * self.snapshot

    def bytes(self, until, gas_step):
        """On disk after `until` [s]: a row of the ledger in each gas step is as large as one of the series, nearly."""
        rows = until / gas_step * self.row_bytes
        return rows + (1 + until / self.intervals[1]) * self.snapshot_bytes + (until / self.intervals[2]) * self.field_bytes


@dataclass(frozen=True)
class Cost:
    """`seconds` {phase: CPU s} of a run and the standard `errors` of them {phase: s}; `setup` [s] before its first step."""

    seconds: dict
    errors: dict = field(default_factory=dict)
    setup: float = 0.0

    @property
    def total(self):
        return sum(self.seconds.values()) + self.setup

    @property
    def error(self):
        """Of the total; phases go up and down together, as the bed does: their errors are added."""
        return sum(self.errors.values())

    def wall(self, ranks):
        """Seconds by the clock where a core is free for each of `ranks`: each rank is busy all the time, if only by waiting."""
        return self.total / ranks


def cost(paces, output, until, setup=0.0):
    """The `Cost` of a run to `until` [s]; `paces` {phase: Pace} of all PHASES but output, which the `Output` tells."""
    found = {name: each.seconds(until) for name, each in paces.items()}
    seconds = {name: value for name, (value, _) in found.items()}
    seconds["output"] = output.seconds(until)
    return Cost(seconds, {name: error for name, (_, error) in found.items()}, setup)


def by_the_paper(weight, steps_per_collision, own_steps=1.0):
    """Cost of the particles over that of DEM with `steps_per_collision` steps S in a collision, eqs. 25 to 27 of the paper: W^(-3/2) own_steps/S with
    `own_steps` in a parcel's own collision (S: CGPM; 1: hard spheres at t_c)."""
    return own_steps / steps_per_collision / weight**1.5


def exponent(factor, cost, errors=0.0):
    """(p, its standard error) of cost ~ factor^p by least squares of the logarithms, both [n]. `errors` [n]: relative standard errors of the costs. That of p is the larger
    one of what follows from these and from what the fit leaves, which is nothing of two points."""
    x, y = numpy.log(numpy.asarray(factor, dtype=float)), numpy.log(numpy.asarray(cost, dtype=float))
    if len(x) < 2 or numpy.ptp(x) == 0:
        raise InputError("an exponent needs two values of the factor that differ")
    x = x - x.mean()
    square = float((x * x).sum())
    slope = float((x * y).sum()) / square
    of_costs = math.sqrt(float((x * x * numpy.square(errors)).sum())) / square
    rest = y - y.mean() - slope * x
    of_fit = math.sqrt(float((rest * rest).sum()) / (len(x) - 2) / square) if len(x) > 2 else 0.0
    return slope, max(of_costs, of_fit)
