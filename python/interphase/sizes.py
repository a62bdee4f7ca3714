# SPDX-License-Identifier: GPL-3.0-or-later
"""Distributions of particle sizes, and particles that have one: tabulated shares, or lognormal, by number or by mass.

The particles of a lognormal distribution are its quantiles at (i + 1/2)/n, so that n of them follow it as closely as n can; those of
a table are the whole numbers nearest to its shares that sum up to n. Lengths in m.
"""

import math
from dataclasses import dataclass
from statistics import NormalDist

from interphase.input_error import InputError


def real_number(value, what, demand="a positive number"):
    """`value` where it is finite and above 0; InputError with `what` it is otherwise."""
    if not (math.isfinite(value) and value > 0):
        raise InputError(f"{what} must be {demand}, got {value:g}")
    return value


@dataclass(frozen=True)
class Table:
    """Diameters and their shares, which need not sum up to 1."""

    diameters: tuple
    shares: tuple
    by_mass: bool = False

    def __post_init__(self):
        for diameter in self.diameters:
            real_number(diameter, "a diameter")
        for diameter, share in zip(self.diameters, self.shares):
            real_number(share, f"the share of {diameter:g} m")
        if len(set(self.diameters)) != len(self.diameters):
            raise InputError("a diameter stands twice in the table")

    def number_shares(self):
        """Of particles, summing up to 1."""
        numbers = [s / d**3 if self.by_mass else s for d, s in zip(self.diameters, self.shares)]
        return [n / math.fsum(numbers) for n in numbers]

    def counts(self, count):
        """How many of each diameter among `count` particles: the largest remainders get the last ones."""
        wanted = [share * count for share in self.number_shares()]
        counts = [math.floor(n) for n in wanted]
        by_remainder = sorted(range(len(wanted)), key=lambda k: counts[k] - wanted[k])
        for k in by_remainder[: count - sum(counts)]:
            counts[k] += 1
        for diameter, n in zip(self.diameters, counts):
            if n == 0:
                raise InputError(f"none of {count} particles would be of {diameter:g} m; take more, or another table")
        return counts


@dataclass(frozen=True)
class Lognormal:
    """`median` diameter by number or by mass and geometric standard deviation; cut off at `low` and `high`."""

    median: float
    deviation: float
    by_mass: bool = False
    low: float = 0.0
    high: float = math.inf

    def __post_init__(self):
        real_number(self.median, "the median diameter")
        if not 1 < self.deviation < 10:
            raise InputError(f"the geometric standard deviation must be above 1 and below 10, got {self.deviation:g}")
        if not 0 <= self.low < self.high:
            raise InputError(f"nothing lies between the cuts at {self.low:g} and {self.high:g} m")

    def number_median(self):
        """Hatch and Choate, J. Franklin Inst. 207 (1929) 369."""
        return self.median * math.exp(-3 * math.log(self.deviation) ** 2) if self.by_mass else self.median

    def share_below(self, diameter):
        """Of particles, by number and with the cuts."""
        normal = NormalDist(math.log(self.number_median()), math.log(self.deviation))

        def uncut(d):
            return 0.0 if d <= 0 else 1.0 if math.isinf(d) else normal.cdf(math.log(d))

        low, high = uncut(self.low), uncut(self.high)
        if high - low < 1e-9:
            raise InputError(f"the cuts at {self.low:g} and {self.high:g} m leave nothing of the distribution")
        return min(1.0, max(0.0, (uncut(diameter) - low) / (high - low)))

    def particles(self, count):
        """Their diameters, rising."""
        normal = NormalDist(math.log(self.number_median()), math.log(self.deviation))
        self.share_below(self.median)  # refuses cuts that leave nothing
        low = normal.cdf(math.log(self.low)) if self.low > 0 else 0.0
        high = normal.cdf(math.log(self.high)) if math.isfinite(self.high) else 1.0
        return [math.exp(normal.inv_cdf(low + (high - low) * (i + 0.5) / count)) for i in range(count)]


@dataclass(frozen=True)
class Spheres:
    """What is tracked, of one size: `count` spheres of `diameter`, each for `weight` real particles, of `type`."""

    diameter: float
    count: int
    weight: float = 1.0
    type: int = 1


def tracked(distribution, count, weights=(1.0,), type_per_size=False):
    """Spheres that stand for `count` real particles. `weights`: one, or for a table one of each size."""
    for weight in weights:
        if not 1 <= weight < math.inf:
            raise InputError(f"a weight counts real particles per tracked one: 1 or more, got {weight:g}")
    if isinstance(distribution, Lognormal):
        if len(weights) != 1 or type_per_size:
            raise InputError("a lognormal distribution has one weight and one type for all its sizes")
        n = round(count / weights[0])
        if n < 1:
            raise InputError(f"{count} particles are less than a parcel of {weights[0]:g}")
        return [Spheres(d * weights[0] ** (1 / 3), 1, weights[0]) for d in distribution.particles(n)]
    sizes = len(distribution.diameters)
    if len(weights) not in (1, sizes):
        raise InputError(f"{len(weights)} weights for {sizes} sizes; give one, or one of each")
    each = weights if len(weights) == sizes else weights * sizes
    if len(set(each)) > 1 and not type_per_size:
        raise InputError("weights that differ need a type of their own for each size: LIGGGHTS's commands tell them apart by it")
    found = []
    for k, (diameter, real, weight) in enumerate(zip(distribution.diameters, distribution.counts(count), each)):
        n = round(real / weight)
        if n < 1:
            raise InputError(f"{real} particles of {diameter:g} m are less than a parcel of {weight:g}")
        found.append(Spheres(diameter * weight ** (1 / 3), n, weight, k + 1 if type_per_size else 1))
    return found
