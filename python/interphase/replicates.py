# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that differ in nothing but where they begin: how their means scatter beside the errors that each of them claims.

Of n replicates of one quantity sum (m_i - m)^2 / e_i^2, m the mean weighted by 1/e_i^2, has the expectation n - 1 where the errors e_i hold. They are estimates of some
degrees of freedom nu_i themselves, which widens it: over n - 1 it goes about as Fisher's F of n - 1 and the least nu_i.
"""

import math
from dataclasses import dataclass

import numpy
from scipy import stats

from interphase import convergence, trade
from interphase.time_statistics import error_by_scatter

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Scatter:
    """Of one part of a quantity: the pooled `mean` of `count` runs and its `error` by their scatter; `ratio` of the scatter to what their own errors claim, root mean square,
    which lies between `low` and `high` in 95 % of cases where these hold."""

    quantity: str
    unit: str
    count: int
    mean: float
    error: float
    ratio: float
    low: float
    high: float

    @property
    def holds(self):
        return self.low <= self.ratio <= self.high


def alike(accounts):
    """[[place, ...]] of `Account`s of runs that are alike in all but seed, packing at the start and the bed that they begin with, in the order of the first of each."""
    found = {}
    for at, account in enumerate(accounts):
        key = account.case, account.method, account.weight, account.gas_step, account.solid_step, convergence.settings_of_the_bed(account)
        found.setdefault(key, []).append(at)
    return list(found.values())


def groups(sheets):
    """[[`run_sheet.Sheet`, ...]] of three such runs or more."""
    return [[sheets[at] for at in some] for some in alike([sheet.account for sheet in sheets]) if len(some) >= 3]


def scatters(sheets, depth):
    """[`Scatter`] of each quantity, part by part, that all these sheets know with an error to be trusted."""
    return [scatter_of(label, unit, means) for label, unit, means in means_of_parts(sheets, depth) if not any(mean.reason or not mean.error > 0 for mean in means)]


def means_of_parts(sheets, depth):
    """(label, unit, [`Mean` of each sheet]) of each quantity, part by part, that all these sheets know."""
    all_of = [trade.quantities(sheet.report, depth) for sheet in sheets]
    for name, (unit, parts) in all_of[0].items():
        if not all(name in each and len(each[name][1]) == len(parts) for each in all_of):
            continue
        for at in range(len(parts)):
            means = [each[name][1][at] for each in all_of]
            if None not in means:
                yield name if len(parts) == 1 else f"{name}, {at + 1} of {len(parts)}", unit, means


def scatter_of(name, unit, means):
    """The `Scatter` of the `Mean`s of independent runs, three or more."""
    values, errors = (numpy.array([getattr(mean, what) for mean in means]) for what in ("value", "error"))
    weights = errors**-2.0
    centre = float(weights @ values / weights.sum())
    left = len(means) - 1
    square = float(((values - centre) ** 2 * weights).sum()) / left
    freedom = min(mean.freedom for mean in means)
    low, high = stats.f.ppf(((1 - CONFIDENCE) / 2, (1 + CONFIDENCE) / 2), left, freedom)
    return Scatter(name, unit, len(means), float(values.mean()), float(error_by_scatter(values)), math.sqrt(square), math.sqrt(low), math.sqrt(high))
