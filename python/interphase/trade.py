# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a run is from the one that it is held against, quantity by quantity and overall, with the error of that distance.

A quantity has one part or several (windows, classes), x_i of the run and r_i of the reference, with variances s_i^2 of their means. Its distance D is

    D^2 = (sum (x_i - r_i)^2 - sum v_i) / scale^2,   v_i = s_i^2(x) + s_i^2(r),

the relative deviation, root mean square over the parts. Two runs of one and the same flow differ by their errors alone, whose
squares have the expectation sum v_i: it is taken off, so that D^2 is 0 on average where there is no difference, and below in half of the
cases. sqrt(sum v_i) / scale, the noise, is the distance that the records could not tell from none. The variance of the numerator is
sum (4 d_i^2 v_i + 2 v_i^2), of normal errors that are independent from part to part. Parts of one record are not quite so, neighbours least
of all: an error of a profile is then too small by up to sqrt(number of parts).

The scale is sqrt(sum r_i^2): the reference's own value or profile. Horizontal velocities are held against the vertical ones of the reference,
which drive them.
"""

import math
from dataclasses import dataclass

from scipy import stats

from interphase.run_report import COMPONENTS, FREQUENCY
from interphase.time_statistics import Mean

LEVEL = 0.05  # chance of calling equal runs different, of each quantity
# Shown, but no part of the overall distance: how far spheres may overlap is the springs' or the method's own choice; which of two peaks of a spectrum is the higher is
# often chance (a slug's frequency and its double), and then nothing but that would be seen.
NOT_COUNTED = ("overlaps", FREQUENCY)
OVERALL = "overall"


@dataclass(frozen=True)
class Distance:
    """Of a `quantity`: the square of the distance, which noise may make negative, with its standard error; `noise`: the distance that two
    equal runs of these records have, root mean square; `chance` of one as large where there is no difference (NaN: not judged, for `reason`);
    `scale` of what it is relative to, in words."""

    quantity: str
    square: float
    square_error: float
    noise: float
    chance: float
    scale: str
    reason: str = ""

    @property
    def value(self):
        """The distance, 0 where the square is negative."""
        return math.sqrt(max(self.square, 0.0))

    @property
    def low(self):
        """The distance one standard error of the square below."""
        return math.sqrt(max(self.square - self.square_error, 0.0))

    @property
    def high(self):
        return math.sqrt(max(self.square + self.square_error, 0.0))

    @property
    def told_apart(self):
        """Whether the records tell the two runs apart."""
        return self.chance < LEVEL


def quantities(report, depth):
    """{name: (unit, [Mean or None, ...])} of a `RunReport`: what distances are taken of; windows at one depth."""
    found = {each.name: (each.unit, [each.mean]) for each in report.series}
    if report.windows is not None:
        profile = report.profiles[depth]
        for component in reversed(COMPONENTS):
            found[f"{component} velocity"] = "m/s", list(profile.velocity[component])
        found["granular temperature"] = "m2/s2", list(profile.temperature)
    if report.voidages:
        found[report.kind_of_voidage] = "1", [each.mean for each in report.voidages]
    if shares := [each.mean for each in report.overlaps if each.name.startswith("overlaps below")]:
        found["overlaps"] = "1", shares
    return found


def distances(reference, report, depth, wanted=None):
    """[`Distance`] of a `RunReport` to the reference's, of each quantity that both have, those that are `wanted` (None: all)."""
    return between(quantities(reference, depth), quantities(report, depth), wanted)


def between(theirs, ours, wanted=None):
    """The same of what `quantities` has found of the reference, `theirs`, and of another."""
    found = []
    for name in ours:
        if name in theirs and (wanted is None or name in wanted):
            of = "vertical velocity" if name == "horizontal velocity" else name
            found.append(_distance(name, theirs[name][1], ours[name][1], theirs.get(of, theirs[name])[1], of))
    return found


def _known(mean):
    return mean is not None and math.isfinite(mean.value)


def _distance(name, reference, ours, scale_of, scaled_by):
    scale = math.sqrt(sum(mean.value**2 for mean in scale_of if _known(mean)))
    words = "the reference's value" if len(reference) == 1 else f"the reference's {scaled_by}, root mean square"
    pairs = [(a, b) for a, b in zip(reference, ours) if _known(a) and _known(b)]
    if not pairs or not scale:
        return Distance(name, math.nan, math.nan, math.nan, math.nan, words, "nothing to compare" if not pairs else "the reference is 0")
    difference = [b.value - a.value for a, b in pairs]
    variance = [a.error**2 + b.error**2 for a, b in pairs]
    reason = next((mean.reason for pair in pairs for mean in pair if mean.reason), "")
    if any(math.isnan(v) for v in variance):
        square = sum(d * d for d in difference) / scale**2
        return Distance(name, square, math.nan, math.nan, math.nan, words, reason)
    square = (sum(d * d for d in difference) - sum(variance)) / scale**2
    error = math.sqrt(sum(4 * d * d * v + 2 * v * v for d, v in zip(difference, variance))) / scale**2
    chance = math.nan if reason else _chance(pairs, difference, variance)
    return Distance(name, square, error, math.sqrt(sum(variance)) / scale, chance, words, reason)


def _chance(pairs, difference, variance):
    """Of parts as far apart as these in one flow: the least of the parts' by Student's t, times their number (Bonferroni), which
    holds however they depend on each other."""
    least = 1.0
    for (a, b), d, v in zip(pairs, difference, variance):
        if v == 0:
            least = min(least, 1.0 if d == 0 else 0.0)
            continue
        of_both = freedom(v, (a.error**2, b.error**2), (a, b))
        least = min(least, 2 * float(stats.t.sf(abs(d) / math.sqrt(v), max(of_both, 1e-3))))
    return min(1.0, least * len(pairs))


def freedom(whole, parts, means):
    """Degrees of freedom of the variance `whole`, the sum of `parts` with those of `means` (Welch and Satterthwaite); 0 where one has none."""
    if any(part > 0 and mean.freedom <= 0 for part, mean in zip(parts, means)):
        return 0.0
    below = sum(part**2 / mean.freedom for part, mean in zip(parts, means) if part > 0)
    return whole**2 / below if below > 0 else math.inf


def overall(found):
    """The `Distance` of all quantities together, root mean square; those of NOT_COUNTED are left out. None of none."""
    used = [each for each in found if each.quantity not in NOT_COUNTED and math.isfinite(each.square)]
    if not used:
        return None
    count = len(used)
    known = [each for each in used if math.isfinite(each.square_error)]
    unknown = len(known) < count
    error = math.nan if unknown else math.sqrt(sum(each.square_error**2 for each in known)) / count
    noise = math.nan if unknown else math.sqrt(sum(each.noise**2 for each in known) / count)
    judged = [each.chance for each in used if not math.isnan(each.chance)]
    chance = min(1.0, min(judged) * len(judged)) if judged else math.nan
    doubted = [each.quantity for each in used if each.reason]
    reason = f"errors that are not to be trusted in {len(doubted)} of {count} quantities: {', '.join(doubted)}" if doubted else ""
    return Distance(OVERALL, sum(each.square for each in used) / count, error, noise, chance,
                    f"root mean square of {count} quantities", reason)  # fmt: skip


def words_on(found, reference=""):
    """What `Distance`s tell apart (from `reference`, where that is named), what they do not, and what they do not decide, in words."""
    apart = [each.quantity for each in found if each.told_apart]
    undecided = [each.quantity for each in found if math.isnan(each.chance)]
    alike = [each.quantity for each in found if each.quantity not in apart + undecided]
    of = f" from {reference}" if reference else ""
    return "; ".join(f"{what}{', '.join(names)}" for what, names in ((f"told apart{of} by ", apart), (f"not told apart{of} by ", alike), ("not decided: ", undecided)) if names)


@dataclass(frozen=True)
class Point:
    """A run in the plane of cost and distance: `name`, `cost` (run_account.Cost or None), `distance` (None: the reference itself)."""

    name: str
    cost: object
    distance: Distance


def best(points):
    """Names of the points that no other one beats: none costs less and is nearer."""
    known = [each for each in points if each.cost is not None and math.isfinite(each.cost.value)]
    place = {each.name: (each.cost.value, 0.0 if each.distance is None else each.distance.value) for each in known}
    return [name for name, (cost, far) in place.items()
            if not any(c <= cost and d <= far and (c, d) != (cost, far) for c, d in place.values())]  # fmt: skip


def as_mean(values):
    """The `Mean` of several Means of independent records, such as windows' or runs', each of the same weight; None of none."""
    known = [each for each in values if _known(each)]
    if not known:
        return None
    count = len(known)
    errors = [each.error for each in known]
    error = math.sqrt(sum(e * e for e in errors)) / count
    of_all = freedom(error**2, [(e / count) ** 2 for e in errors], known) if error > 0 else math.inf
    return Mean(sum(each.value for each in known) / count, error, known[0].deviation, min(each.samples for each in known),
                min(each.effective for each in known), of_all, known[0].time, next((each.reason for each in known if each.reason), ""))  # fmt: skip
