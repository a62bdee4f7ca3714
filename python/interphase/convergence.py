# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether runs of one method come to the reference as their parcels or their steps become small: means extrapolated to the limit.

Parcels: in the diameter of a parcel over that of a real sphere, W^(1/3), to 1, by the runs of W > 1; a run of every sphere is left out, so that it can be held
against what they foretell. Solid and gas steps: to 0. Each mean is fitted by a line, weighted by its errors, and by a parabola where the line is rejected
at 5 % and there are four runs or more; what rejects both is not extrapolated. The orders at which these errors vanish are not known, so that the line is an assumption that
the runs can only reject: of runs far from the limit an extrapolation foretells more than it knows.
"""

import math
from dataclasses import dataclass

import numpy
from scipy import stats

from interphase import methods, trade
from interphase.time_statistics import Mean

FEWEST = 3  # runs that a line can be rejected by
LEVEL = 0.05
# Entries of --set that choose where a run begins or what it records, by their beginnings: none of them changes the bed that it comes to.
NOT_OF_THE_BED = ("initialPacking=", "seed=", "records/", "statistics/", "system/couplingDict:records/", "system/couplingDict:statistics/", "checkpoint/")
SOLID_STEP = ("particles/stepsPerCollision=", "particles/solidStep=", "system/couplingDict:particles/stepsPerCollision=",
              "system/couplingDict:particles/solidStep=")  # fmt: skip
GAS_STEP = ("system/controlDict:deltaT=",)


@dataclass(frozen=True)
class Family:
    """`sheets` of one `method` that differ by one number, `values`, from the coarsest on; `by` names it, `unit` "" for a ratio; `limit` of it; `fitted`: which of the
    sheets the extrapolation is made of."""

    method: str
    by: str
    unit: str
    sheets: tuple
    values: tuple
    limit: float
    fitted: tuple

    @property
    def title(self):
        ends = f"{self.by}s of {', '.join(f'{value:.3g}' for value in self.values)}{f' {self.unit}' if self.unit else ''}"
        return f"{self.method}, {ends}, to {self.limit:g}"


@dataclass(frozen=True)
class Limit:
    """Of one quantity: its `means` at the limit, None where they are not known; `degree` of the polynomial, None where none fits, for `reason`."""

    unit: str
    means: list
    degree: object
    reason: str = ""


def families(sheets):
    """[`Family`] that there are among `run_sheet.Sheet`s."""
    found = []
    for by, unit, limit, key, value in (
        ("parcel diameter", "", 1.0, _of_weight, lambda account: account.weight ** (1 / 3)),
        ("solid step", "s", 0.0, _of_solid_step, lambda account: account.solid_step),
        ("gas step", "s", 0.0, _of_gas_step, lambda account: account.gas_step),
    ):
        groups = {}
        for sheet in sheets:
            groups.setdefault(key(sheet.account), []).append(sheet)
        for some in groups.values():
            family = _family(by, unit, limit, some, value)
            if family is not None:
                found.append(family)
    return found


def _family(by, unit, limit, sheets, value):
    known = sorted(((value(sheet.account), sheet) for sheet in sheets if math.isfinite(value(sheet.account))), key=lambda pair: -pair[0])
    values = tuple(x for x, _ in known)
    # At the limit itself there is nothing to extrapolate.
    fitted = tuple(x > limit * (1 + 1e-9) for x in values)
    apart = len({round(x / values[0], 6) for x, used in zip(values, fitted) if used}) if values else 0
    if apart < FEWEST:
        return None
    method = known[0][1].account.method
    return Family(method, by, unit, tuple(sheet for _, sheet in known), values, limit, fitted)


def settings_of_the_bed(account, but=()):
    """Entries of --set that make a difference to the bed, sorted; without those that begin with one of `but`."""
    return tuple(sorted(each for each in account.settings if not each.startswith(NOT_OF_THE_BED + tuple(but))))


def _of_weight(account):
    # the contacts of a method that tracks every sphere are those of the method of parcels
    known = methods.of_tree().get(account.method)
    return known and known.with_parcels or account.method, settings_of_the_bed(account, GAS_STEP), account.gas_step, account.case


def _of_solid_step(account):
    return account.method, account.weight, settings_of_the_bed(account, SOLID_STEP + GAS_STEP), account.gas_step, account.case


def _of_gas_step(account):
    return account.method, account.weight, settings_of_the_bed(account, GAS_STEP), account.case


def limits(family, depth):
    """{quantity: `Limit`} of a `Family`, of each quantity that all of its fitted runs have; windows at `depth`."""
    used = [(x, trade.quantities(sheet.report, depth)) for x, sheet, fits in zip(family.values, family.sheets, family.fitted) if fits]
    first = used[0][1]
    return {name: limit_of([x for x, _ in used], [each[name][1] for _, each in used], family.limit, first[name][0])
            for name in first if all(name in each and len(each[name][1]) == len(first[name][1]) for _, each in used)}  # fmt: skip


def limit_of(values, parts, limit, unit=""):
    """The `Limit` of a quantity: `values` [n] of the runs, `parts` [n][m] of `Mean` or None."""
    columns = list(zip(*parts))
    if any(mean is None or not mean.error > 0 for column in columns for mean in column):  # NaN, too
        return Limit(unit, [None] * len(columns), None, "some of its errors are not known")
    for degree in (1, 2) if len(values) >= 4 else (1,):
        fits = [_fit(values, column, limit, degree) for column in columns]
        if all(chance * len(fits) >= LEVEL for _, chance in fits):  # Bonferroni: of all parts together
            return Limit(unit, [mean for mean, _ in fits], degree)
    shape = "a parabola" if degree == 2 else "a line"
    return Limit(unit, [None] * len(columns), None, f"its means do not lie on {shape}: with finer runs they may")


def _fit(values, means, limit, degree):
    """(`Mean` at the limit, chance of means as far off a polynomial of that degree that are on one)."""
    apart = numpy.array(values) - limit
    scale = numpy.abs(apart).max()
    error = numpy.array([mean.error for mean in means])
    design = numpy.vander(apart / scale, degree + 1, increasing=True)
    weighted = design / error[:, None]
    value = numpy.array([mean.value for mean in means])
    of_means = numpy.linalg.solve(weighted.T @ weighted, weighted.T / error)  # what each mean gives to the polynomial's coefficients
    residual = value - design @ (of_means @ value)
    own = (of_means[0] * error) ** 2  # the first one is the value at the limit
    freedom = trade.freedom(float(own.sum()), own, means)
    left = len(means) - degree - 1
    # The errors are estimates of so many degrees of freedom themselves, hence F and not chi-square.
    chance = float(stats.f.sf((residual**2 / error**2).sum() / left, left, min(mean.freedom for mean in means))) if left else 1.0
    reason = next((mean.reason for mean in means if mean.reason), "")
    return Mean(float(of_means[0] @ value), math.sqrt(float(own.sum())), math.nan, min(mean.samples for mean in means), math.nan, freedom, math.nan, reason), chance


def distances(reference, found, depth):
    """[`trade.Distance`] of limits {quantity: `Limit`} to the reference's report."""
    ours = {name: (limit.unit, limit.means) for name, limit in found.items() if limit.degree is not None}
    return trade.between(trade.quantities(reference, depth), ours)
