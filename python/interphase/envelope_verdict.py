# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of tools/envelope was: calm and right, calm with an error, told, or failed.

Measures are relative: velocities to the hindered one or to the stream, pressures to the weight of the bed, heights to the law's.
"""

import math
import re
from dataclasses import dataclass

import numpy

RIGHT, ERROR, TOLD, FAILED, BEYOND = "calm and right", "calm with stated error", "told", "failed", "not run"
VERDICTS = (RIGHT, ERROR, TOLD, FAILED, BEYOND)

RIGHT_WITHIN = 0.02  # error that is none
CALM_WITHIN = 0.05  # standard deviation in time
ALTERNATION = 0.02  # amplitude of an oscillation of two steps
STATED_WITHIN = 0.25  # a larger error is no longer one of a calm run


@dataclass
class Measures:
    """errors: name -> signed relative error; rms and alternation: the largest; samples: of the scarcest of them."""

    errors: dict
    rms: float
    alternation: float
    samples: int
    closed: float = 0.0  # worst residual of momentum, solid volume, gas volume in the books

    def worst(self):
        """(name, error) of the largest."""
        return max(self.errors.items(), key=lambda item: abs(item[1]) if math.isfinite(item[1]) else math.inf)


def alternation(values):
    """Amplitude of what goes up and down from one value to the next, a trend and longer waves apart: the values' second
    differences over 4, their mean magnitude over those that change sign from one to the next. 0 for fewer than three."""
    second = numpy.diff(numpy.asarray(values, float), 2)
    if not len(second):
        return 0.0
    if len(second) == 1:
        return float(abs(second[0]) / 4)
    turns = second[1:] * second[:-1] < 0
    both = numpy.minimum(abs(second[1:]), abs(second[:-1]))
    return float(numpy.where(turns, both, 0.0).mean() / 4)


def deviation(values):
    """Standard deviation in time about a straight line: a drift counts as error, not as swing."""
    values = numpy.asarray(values, float)
    if len(values) < 3 or not numpy.isfinite(values).all():
        return 0.0 if numpy.isfinite(values).all() else math.inf
    time = numpy.arange(len(values))
    return float((values - numpy.polyval(numpy.polyfit(time, values, 1), time)).std())


def message(log):
    """The first warning or error of a run in its output, '' where there is none."""
    found = re.search(r"^.*\b(?:warning|error)\b:?\s*(.*(?:\n(?!\s*$).*){0,3})", log, re.I | re.M)
    return re.sub(r"\s+", " ", found[1])[:300] if found else ""


def verdict(code, log, measures):
    """(one of VERDICTS, what was seen). `measures` is None where the run left nothing to measure."""
    said = message(log)
    if code != 0:
        signalled = code < 0 or code >= 128 or re.search(r"signal \d+ \(|segmentation fault|stack trace", log, re.I)
        if signalled or not said:
            return FAILED, f"exit code {code}" + (f": {said}" if said else ", no message")
        return TOLD, said
    if measures is None or measures.samples < 2:
        return FAILED, "exit code 0, but nothing to measure in its records"
    name, error = measures.worst()
    seen = f"{name} {100 * error:+.1f} %, rms {100 * measures.rms:.1f} %, alternation {100 * measures.alternation:.1f} %"
    numbers = [error, measures.rms, measures.alternation]
    calm = all(map(math.isfinite, numbers)) and measures.rms <= CALM_WITHIN and measures.alternation <= ALTERNATION
    if calm and abs(error) <= RIGHT_WITHIN:
        return RIGHT, seen
    if said:
        return TOLD, f"{seen}; {said}"
    return (ERROR, seen) if calm and abs(error) <= STATED_WITHIN else (FAILED, seen)
