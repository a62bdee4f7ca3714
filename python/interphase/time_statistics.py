# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean of a correlated series with its standard error, and the comparison of two such means.

Successive samples of a flow depend on each other: the error of their mean is not s / sqrt(n) but
sqrt(S(0) / n), S(0) being the spectral density at frequency zero, the sum of all autocovariances. We take S(0) as
the mean square of the record's projections on the B slowest cosines cos(pi j (t + 1/2) / n), j = 1 ... B, which no mean
enters, so that mean / error has Student's t distribution of B degrees of freedom (U. K. Mueller, J. Econometrics 141 (2007)
1331; E. Lazarus, D. J. Lewis, J. H. Stock, M. W. Watson, J. Bus. Econ. Stat. 36 (2018) 541). It looks at the slow end of the
spectrum alone: neither the sampling rate nor a slugging bed's oscillation enters. What the spectrum falls between zero and the
last cosine is taken out by the shape of an autoregressive model (prewhitening: P. Heidelberger, P. D. Welch, Commun. ACM 24 (1981)
233, fit a polynomial there). B is 8, more, up to 64, in a record of more than 160 times its memory.

Three others were tried. S(0) of the autoregressive model itself (K. N. Berk, Ann. Stat. 2 (1974) 489; M. B. Thompson, arXiv:1011.0175) is
as good for series that such a model made; where a tenth of a slugging bed's variance was of a slow motion, or a fiftieth, its 95 % bars covered
58 to 88 % in records of 20 to 50 times the slow one, these 92 to 94 %. Automatic block averaging (Flyvbjerg and Petersen, J. Chem. Phys. 91
(1989) 461, the block by Jonsson, Phys. Rev. E 98 (2018) 043304) gave errors too small by 14 to 50 % on records of 400 to 20 autocorrelation
times; windowed sums of the autocorrelation function can turn negative on damped oscillations.
"""

import dataclasses
import math
from dataclasses import dataclass

import numpy
from scipy import fft, stats

from interphase import autoregression

MINIMUM_SAMPLES = 20
MINIMUM_TIMES = 20  # of its memory that a record must last
FEWEST_COSINES, MOST_COSINES = 8, 64
TIMES_A_COSINE = 20  # B = the record over so many times its memory
# A line through the record is in the first cosine (96 % of its square); a steady record has it this rarely so far above the others.
DRIFT_CHANCE = 0.001
# Averages of neighbours that models are fitted to: of few the slow motions, of many the oscillations.
COARSE, FINE = 256, 2048
FEWEST_FITTED = 8  # samples of which a model of two coefficients can be made


@dataclass(frozen=True)
class Mean:
    """A mean and how well it is known.

    `error` is the standard error, in units of the series; `freedom` the degrees of freedom of that estimate, for
    Student's t; `effective` the number of independent samples that would know the mean as well; `time` the
    integral autocorrelation time 1/2 + sum of the autocorrelation function, in samples (1/2: uncorrelated); `memory` that of the
    slow motion, in samples: of an oscillation its period, or the time in which it decays if that is shorter.
    `reason` is empty, or says why the error is not to be trusted; `longer` then is how many times longer the record must be,
    about (`longer_by`). `drifts`: it does not go about a mean, but along a line.
    """

    value: float
    error: float
    deviation: float
    samples: int
    effective: float
    freedom: float
    time: float
    reason: str = ""
    longer: float = 1.0
    memory: float = 0.0
    drifts: bool = False


@dataclass(frozen=True)
class MeanDifference:
    """`value` = b - a, its standard error, the ratio of both, and the chance of a larger ratio if a = b."""

    value: float
    error: float
    ratio: float
    chance: float
    freedom: float


@dataclass(frozen=True)
class _Slow:
    """Of the slow end of a series: standard `error` of the mean, its degrees of `freedom`, `memory` [samples], whether it `drifts`."""

    error: float
    freedom: float
    memory: float
    drifts: bool


def _averaged(series, most):
    """(averages of neighbours, at most `most`, less their mean; samples in each). They keep the mean and S(0)."""
    block = -(-len(series) // most)
    blocks = len(series) // block
    averages = series[len(series) - blocks * block:].reshape(blocks, block).mean(axis=1)
    return averages - averages.mean(), block


def _slow(series):
    """`_Slow` of a series [n] that is no constant; None where averages of its neighbours are one."""
    averages, block = _averaged(series, COARSE)
    if not averages.any():
        return None
    count = len(averages)
    phi, _ = autoregression.fitted(averages)
    memory = autoregression.memory(autoregression.surely_fitted(averages)[0])
    if block > 1:
        # What two averages remember may be a part of one; finer ones tell that better.
        finer, size = _averaged(series, FINE)
        memory = max(memory * block * (memory > 2), size * autoregression.memory(autoregression.surely_fitted(finer)[0]))
    cosines = int(min(max(count * block / (TIMES_A_COSINE * memory) if memory else MOST_COSINES, FEWEST_COSINES), MOST_COSINES, count // 3))
    power = fft.dct(averages, norm="ortho")[1:cosines + 1] ** 2
    others = float(power[1:FEWEST_COSINES].mean()) if cosines > 1 else 0.0
    drifts = cosines > 2 and power[0] > others * stats.f.isf(DRIFT_CHANCE, 1, min(cosines, FEWEST_COSINES) - 1)
    shape = autoregression.gain(phi, numpy.arange(cosines + 1) / (2 * count))
    error = math.sqrt(float((power * shape[0] / shape[1:]).mean()) / count)
    integral = 0.5 * len(series) * error**2 / float(series.var())
    return _Slow(error, float(cosines), max(memory, integral), bool(drifts))


def _lasts(series):
    """How many times its memory a record [n] lasts, as it shows it itself, however short; infinite for a constant, 0 where it cannot tell."""
    series = numpy.asarray(series, dtype=float)
    if len(series) < 2 or float(series.std()) <= 1e-14 * float(numpy.abs(series).max(initial=0.0)):
        return math.inf if len(series) > 1 else 0.0
    found = _slow(series) if len(series) >= FEWEST_FITTED else None
    return 0.0 if found is None or not found.memory else len(series) / found.memory


def worth(series):
    """How many independent samples a record [n] is surely worth, a whole number that may be 0, not above n.

    A record that is too short for the error of its mean may still be worth a few: one for each two times its memory. Two are
    taken off for the mean and the drift that a record shorter than its motions takes for a part of itself.
    """
    return max(int(min(_lasts(series) / 2, len(series))) - 2, 0) if _lasts(series) < math.inf else max(len(series) - 2, 0)


def longer_by(series):
    """How many times longer a record must be for its mean to have an error, about; at least 1.

    As far as the record shows: motions slower than itself make it more.
    """
    lasts = _lasts(series)
    return max(1.0, MINIMUM_SAMPLES / len(series), MINIMUM_TIMES / lasts if lasts else 1.0)


def mean_with_error(series):
    """`Mean` of a stationary series [n] at even spacing, its autocorrelation taken in. NaN or empty: ValueError.

    The error is not trusted, which `reason` says, where the record has less than MINIMUM_SAMPLES, lasts less than
    MINIMUM_TIMES its memory, or goes along a line.
    """
    series = numpy.asarray(series, dtype=float)
    count = len(series)
    if series.ndim != 1 or count == 0 or not numpy.isfinite(series).all():
        raise ValueError("mean_with_error needs a one-dimensional series of at least one sample, all finite")
    value = float(series.mean())
    deviation = float(series.std(ddof=1)) if count > 1 else 0.0
    # A constant's mean is off by round-off; so would its deviation be. One sample is not known to be a constant.
    if count > 1 and deviation <= 1e-14 * float(numpy.abs(series).max()):
        return Mean(value, 0.0, 0.0, count, float(count), math.inf, 0.5)
    if count < MINIMUM_SAMPLES:
        return Mean(value, math.nan, deviation, count, math.nan, math.nan, math.nan,
                    f"{count} sample{'s' * (count > 1)}, at least {MINIMUM_SAMPLES} are needed", longer_by(series))
    found = _slow(series)
    if found is None or not found.error:
        return Mean(value, 0.0, deviation, count, float(count), math.inf, 0.0)
    effective = (deviation / found.error) ** 2
    reason, lasts = "", count / found.memory
    if found.drifts:
        reason = "it drifts: its ends differ by more than it goes to and fro"
    elif lasts < MINIMUM_TIMES:
        reason = f"lasts {lasts:.3g} times its memory only, at least {MINIMUM_TIMES} are needed"
    longer = max(1.0, MINIMUM_TIMES / lasts) if reason else 1.0
    return Mean(value, found.error, deviation, count, effective, found.freedom, count / effective / 2, reason, longer,
                found.memory, found.drifts)


def ratio_with_error(above, below):
    """`Mean` of sum(above) / sum(below), two series [n] of one time, such as summed velocity over number.

    The error is that of the mean of (above - ratio below) / mean(below), the ratio to first order in its deviations
    (W. G. Cochran, Sampling Techniques, 1977, sec. 2.11), its autocorrelation taken in; unknown where most samples of `below` are
    empty and fewer than MINIMUM_SAMPLES are not. sum(below) = 0: ValueError.
    """
    above, below = numpy.asarray(above, dtype=float), numpy.asarray(below, dtype=float)
    if not below.sum():
        raise ValueError("ratio_with_error: the lower series is nothing but zeros")
    ratio = float(above.sum() / below.sum())
    filled = int(numpy.count_nonzero(below))
    if filled < min(MINIMUM_SAMPLES, len(below)):
        # The residuals of the empty samples are zeros that tell nothing: with one that is not empty, all are zero.
        return Mean(ratio, math.nan, math.nan, len(below), math.nan, math.nan, math.nan,
                    f"{filled} sample{'s' * (filled > 1)} that hold anything, at least {MINIMUM_SAMPLES} are needed",
                    MINIMUM_SAMPLES / filled)
    residual = above - ratio * below
    # What is round-off of the numerator alone is none of the ratio.
    residual[numpy.abs(residual) <= 1e-13 * numpy.abs(above).max(initial=0.0)] = 0.0
    return dataclasses.replace(mean_with_error(residual / below.mean()), value=ratio)


def quantile_with_error(counts, edges, level):
    """`Mean` of the quantile `level` (0 to 1) of all values of a series of histograms, counts [n, bins].

    Linear within a bin, so no finer than the bins. The error is half of what lies between the quantiles at level -
    error and level + error, the error being that of the share below the quantile (R. S. Woodruff, J. Am. Stat. Assoc.
    47 (1952) 635). No values at all: ValueError.
    """
    counts, edges = numpy.asarray(counts, dtype=float), numpy.asarray(edges, dtype=float)
    cumulative = numpy.concatenate([[0.0], counts.sum(axis=0).cumsum()])
    if not cumulative[-1]:
        raise ValueError("quantile_with_error: the histograms hold nothing")

    def quantile(share):
        share = min(max(share, 0.0), 1.0) * cumulative[-1]
        at = max(int(numpy.searchsorted(cumulative, share, side="left")), 1)
        part = (share - cumulative[at - 1]) / (cumulative[at] - cumulative[at - 1])
        return float(edges[at - 1] + part * (edges[at] - edges[at - 1]))

    value = quantile(level)
    at = min(max(int(numpy.searchsorted(edges, value, side="left")), 1), len(edges) - 1)
    part = (value - edges[at - 1]) / (edges[at] - edges[at - 1])
    share = ratio_with_error(counts[:, :at - 1].sum(axis=1) + part * counts[:, at - 1], counts.sum(axis=1))
    if math.isnan(share.error):
        return dataclasses.replace(share, value=value)
    error = (quantile(level + share.error) - quantile(level - share.error)) / 2
    return dataclasses.replace(share, value=value, error=error)


def deviation_with_error(values):
    """`Mean` of the standard deviation of a series [n], its error that of the mean square to first order.

    The mean that is taken off is the record's own, which makes the mean square less by that mean's variance: it is put back.
    Squares are skew: of a series that decays (AR(1)) 95 % bars cover 93 % in records of 100 times its memory, 83 to 86 % in 20 to 40 times; of
    oscillations they cover 91 to 94 % from 20 on.
    """
    values = numpy.asarray(values, dtype=float)
    mean = mean_with_error(values)
    square = mean_with_error((values - values.mean()) ** 2)
    if math.isnan(square.error):
        return dataclasses.replace(square, value=math.sqrt(square.value))
    root = math.sqrt(square.value + mean.error**2)
    reason = square.reason or mean.reason  # squares forget in half the time
    return dataclasses.replace(square, value=root, error=square.error / (2 * root) if root else 0.0, reason=reason,
                               longer=max(square.longer, mean.longer), memory=max(square.memory, mean.memory), drifts=mean.drifts or square.drifts)


def of_replicates(joined, parts):
    """The `Mean` of independent records, replicates, from that of all of them one after the other, `joined`, and that of each, `parts`; `joined` as it is where a part is None.

    Two errors are known: that of the joined record by its ups and downs, of many degrees of freedom, which knows no motion that is slower than a part; and that by the scatter of
    the parts (A. M. Law, W. D. Kelton, Simulation Modeling and Analysis, 1991, sec. 9.5.2), which has only one less than there are parts. The one with the longer 95 % bar is taken.
    By the first one alone bars of three parts of 1.8 s cover 76 % where a tenth of the variance has a memory of 3 s. By scatter, `reason` is empty: what the parts remember, of
    where they begin as well, is in it.
    """
    if len(parts) < 2 or any(part is None for part in parts):
        return joined
    scatter = float(error_by_scatter([part.value for part in parts], [part.samples for part in parts]))
    left = len(parts) - 1
    if not scatter or _bar(joined.error, joined.freedom) >= _bar(scatter, left):
        return joined
    effective = (joined.deviation / scatter) ** 2
    return dataclasses.replace(joined, error=scatter, freedom=float(left), effective=effective, time=joined.samples / effective / 2, reason="", longer=1.0, drifts=False)


def error_by_scatter(values, shares=None):
    """Standard error of the mean of independent values [n, ...], two or more, by how they differ; of the mean that is weighted with `shares` [n] where given."""
    values = numpy.asarray(values, dtype=float)
    weights = numpy.ones(len(values)) if shares is None else numpy.asarray(shares, dtype=float)
    weights = weights / weights.sum()
    centre = numpy.tensordot(weights, values, 1)
    return numpy.sqrt(numpy.tensordot(weights**2, (values - centre) ** 2, 1) * len(values) / (len(values) - 1))


def _bar(error, freedom):
    """Half of the 95 % bar."""
    return error * float(stats.t.isf(0.025, freedom))


def difference(a, b):
    """`MeanDifference` of two `Mean`s of independent series, by Welch's t test (Biometrika 34 (1947) 28)."""
    value = b.value - a.value
    error = math.hypot(a.error, b.error)
    if error == 0:
        same = value == 0
        return MeanDifference(value, 0.0, 0.0 if same else math.inf, 1.0 if same else 0.0, math.inf)
    freedom = error**4 / sum(m.error**4 / m.freedom for m in (a, b) if m.error > 0)
    ratio = value / error
    return MeanDifference(value, error, ratio, float(2 * stats.t.sf(abs(ratio), freedom)), freedom)
