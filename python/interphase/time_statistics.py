# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean of a correlated series with its standard error, and the comparison of two such means.

Successive samples of a flow depend on each other: the error of their mean is not s / sqrt(n) but
sqrt(S(0) / n), S(0) being the spectral density at frequency zero, the sum of all autocovariances. We take S(0)
from an autoregressive model of the series (K. N. Berk, Ann. Stat. 2 (1974) 489), fitted by Burg's recursion
and its order chosen by Akaike's criterion (IEEE Trans. Autom. Control 19 (1974) 716). M. B. Thompson
(arXiv:1011.0175) finds this the most accurate of the usual ways to the autocorrelation time. Two others were tried:
automatic block averaging (Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989) 461, the block by Jonsson, Phys. Rev. E
98 (2018) 043304) gave errors too small by 14 to 50 % on records of 400 to 20 autocorrelation times;
windowed sums of the autocorrelation function can turn negative on the damped oscillations of a slugging bed.
"""

import dataclasses
import math
from dataclasses import dataclass

import numpy
from scipy import stats

MINIMUM_SAMPLES = 20
MINIMUM_FREEDOM = 4.0
LONGEST_FITTED = 4096
FEWEST_FITTED = 8  # samples of which a model of two coefficients can be made


@dataclass(frozen=True)
class Mean:
    """A mean and how well it is known.

    `error` is the standard error, in units of the series; `freedom` the degrees of freedom of that estimate, for
    Student's t; `effective` the number of independent samples that would know the mean as well; `time` the
    integral autocorrelation time 1/2 + sum of the autocorrelation function, in samples (1/2: uncorrelated).
    `reason` is empty, or says why the error is not to be trusted; `longer` then is how many times longer the record must be,
    about (`longer_by`).
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


@dataclass(frozen=True)
class MeanDifference:
    """`value` = b - a, its standard error, the ratio of both, and the chance of a larger ratio if a = b."""

    value: float
    error: float
    ratio: float
    chance: float
    freedom: float


def burg(series, longest):
    """Autoregressive models x_t = sum_k phi_k x_(t-k) + noise of orders 0 ... `longest` of a series of mean zero.

    Yields (phi, variance of the noise) for each order. J. P. Burg's recursion (Stanford thesis, 1975), which stays
    stable near the unit circle, where the Yule-Walker equations are biased.
    """
    forward = numpy.array(series, dtype=float)
    backward = forward.copy()
    noise = float(numpy.mean(forward**2))
    phi = numpy.zeros(0)
    yield phi, noise
    for _ in range(longest):
        forward, backward = forward[1:], backward[:-1]
        scale = float(forward @ forward + backward @ backward)
        if scale <= 0 or noise <= 0:
            return
        reflection = 2 * float(forward @ backward) / scale
        phi = numpy.append(phi - reflection * phi[::-1], reflection)
        noise *= 1 - reflection**2
        forward, backward = forward - reflection * backward, backward - reflection * forward
        yield phi, noise


def _autoregressive(series):
    """(phi, noise) of the order with the least Akaike criterion."""
    count = len(series)
    best = None
    for phi, noise in burg(series, min(int(10 * math.log10(count)), count // 4)):
        if noise <= 0:
            break
        criterion = count * math.log(noise) + 2 * len(phi)
        if best is None or criterion < best[0]:
            best = criterion, phi, noise
    _, phi, noise = best
    return phi, noise * count / (count - len(phi) - 1)  # the fit has taken the mean and phi


def _autocovariances(phi, noise):
    """Autocovariances of lags 0 ... p - 1 of the model itself, by the Yule-Walker equations."""
    order = len(phi)
    system = numpy.eye(order + 1)
    for row in range(order + 1):
        for lag, factor in enumerate(phi, 1):
            system[row, abs(row - lag)] -= factor
    right = numpy.zeros(order + 1)
    right[0] = noise
    return numpy.linalg.solve(system, right)[:order]


def _error(series):
    """(standard error of the mean, its degrees of freedom) of a series that is no constant; None where averages of its
    neighbours are one."""
    count = len(series)
    # Averages of neighbours keep the mean and S(0), and let a model of few coefficients reach further back.
    block = -(-count // LONGEST_FITTED)
    blocks = count // block
    fitted = series[count - blocks * block:].reshape(blocks, block).mean(axis=1)
    fitted = fitted - fitted.mean()
    if not fitted.any():
        return None
    phi, noise = _autoregressive(fitted)
    gain = 1 - float(phi.sum())
    error = math.sqrt(noise / blocks) / gain
    scatter = 2 / blocks
    if len(phi):
        ones = numpy.ones(len(phi))
        covariances = _autocovariances(phi, noise)
        matrix = covariances[numpy.abs(numpy.subtract.outer(numpy.arange(len(phi)), numpy.arange(len(phi))))]
        scatter += 4 / gain**2 * noise / blocks * float(ones @ numpy.linalg.solve(matrix, ones))
    return error, max(2 / scatter - 1, 0.0)


def _worth(series):
    """(independent samples, degrees of freedom) as the record itself shows them, however few; zeros where it cannot."""
    series = numpy.asarray(series, dtype=float)
    deviation = float(series.std(ddof=1)) if len(series) > 1 else 0.0
    if deviation <= 1e-14 * float(numpy.abs(series).max(initial=0.0)):
        return float(len(series)), math.inf
    if len(series) < FEWEST_FITTED:
        return 0.0, 0.0
    found = _error(series)
    return (0.0, 0.0) if found is None else ((deviation / found[0]) ** 2, found[1])


def worth(series):
    """How many independent samples a record [n] is surely worth, a whole number that may be 0, not above n.

    A record that is too short for the error of its mean may still be worth a few: as many as its autoregressive model
    says, and no more than twice its degrees of freedom, which are about half as many in an AR(1) series, allow. Two are
    taken off for the mean and the drift that a record shorter than its motions takes for a part of itself.
    """
    effective, freedom = _worth(series)
    return max(int(min(effective, 2 * (freedom + 1), len(series))) - 2, 0)


def longer_by(series):
    """How many times longer a record must be for its mean to have an error, about; at least 1.

    As far as the record shows: motions slower than itself make it more.
    """
    effective, freedom = _worth(series)
    by = [1.0, MINIMUM_SAMPLES / len(series)]
    if effective:
        by += [2 * MINIMUM_FREEDOM / effective, (MINIMUM_FREEDOM + 1) / (freedom + 1)]
    return max(by)


def mean_with_error(series):
    """`Mean` of a stationary series [n] at even spacing, its autocorrelation taken in. NaN or empty: ValueError.

    The estimate of S(0) itself scatters; the delta method on the coefficients' covariance, noise / n times the
    inverse of the autocovariance matrix, gives its degrees of freedom, 2 / (relative variance).
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
    found = _error(series)
    if found is None:
        return Mean(value, 0.0, deviation, count, float(count), math.inf, 0.0)
    error, freedom = found
    effective = (deviation / error) ** 2
    reason = ""
    if effective < 2 * MINIMUM_FREEDOM:
        reason = f"worth {effective:.2g} independent samples only: it drifts, or is too short for its slow motion"
    elif freedom < MINIMUM_FREEDOM:
        reason = (f"too short for its autocorrelation to be known: the error has {freedom:.2g} degrees of freedom, "
                  f"at least {MINIMUM_FREEDOM:g} are needed")
    longer = longer_by(series) if reason else 1.0
    return Mean(value, error, deviation, count, effective, freedom, count / effective / 2, reason, longer)


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
