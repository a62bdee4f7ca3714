# SPDX-License-Identifier: GPL-3.0-or-later
"""The power spectrum of a series with its band, and the strongest frequency with its error."""

import math
from dataclasses import dataclass

import numpy
from scipy import signal, stats

from interphase import autoregression

FEWEST_SAMPLES = 128
TAPERS = 7
HALF_BANDWIDTH = (TAPERS + 1) / 2  # over the record: power within it of a frequency goes into its value
COVERAGE = 0.95
LONGEST = 4096  # averages of neighbours that a frequency is looked for in
FALSE_PEAKS = 0.005  # how often a record without any oscillation has one
COPIES = 60  # by which the scatter of a frequency is known to 9 %
APART = 1.5  # frequencies whose ratio is above that are two
RIVAL = 0.01  # chance of a peak that is higher by so much where two are alike, of one band each


@dataclass(frozen=True)
class Spectrum:
    """One-sided `power` density [unit^2/Hz] at `frequency` [m], Hz; the true one lies between `low` and `high` with 95 % each.
    Values closer together than `resolution` [Hz] depend on each other."""

    frequency: numpy.ndarray
    power: numpy.ndarray
    low: numpy.ndarray
    high: numpy.ndarray
    resolution: float


@dataclass(frozen=True)
class StrongestFrequency:
    """`value` [Hz] and its standard `error`; NaN where no peak stands out, and `reason` says so. `rival` [Hz]: of another peak that may be the higher one, as far as
    the record tells; NaN where there is none."""

    value: float
    error: float
    reason: str = ""
    rival: float = math.nan


def _power(values, tapers):
    """One-sided, per cycle per sample, at the frequencies 1/n, 2/n, ..., of the series [..., n]."""
    values = values - values.mean(axis=-1, keepdims=True)
    power = numpy.zeros(values.shape[:-1] + (values.shape[-1] // 2,))
    for taper in tapers:
        power += numpy.abs(numpy.fft.rfft(values * taper, axis=-1)[..., 1:]) ** 2
    power *= 2 / len(tapers)
    if values.shape[-1] % 2 == 0:
        power[..., -1] /= 2  # it has no negative twin
    return power


def _tapers(count):
    return math.sqrt(2 / (count + 1)) * numpy.sin(numpy.pi * numpy.outer(numpy.arange(1, TAPERS + 1), numpy.arange(1, count + 1)) / (count + 1))


def _interval(times):
    return (times[-1] - times[0]) / (len(times) - 1)


def power_spectrum(times, values):
    """The `Spectrum` of a series [n] at evenly spaced `times` [s]; None below FEWEST_SAMPLES.

    D. J. Thomson's multitaper estimate (Proc. IEEE 70 (1982) 1055) with seven sine tapers (K. S. Riedel, A. Sidorenko, IEEE Trans.
    Signal Process. 43 (1995) 188), whose estimates are independent: power over truth is chi-square of 14 degrees of freedom over 14,
    where the truth changes little within the resolution.
    """
    count = len(values)
    if count < FEWEST_SAMPLES:
        return None
    interval = _interval(times)
    power = interval * _power(numpy.asarray(values, dtype=float), _tapers(count))
    low, high = (2 * TAPERS / stats.chi2.ppf((1 + side * COVERAGE) / 2, 2 * TAPERS) for side in (1, -1))
    return Spectrum(numpy.arange(1, len(power) + 1) / (count * interval), power, low * power, high * power, 2 * HALF_BANDWIDTH / (count * interval))


def strongest_frequency(times, values):
    """The `StrongestFrequency` of a series [n] at evenly spaced `times` [s].

    A peak stands out where the spectrum is above that of a series with one decay time (an autoregressive model of order 1 with the
    same variance and neighbours) by more than one such series in two hundred goes anywhere (M. E. Mann, J. M. Lees, Clim. Change 33
    (1996) 409). Its frequency is the mean frequency of the power about the largest value, as far as that is above half of it. The error is the
    scatter of the same number in COPIES series of the autoregressive model that fits the record. Where another peak stands out, too, whose power is not told from the
    highest one's (Fisher's F of 14 and 14 degrees of freedom), which of them is the highest is chance, such as of a slug's frequency and its double: half of
    what is between them is in the error then.
    """
    if len(values) < FEWEST_SAMPLES:
        return StrongestFrequency(math.nan, math.nan, f"{len(values)} samples, at least {FEWEST_SAMPLES} are needed")
    block = -(-len(values) // LONGEST)
    blocks = len(values) // block
    series = numpy.asarray(values, dtype=float)[len(values) - block * blocks:].reshape(blocks, block).mean(axis=1)
    series = series - series.mean()
    if not series.any():
        return StrongestFrequency(math.nan, math.nan, "the series is constant")
    tapers = _tapers(blocks)
    power, frequency = _power(series, tapers), numpy.arange(1, blocks // 2 + 1) / blocks
    variance = float(series.var())
    neighbours = float(series[1:] @ series[:-1]) / float(series @ series)
    decay = variance * (1 - neighbours**2) * 2 * autoregression.gain(numpy.array([neighbours]), frequency)
    # Bands apart by the resolution are independent; a maximum over the ones between them is about twice as many.
    bands = 2 * blocks / (4 * HALF_BANDWIDTH)
    limit = decay * stats.chi2.isf(FALSE_PEAKS / bands, 2 * TAPERS) / (2 * TAPERS)
    # What is within the bandwidth of zero is a drift or the mean.
    standing = numpy.flatnonzero((power > limit) & (frequency > HALF_BANDWIDTH / blocks))
    if not len(standing):
        return StrongestFrequency(math.nan, math.nan, "no peak stands out of the spectrum of a series that only decays")
    peak = standing[power[standing].argmax()]
    sampling = 1 / (block * _interval(times))
    found = _centre(power, frequency, peak)
    phi, noise = autoregression.fitted(series)
    random = numpy.random.default_rng(0)  # the same error at each call
    burn = min(int(10 * autoregression.longest_decay(phi)) + 100, 10 * blocks)
    copies = signal.lfilter([1], [1, *-phi], math.sqrt(noise) * random.standard_normal((COPIES, burn + blocks)), axis=1)[:, burn:]
    near = numpy.abs(numpy.log(frequency / found)) < math.log(APART)  # another peak is another frequency
    centres = []
    for each in _power(copies, tapers):
        centres.append(_centre(each, frequency, int(numpy.where(near, each, 0).argmax())))
    error = float(numpy.std(centres, ddof=1))
    least = power[peak] / stats.f.isf(RIVAL, 2 * TAPERS, 2 * TAPERS)
    others = [(power[at], centre) for at in standing if not near[at] and power[at] > least
              and abs(math.log((centre := _centre(power, frequency, at)) / found)) >= math.log(APART)]  # else one broad peak
    if not others:
        return StrongestFrequency(found * sampling, error * sampling)
    rival = max(others)[1]
    return StrongestFrequency(found * sampling, math.hypot(error, (rival - found) / 2) * sampling, rival=rival * sampling)


def _centre(power, frequency, peak):
    """The mean frequency of the power about the index `peak`, as far as half of its value."""
    below = numpy.flatnonzero(power < power[peak] / 2)
    at = numpy.searchsorted(below, peak)
    first = below[at - 1] + 1 if at > 0 else 0
    last = below[at] if at < len(below) else len(power)
    return float(power[first:last] @ frequency[first:last] / power[first:last].sum())
