# SPDX-License-Identifier: GPL-3.0-or-later
"""Bars of 95 % cover the truth in 95 % of records: decays, slugging beds, slow motions besides, at any sampling rate; what is too short is marked."""

import math
import unittest

import numpy
from scipy.signal import lfilter
from scipy.stats import t as student

import measured
from interphase import autoregression, time_statistics as statistics
from interphase.spectrum import power_spectrum, strongest_frequency
from interphase.start_up import truncation

RECORDS = 200
# Two binomial deviations of 95 % of 200 records beyond the 92 to 98 % that are asked for: 95 % of these are within.
LEAST, MOST = 92 - 3.1, 100.0


def coefficients(decay, period, interval):
    """Of an autoregressive series of this decay time [s] and, where it oscillates, period [s], at an interval [s]."""
    radius = math.exp(-interval / decay)
    return [radius] if period is None else [2 * radius * math.cos(2 * math.pi * interval / period), -(radius**2)]


def records(random, decay, period, interval, length, count=RECORDS):
    """[count, samples] of deviation about 1 and true mean 0, stationary."""
    samples, before = round(length / interval), round(12 * decay / interval) + 10
    noise = random.standard_normal((count, before + samples))
    found = lfilter([1], [1, *(-c for c in coefficients(decay, period, interval))], noise, axis=1)[:, before:]
    return found / found.std()


def cover(means, true):
    """Share [%] of `Mean`s whose 95 % bar holds the true value."""
    return 100 * numpy.mean([abs(each.value - true) <= student.ppf(0.975, each.freedom) * each.error for each in means])


class Means(unittest.TestCase):
    def check(self, name, found, true=0.0):
        share = cover(found, true)
        measured.above(self, f"95 % bars, {name}: records that they cover [%]", share, LEAST, "%", "92 to 98 % asked for, less two binomial deviations of 200")

    def test_a_decay_and_a_slugging_bed(self):
        """Decays and damped oscillations of 2 Hz at 20 Hz, over 20, 40 and 200 decay times or periods, whichever is the shorter."""
        random = numpy.random.default_rng(1)
        for decay, period in ((0.3, None), (0.3, 0.5), (2.0, 0.5), (10.0, 0.5)):
            for times in (20, 40, 200):
                of = f"decay {decay:g} s" + (f", period {period:g} s" if period else "") + f", {times} times as long, 20 Hz"
                self.check(of, map(statistics.mean_with_error, records(random, decay, period, 0.05, times * min(decay, period or decay))))

    def test_a_slow_motion_besides_the_slugs(self):
        """A tenth of the variance decays in 2 s, which makes 9/10 of the error; slugs that last hide none of it."""
        random = numpy.random.default_rng(2)
        for interval, decay in ((0.05, 0.5), (0.01, 0.5), (0.05, 5.0)):
            for length in (80, 200):
                both = records(random, decay, 0.5, interval, length) + math.sqrt(0.1) * records(random, 2.0, None, interval, length)
                self.check(f"slugs of {decay:g} s and a slow tenth, {length} s, {1 / interval:g} Hz", map(statistics.mean_with_error, both))

    def test_a_start_up_that_is_found_and_left_out(self):
        """Three and ten deviations off at first, settling in 1 s: bars of what MSER leaves of 60 s cover as those without a start-up."""
        random = numpy.random.default_rng(9)
        settling = numpy.exp(-0.05 * numpy.arange(1200))
        for by in (3, 10):
            rows = [each + by * settling for each in records(random, 0.5, 0.5, 0.05, 60)]
            left = [each[truncation(each):] for each in rows]
            self.check(f"slugs after a start-up of {by} deviations, found", map(statistics.mean_with_error, left))

    def test_replicates(self):
        """Of 1.8 s each, as tools/report --pool takes them: slugs of 3 Hz that ring 0.5 s, alone and beside slow motions, which the parts do not show by themselves."""
        random = numpy.random.default_rng(11)
        for parts in (3, 4, 8):
            slugs = records(random, 0.5, 1 / 3, 0.005, 1.8, RECORDS * parts)
            for share, decay in ((0.0, None), (0.1, 0.3), (0.1, 3.0), (0.5, 10.0)):
                both = slugs + math.sqrt(share / (1 - share)) * records(random, decay, None, 0.005, 1.8, RECORDS * parts) if share else slugs
                beside = f" beside {share:g} of the variance that decays in {decay:g} s" if share else ""
                self.check(f"{parts} times 1.8 s of slugs of 3 Hz{beside}", (self.replicated(each) for each in both.reshape(RECORDS, parts, -1)))

    def replicated(self, parts):
        return statistics.of_replicates(statistics.mean_with_error(parts.reshape(-1)), [statistics.mean_with_error(part) for part in parts])

    def test_replicates_that_agree_are_one_record(self):
        """Twelve decays of 50 times the memory: the joined record's bar is the shorter one in half of all draws or so; it is taken where it is the longer one."""
        random = numpy.random.default_rng(12)
        joined = 0
        for each in records(random, 0.3, None, 0.05, 15, 12 * 40).reshape(40, 12, -1):
            one = statistics.mean_with_error(each.reshape(-1))
            found = self.replicated(each)
            joined += found == one
            self.assertGreaterEqual(found.error * student.ppf(0.975, found.freedom), one.error * student.ppf(0.975, one.freedom) * (1 - 1e-12))
        self.assertTrue(8 <= joined <= 32, joined)  # 40 draws of about one half: +- 12 is 3.8 deviations

    def test_the_sampling_rate_does_not_matter(self):
        """The same records at 1 kHz and each 50th row of them: errors alike within a fifth of themselves, and in the mean within 3 %."""
        random = numpy.random.default_rng(3)
        ratios = []
        for fine in records(random, 0.4, 0.5, 0.001, 20, 30):
            ratios.append(statistics.mean_with_error(fine).error / statistics.mean_with_error(fine[::50]).error)
        self.assertLess(numpy.std(ratios), 0.2)
        self.assertAlmostEqual(numpy.mean(ratios), 1, delta=0.03 + 2 * numpy.std(ratios) / math.sqrt(30))

    def test_deviations_ratios(self):
        random = numpy.random.default_rng(4)
        series = records(random, 0.5, 0.5, 0.05, 50)
        self.check("deviation of slugs, 100 times as long", map(statistics.deviation_with_error, series), 1.0)
        number = 100 + 20 * records(random, 0.3, None, 0.05, 30)
        velocity = 0.3 + 0.1 * records(random, 0.3, None, 0.05, 30)
        self.check("ratio of two series, 100 times as long", map(statistics.ratio_with_error, number * velocity, number), 0.3)

    def test_what_is_too_short_is_marked(self):
        """Missed marks of records of 10 memories, false ones of records of 60: at most a quarter, and 3 in 100.

        An even oscillation is no reason for a mark however long it rings: its mean is known after 20 periods."""
        random = numpy.random.default_rng(5)
        for decay, period in ((0.5, None), (0.5, 0.5), (20.0, 0.5)):
            for times, wanted in ((10, True), (60, False)):
                memory = autoregression.memory(numpy.array(coefficients(decay, period, 0.05))) * 0.05
                marked = [bool(statistics.mean_with_error(each).reason) for each in records(random, decay, period, 0.05, times * memory)]
                wrong = 100 * numpy.mean([each != wanted for each in marked])
                with self.subTest(decay=decay, period=period, times=times):
                    self.assertLessEqual(wrong, 25 if wanted else 3)

    def test_a_drift_is_said(self):
        """A line by four of its deviations through a slugging record of 60 s; none is seen in 198 of 200 without (one in a thousand each)."""
        random = numpy.random.default_rng(6)
        steady = records(random, 0.5, 0.5, 0.05, 60)
        drifts = [statistics.mean_with_error(each + numpy.linspace(0, 4, len(each))).drifts for each in steady]
        self.assertGreater(sum(drifts), 195)
        self.assertLess(sum(statistics.mean_with_error(each).drifts for each in steady), 3)


class Spectra(unittest.TestCase):
    def test_bands_cover_a_known_spectrum(self):
        """95 % of values, apart from the slow end, where it bends within the resolution."""
        random, interval = numpy.random.default_rng(7), 0.05
        phi = numpy.array(coefficients(0.3, None, interval))
        inside = []
        for series in random.standard_normal((100, 1200)):
            series = lfilter([1], [1, *-phi], series)[200:]
            found = power_spectrum(interval * numpy.arange(len(series)), series)
            true = 2 * interval * autoregression.gain(phi, found.frequency * interval)
            inside.append(((found.low < true) & (true < found.high))[found.frequency > found.resolution])
        # 100 records of some 60 independent bands: 0.3 %
        measured.within(self, "spectrum: values of a known one within the 95 % band [%]", 100 * numpy.mean(inside), 95, 1.5, "%", "autoregressive series")

    def test_the_strongest_frequency(self):
        """An oscillation of 2 Hz in noise: found, within two of its errors in some 95 % of 40; a decay alone has none."""
        random, interval = numpy.random.default_rng(8), 0.05
        time = interval * numpy.arange(600)
        phi = numpy.array(coefficients(1.0, 0.5, interval))
        at = numpy.linspace(0.5, 5, 9001)
        true = at[autoregression.gain(phi, at * interval).argmax()]
        found = [strongest_frequency(time, each + 0.5 * random.standard_normal(600)) for each in records(random, 1.0, 0.5, interval, 30, 40)]
        self.assertTrue(all(not each.reason for each in found))
        self.assertGreaterEqual(sum(abs(each.value - true) < 2 * each.error for each in found), 35)  # binomial: 38 +- 1.4
        self.assertTrue(all(math.isnan(each.rival) for each in found))
        none = [strongest_frequency(time, each) for each in records(random, 0.3, None, interval, 30, 40)]
        self.assertGreaterEqual(sum("no peak" in each.reason for each in none), 37)

    def test_of_two_peaks_alike_neither_is_told_to_be_the_strongest(self):
        """1.5 and 3 Hz of one power and width: the choice is chance, its error holds both, and few pairs of 60 records are called different."""
        random, interval = numpy.random.default_rng(10), 0.05
        time = interval * numpy.arange(600)
        both = sum(records(random, 1.0, 1 / frequency, interval, 30, 60) for frequency in (1.5, 3.0))
        found = [strongest_frequency(time, each + 0.3 * random.standard_normal(600)) for each in both]
        values, errors = (numpy.array([getattr(each, what) for each in found]) for what in ("value", "error"))
        self.assertTrue(any(values < 2) and any(values > 2.5))
        self.assertGreaterEqual(sum(math.isfinite(each.rival) for each in found), 46)  # of 100 it was 89, three binomial deviations of 60 are 7
        told = [abs(a - b) > 2 * math.hypot(d, e) for a, d in zip(values, errors) for b, e in zip(values, errors)]
        self.assertLess(numpy.mean(told), 0.08)  # of 100 records 4.4 %
