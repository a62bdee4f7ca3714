# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of the tools are tried on: random series, and how hypothesis draws its examples."""

import math

import hypothesis
import numpy
from scipy.signal import lfilter

# The same examples in every run, and no time limit: a machine may be slow, a test that fails now and then is none.
hypothesis.settings.register_profile("interphase", derandomize=True, deadline=None, max_examples=50, database=None)
hypothesis.settings.load_profile("interphase")


def correlated(random, phi, count):
    """x_t = sum phi_k x_(t-k) + white noise of variance 1, in its stationary state; S(0) = 1 / (1 - sum phi)^2."""
    return lfilter([1], [1, *(-p for p in phi)], random.standard_normal(count + 4000))[4000:]


def steady(samples, memory, seed):
    """An autoregressive series of deviation 1: x_t = memory x_(t-1) + noise."""
    noise = numpy.random.default_rng(seed).normal(0, math.sqrt(1 - memory**2), samples + 1000)
    return lfilter([1], [1, -memory], noise)[1000:]


def scattered(count, size, seed=1):
    """Points [count, 3] anywhere in a box of `size` [3] at the origin."""
    return numpy.random.default_rng(seed).uniform(0, 1, (count, 3)) * size
