# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of the tools are tried on: random series, and how hypothesis draws its examples."""

import hypothesis
from scipy.signal import lfilter

# The same examples in every run, and no time limit: a machine may be slow, a test that fails now and then is none.
hypothesis.settings.register_profile("interphase", derandomize=True, deadline=None, max_examples=50, database=None)
hypothesis.settings.load_profile("interphase")


def correlated(random, phi, count):
    """x_t = sum phi_k x_(t-k) + white noise of variance 1, in its stationary state; S(0) = 1 / (1 - sum phi)^2."""
    return lfilter([1], [1, *(-p for p in phi)], random.standard_normal(count + 4000))[4000:]
