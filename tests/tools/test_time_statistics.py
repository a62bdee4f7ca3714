# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of means are the true ones. statsmodels is the judge: of Burg's recursion, of what a model says, of the true error of a series."""

import math
import unittest

import numpy
from scipy.stats import t as student
from statsmodels.regression import linear_model
from statsmodels.tsa.arima_process import ArmaProcess

import measured
from interphase import autoregression, time_statistics as statistics
from interphase.spectrum import power_spectrum, strongest_frequency
from made_up import correlated, steady

# Period 10, decay 20 samples: a slugging bed at 20 Hz.
SLUGGING = (2 * math.exp(-1 / 20) * math.cos(2 * math.pi / 10), -math.exp(-1 / 10))
MODELS = ((), (0.9,), SLUGGING, (1.6, -0.63))  # the last has two times, roots 0.9 and 0.7


def process(phi, noise=1.0):
    """statsmodels' autocovariances of x_t = sum phi_k x_(t-k) + noise of this variance, a function of how many."""
    return lambda lags: noise * ArmaProcess([1, *(-p for p in phi)], [1]).acovf(lags)


def true_error(phi, count):
    """Of the mean of `count` samples: variance = sum over all pairs of their autocovariance, over count^2."""
    covariance = process(phi)(count)
    lags = numpy.arange(1, count)
    return math.sqrt((covariance[0] + 2 * ((1 - lags / count) * covariance[1:]).sum()) / count)


class BesideStatsmodels(unittest.TestCase):
    def test_the_recursion_has_the_same_coefficients(self):
        random = numpy.random.default_rng(11)
        for phi in MODELS:
            for count in (30, 500):
                series = correlated(random, phi, count)
                series -= series.mean()
                orders = dict(enumerate(autoregression.burg(series, 8)))
                self.assertEqual(len(orders), 9)
                for order in range(1, 9):
                    with self.subTest(phi=phi, count=count, order=order):
                        theirs, noise = linear_model.burg(series, order, demean=False)
                        numpy.testing.assert_allclose(orders[order][0], theirs, rtol=0, atol=1e-12)  # round-off of sums over 500
                        # Theirs is the mean square of the residuals of what is left after each order, ours keeps the variance that
                        # the coefficients imply; `order` samples of `count` are between them.
                        self.assertAlmostEqual(orders[order][1] / noise, 1, delta=4 * order / count)

    def test_a_model_s_spectrum_and_memory(self):
        """The spectrum is the sum of the autocovariances; a decay remembers for its time, an oscillation for its period if that is the shorter."""
        for phi in MODELS[1:]:
            covariance, lags = process(phi, 2.5)(2000), numpy.arange(1, 2000)
            for frequency in (0, 0.05, 0.3):
                sum_of = covariance[0] + 2 * (covariance[1:] * numpy.cos(2 * numpy.pi * frequency * lags)).sum()
                self.assertAlmostEqual(2.5 * autoregression.gain(numpy.array(phi), [frequency])[0] / sum_of, 1, delta=1e-9)
        self.assertEqual(autoregression.memory([]), 0)
        self.assertAlmostEqual(autoregression.memory([0.9]), -1 / math.log(0.9), delta=1e-9)
        # The oscillation's two parts, period 10 and decay 20, are each half of it, and a little more as it begins level.
        self.assertAlmostEqual(autoregression.memory(SLUGGING), 1 / math.hypot(1 / 20, 1 / 10), delta=0.1)
        self.assertAlmostEqual(autoregression.longest_decay(SLUGGING), 20, delta=1e-9)

    def test_the_spectrum_at_frequency_zero(self):
        """S(0) = noise/(1 - sum phi)^2, which the error of a mean is made of, is the limit of n times the variance of the mean."""
        for phi in MODELS:
            self.assertAlmostEqual(true_error(phi, 100000) * math.sqrt(100000) * (1 - sum(phi)), 1, delta=1e-3)


class MeanAndItsError(unittest.TestCase):
    """Against series whose error of the mean statsmodels knows.

    An estimate of S(0) of B degrees of freedom scatters by sqrt(2 / B), the error of the mean by
    half of that: 25 % at B = 8. 200 series know the root mean square of it to 1.8 %; 8 % leaves room for its bias.
    """

    def check(self, phi, count, bias=0.08):
        random = numpy.random.default_rng(20)
        true = true_error(phi, count)
        errors, inside, marked = [], 0, 0
        for _ in range(200):
            mean = statistics.mean_with_error(correlated(random, phi, count))
            marked += bool(mean.reason)
            errors.append(mean.error / true)
            inside += abs(mean.value) < student.ppf(0.95, mean.freedom) * mean.error
        of = f"records of autoregression {[round(p, 3) for p in phi]}, {count} samples: "
        measured.within(self, of + "stated error of the mean over the true one", math.sqrt(numpy.mean(numpy.square(errors))), 1, bias, "", "statsmodels")
        self.assertLess(marked, 6)  # of 200: a drift is seen by chance in one of a thousand
        # 90 % intervals: 180 of 200 +- 4.2 if exact; 168 allows for bias and 2 standard deviations.
        measured.above(self, of + "means of 200 within their 90 % interval", inside, 168, "", "180 expected, +- 4.2")

    def test_white_noise(self):
        self.check([], 500)

    def test_slow_decay(self):
        self.check([0.9], 2000)  # 105 independent samples

    def test_damped_oscillation(self):
        self.check(SLUGGING, 1000)  # sums of the autocorrelation cut off early fail here

    def test_two_time_scales(self):
        self.check([1.6, -0.63], 2000)  # roots 0.9 and 0.7

    def test_series_that_no_autoregression_made(self):
        # Running means over 10: S(0) is the noise's, 1.
        random = numpy.random.default_rng(3)
        errors = []
        for _ in range(100):
            x = numpy.convolve(random.standard_normal(4000), numpy.ones(10) / 10, "valid")
            errors.append(statistics.mean_with_error(x).error * math.sqrt(len(x)))
        self.assertAlmostEqual(numpy.mean(errors), 1, delta=0.1)

    def test_long_fine_series(self):
        # 40,000 samples, autocorrelation time 200: 100 independent samples, far more lags than coefficients.
        random = numpy.random.default_rng(4)
        phi = 1 - 1 / 200
        errors = []
        for _ in range(50):
            mean = statistics.mean_with_error(correlated(random, [phi], 40000))
            errors.append(mean.error * (1 - phi) * math.sqrt(40000))
        self.assertAlmostEqual(numpy.mean(errors), 1, delta=0.1)

    def test_autocorrelation_time(self):
        mean = statistics.mean_with_error(correlated(numpy.random.default_rng(1), [0.9], 100000))
        # 64 degrees of freedom: known to 18 %; two of these.
        self.assertAlmostEqual(mean.time / (0.5 * 1.9 / 0.1), 1, delta=0.36)
        self.assertAlmostEqual(mean.effective * 2 * mean.time / 100000, 1, delta=1e-9)
        # One record of 420 memories knows it to 30 % (22 degrees of freedom), 41 of them their median to 6; it is the larger of two estimates.
        random = numpy.random.default_rng(1)
        found = [statistics.mean_with_error(correlated(random, [0.9], 4000)).memory for _ in range(41)]
        self.assertAlmostEqual(numpy.median(found) * -math.log(0.9), 1, delta=0.2)

    def test_too_short_or_drifting_is_said(self):
        random = numpy.random.default_rng(2)
        self.assertIn("19 samples", statistics.mean_with_error(random.standard_normal(19)).reason)
        ramp = numpy.linspace(0, 1, 500) + 0.01 * random.standard_normal(500)
        self.assertIn("drifts", statistics.mean_with_error(ramp).reason)
        refused = sum(bool(statistics.mean_with_error(correlated(random, [0.98], 200)).reason) for _ in range(100))
        self.assertGreater(refused, 85)  # two independent samples only

    def test_constants_and_nonsense(self):
        mean = statistics.mean_with_error(numpy.full(100, 0.1))
        self.assertEqual((mean.error, mean.reason), (0.0, ""))
        self.assertAlmostEqual(mean.value, 0.1, places=15)
        for bad in ([], [math.nan], [[1.0]]):
            with self.assertRaises(ValueError):
                statistics.mean_with_error(bad)

    def test_false_alarms_are_as_rare_as_stated(self):
        random = numpy.random.default_rng(6)
        alarms = 0
        for _ in range(400):
            pair = [statistics.mean_with_error(correlated(random, [0.8], n)) for n in (1000, 3000)]
            alarms += statistics.difference(*pair).chance < 0.05
        # 5 % of 400, binomial deviation 4.4
        measured.below(self, "tools/compare --statistics: false alarms at 95 %, 400 pairs of correlated records of one mean", alarms, 20 + 3 * 4.4, "",
                       "20 expected")


class OfRatiosAndQuantiles(unittest.TestCase):
    def test_a_ratio_and_its_error(self):
        """Over 150 records, the true ratio lies within 2 standard errors in some 95 %."""
        inside = 0
        for seed in range(150):
            number = 100 + 20 * steady(400, 0.8, 3 * seed)
            velocity = 0.3 + 0.1 * steady(400, 0.8, 3 * seed + 1)
            found = statistics.ratio_with_error(number * velocity, number)
            inside += abs(found.value - 0.3) < 2 * found.error
        self.assertGreater(inside / 150, 0.88)
        self.assertLess(inside / 150, 0.99)

    def test_a_ratio_that_never_changes_has_no_error(self):
        number = numpy.random.default_rng(1).integers(0, 50, 100)
        found = statistics.ratio_with_error(0.3 * number, number)
        self.assertAlmostEqual(found.value, 0.3, delta=1e-12)
        self.assertLess(found.error, 1e-12)
        with self.assertRaises(ValueError):
            statistics.ratio_with_error(numpy.zeros(30), numpy.zeros(30))

    def test_what_is_seen_in_few_samples_has_no_error(self):
        """One sphere that crosses a window once in 75 snapshots has a velocity, but no error, least of all 0."""
        number = numpy.zeros(75)
        number[40] = 1
        found = statistics.ratio_with_error(0.7 * number, number)
        self.assertAlmostEqual(found.value, 0.7)
        self.assertTrue(math.isnan(found.error))
        self.assertIn("1 sample that hold anything", found.reason)
        self.assertTrue(math.isnan(statistics.mean_with_error([3.0]).error))

    def test_a_quantile_and_its_error(self):
        """Values uniform between 0 and 1 plus a shift common to each snapshot: the quantile moves with the shift's mean."""
        edges, random, inside = numpy.linspace(-3, 4, 1401), numpy.random.default_rng(5), 0
        for seed in range(50):
            shifts = 0.1 * steady(200, 0.6, seed)
            values = random.uniform(0, 1, (200, 400)) + shifts[:, None]
            counts = [numpy.histogram(row, edges)[0] for row in values]
            found = statistics.quantile_with_error(counts, edges, 0.5)
            self.assertAlmostEqual(found.value, numpy.median(values), delta=0.006)
            inside += abs(found.value - 0.5) < 2 * found.error
        self.assertGreater(inside, 42)

    def test_a_quantile_of_few_snapshots_has_no_error(self):
        found = statistics.quantile_with_error([[0, 10, 10, 0], [0, 11, 9, 0], [0, 9, 11, 0]], [0, 1, 2, 3, 4], 0.75)
        self.assertAlmostEqual(found.value, 2.5)
        self.assertTrue(math.isnan(found.error) and found.reason)

    def test_the_spectrum_peaks_at_the_frequency_and_holds_the_variance(self):
        time = numpy.arange(0, 50, 0.05)
        found = power_spectrum(time, 200 * numpy.sin(2 * numpy.pi * 1.6 * time))
        frequency, power = found.frequency, found.power
        self.assertLess(abs(frequency[power.argmax()] - 1.6), found.resolution / 2)
        self.assertAlmostEqual(power.sum() * (frequency[1] - frequency[0]), 200**2 / 2, delta=0.02 * 200**2 / 2)
        self.assertIsNone(power_spectrum(time[:100], time[:100]))
