# SPDX-License-Identifier: GPL-3.0-or-later
"""Autoregressive models of a series: their fit, their spectrum, and for how long they remember."""

import math

import numpy


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


def fitted(series):
    """(phi, variance of the noise) of the order with the least Akaike criterion (IEEE Trans. Autom. Control 19 (1974) 716), of a
    series [n] of mean zero that is no constant: the order that tells the spectrum best."""
    return _fitted(series, 2.0)


def surely_fitted(series):
    """The same by the criterion of G. Schwarz (Ann. Stat. 6 (1978) 461), which takes no coefficient that chance may have made: Akaike's would give
    white noise of 100 samples a memory of more than 5 in 9 of 100 records."""
    return _fitted(series, math.log(len(series)))


def _fitted(series, penalty):
    count = len(series)
    best = None
    for phi, noise in burg(series, min(int(10 * math.log10(count)), count // 4)):
        if noise <= 0:
            break
        criterion = count * math.log(noise) + penalty * len(phi)
        if best is None or criterion < best[0]:
            best = criterion, phi, noise
    return best[1:]


def gain(phi, frequency):
    """|1 / (1 - sum phi_k exp(-2 pi i f k))|^2 at `frequency` [m], cycles per sample: the two-sided spectrum for noise of variance 1."""
    lags = numpy.arange(1, len(phi) + 1)
    return 1 / numpy.abs(1 - numpy.exp(-2j * numpy.pi * numpy.outer(frequency, lags)) @ phi) ** 2


def _roots(phi):
    """Poles of a model, those that forget at once left out, within the unit circle by a hair at least."""
    roots = numpy.roots(numpy.concatenate([[1.0], -numpy.asarray(phi)])) if len(phi) else numpy.zeros(0)
    return roots[numpy.abs(roots) > 1e-12]


def _decay_times(roots):
    return -1 / numpy.log(numpy.minimum(numpy.abs(roots), 1 - 1e-9))


def longest_decay(phi):
    """For how many samples the slowest part of a model rings, in e-folding times."""
    return float(_decay_times(_roots(phi)).max(initial=0.0))


def memory(phi):
    """For how many samples a model's mean remembers: sum |a_k| T_k, its autocorrelation being the sum of a_k exp(-lag/tau_k) e^(i omega_k lag)
    and 1/T_k^2 = 1/tau_k^2 + (omega_k / 2 pi)^2.

    Of one decay that is the integral autocorrelation time. Of an oscillation, whose integral cancels, it is the period where that is shorter
    than the envelope's decay: a few periods show what its mean does, however long it rings. |a_k| is at most 1: of two times that are nearly one the
    parts are large and opposed.
    """
    roots = _roots(phi)
    if not len(roots):
        return 0.0
    parts = numpy.empty(len(roots), dtype=complex)
    with numpy.errstate(all="ignore"):  # roots that are equal to the last bit
        for k, root in enumerate(roots):
            parts[k] = root ** (len(phi) - 1) / (numpy.prod(root - numpy.delete(roots, k)) * numpy.prod(1 - root * roots))
        share = numpy.minimum(numpy.nan_to_num(numpy.abs(parts / parts.sum().real), nan=1.0), 1.0)
    return float((share / numpy.hypot(1 / _decay_times(roots), numpy.angle(roots) / (2 * math.pi))).sum())
