# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper found (L. Lu, X. Gao, J.-F. Dietiker, M. Shahnam, W. A. Rogers, Ind. Eng. Chem. Res. 2021, of five methods on one bed), asked of the runs at hand.

A claim is a number against a limit. It is `found` where the number keeps the limit with its error, `not found` where it breaks it with its
error, `not decided` in between and where an error is not to be trusted; the error's part is Student's t at 95 %. Ratios are to DEM, or to TDHS
where no run of DEM is there, which is said. Of several runs of a method the one with the paper's W = 8, or the nearest to it, is taken.
"""

import math
from dataclasses import dataclass

import numpy
from scipy import stats

from interphase import trade

FOUND, NOT_FOUND, UNDECIDED = "found", "not found", "not decided"
PAPERS_WEIGHT = 8.0
LEVEL = 0.95
PARCELS = ("CGPM", "CGHS")
# Seconds of a run over those of DEM, measured by the paper at W = 8
PAPERS_COST = {"TDHS": 1 / 2, "CGPM": 1 / 24, "CGHS": 1 / 26, "MPPIC": 1 / 50}
ALIKE = 0.05  # pressure drops that differ by less are called alike


@dataclass(frozen=True)
class Finding:
    """`claim` in words, its `verdict`, the `reason` with numbers, and the `runs` that these are of."""

    claim: str
    verdict: str
    reason: str
    runs: tuple


def of(sheets, depth):
    """[`Finding`] of the `Sheet`s: those of the claims that the runs there are can be asked about."""
    asked = Asked(sheets, depth)
    found = [make(asked) for make in (_drop, _temperature, _flat, _no_slugs, _vigorous)]
    return [each for group in [*found, _overlaps(asked), _voidage(asked), _costs(asked), _accuracy(asked)] for each in group]


class Asked:
    """The runs by method; `base`: the one that the others are compared with, None where there is neither DEM nor TDHS."""

    def __init__(self, sheets, depth):
        self.depth = depth
        self.of = {}
        for sheet in sheets:
            before = self.of.get(sheet.account.method)
            if before is None or _far(sheet) < _far(before):
                self.of[sheet.account.method] = sheet
        self.base = self.of.get("DEM", self.of.get("TDHS"))

    def others(self, *methods):
        """The runs of these methods that are not the base, where there is one."""
        return [self.of[each] for each in methods if each in self.of and self.base is not None and self.of[each] is not self.base]

    def mean(self, sheet, name):
        """The `Mean` of a quantity of trade.quantities, over its parts."""
        parts = trade.quantities(sheet.report, self.depth).get(name, ("", []))[1]
        return trade.as_mean(parts)


def _far(sheet):
    weight = sheet.account.weight
    return abs(math.log(weight / PAPERS_WEIGHT)) if weight and weight > 0 else math.inf


def judged(value, error, freedom, limit, below, doubt=""):
    """(verdict, half width) of the claim that `value` is below the limit, else above it."""
    if doubt or not math.isfinite(value) or not math.isfinite(error):
        return UNDECIDED, math.nan
    half = float(stats.t.isf((1 - LEVEL) / 2, max(freedom, 1))) * error
    if abs(value - limit) <= half:
        return UNDECIDED, half
    return FOUND if (value < limit) == below else NOT_FOUND, half


def ratio(over, under):
    """(ratio, its standard error, degrees of freedom, doubt) of two `Mean`s, to first order."""
    value = over.value / under.value if under.value else math.nan
    parts = [(each.error / each.value if each.value else math.nan, each.freedom) for each in (over, under)]
    relative = math.hypot(*(part for part, _ in parts))
    doubt = over.reason or under.reason
    return value, abs(value) * relative, min(freedom for _, freedom in parts), doubt


def _plus(value, half, factor=1.0, unit=""):
    """In words; `?` where no error is known, or it is not to be trusted."""
    known = math.isfinite(half)
    return f"{factor * value:.3g} +- " + (f"{factor * half:.2g}" if known else "?") + unit


def _compared(asked, sheet, name, limit, below, what):
    """The `Finding`'s verdict and reason by the ratio of a mean to the base's; None where one is missing."""
    ours, base = asked.mean(sheet, name), asked.mean(asked.base, name)
    if ours is None or base is None:
        return None
    value, error, freedom, doubt = ratio(ours, base)
    verdict, half = judged(value, error, freedom, limit, below, doubt)
    words = f"{what} {_plus(value, half)} times that of {asked.base.name}"
    return verdict, words + (f"; {doubt}" if doubt else ""), (sheet.name, asked.base.name)


def _each(asked, methods, name, limit, below, what, claim):
    found = []
    for sheet in asked.others(*methods):
        if compared := _compared(asked, sheet, name, limit, below, what):
            found.append(Finding(claim.format(sheet.account.method, f"{sheet.account.weight:g}"), *compared))
    return found


def _drop(asked):
    found = []
    for sheet in asked.others("TDHS", "CGPM", "CGHS", "MPPIC"):
        ours, base = asked.mean(sheet, "pressure drop"), asked.mean(asked.base, "pressure drop")
        if ours is None or base is None:
            continue
        value, error, freedom, doubt = ratio(ours, base)
        away = abs(value - 1)
        verdict, half = judged(away, error, freedom, ALIKE, True, doubt)
        words = f"its mean is {_plus(value - 1, half, 100, ' %')} off that of {asked.base.name}; alike is less than {100 * ALIKE:g} %"
        found.append(Finding(f"the pressure drop does not tell {sheet.account.method} from {asked.base.account.method}", verdict,
                             words + (f"; {doubt}" if doubt else ""), (sheet.name, asked.base.name)))  # fmt: skip
    return found


def _temperature(asked):
    return _each(asked, PARCELS, "granular temperature", 1, True, "mean over the windows", "parcels lower the granular temperature ({0}, W = {1})")


def _flat(asked):
    """The vertical velocity's size over the windows, root mean square without its noise."""
    found = []
    for sheet in asked.others("MPPIC"):
        both = [trade.quantities(each.report, asked.depth).get("vertical velocity") for each in (sheet, asked.base)]
        if None in both:
            continue
        (size, error, freedom, doubt), base = (_size(means) for _, means in both)
        doubt = doubt or base[3]
        value = size / base[0] if base[0] else math.nan
        spread = value * math.hypot(error / size if size else math.nan, base[1] / base[0] if base[0] else math.nan)
        verdict, half = judged(value, spread, min(freedom, base[2]), 0.5, True, doubt)
        found.append(Finding("MP-PIC's profile of vertical velocity is flat (below half of the others')", verdict,
                             f"root mean square over the windows {_plus(value, half)} times that of {asked.base.name}" + (f"; {doubt}" if doubt else ""),
                             (sheet.name, asked.base.name)))  # fmt: skip
    return found


def _size(means):
    known = [mean for mean in means if mean is not None and math.isfinite(mean.error)]
    if not known:
        return math.nan, math.nan, 1, "no errors are known"
    values, errors = (numpy.array([getattr(mean, name) for mean in known]) for name in ("value", "error"))
    size = math.sqrt(max(float((values**2 - errors**2).mean()), 0.0))
    error = math.sqrt(float((values**2 * errors**2).sum())) / len(known) / size if size else math.nan
    return size, error, min(mean.freedom for mean in known), next((mean.reason for mean in known if mean.reason), "")


def _no_slugs(asked):
    return _each(asked, ("MPPIC",), "pressure drop, deviation", 0.5, True, "deviation of the pressure drop",
                 "MP-PIC shows no slugging (its pressure swings less than half as much)")  # fmt: skip


def _vigorous(asked):
    if asked.base is None or asked.base.account.method != "DEM":
        return []
    return _each(asked, ("TDHS",), "pressure drop, deviation", 1, False, "deviation of the pressure drop", "TDHS's pressure swings more than DEM's")


def share_below(report, limit):
    """(share, error, freedom, doubt) of the overlaps below `limit` times d, None where none were measured. Without one that was asked for, the histogram tells it, without error."""
    for quantity in report.overlaps:
        if quantity.name == f"overlaps below {100 * limit:g} % d" and quantity.mean is not None:
            mean = quantity.mean
            return mean.value, mean.error, mean.freedom, mean.reason
    if report.overlap is None:
        return None
    cumulative = numpy.concatenate([[0.0], report.overlap.share.cumsum()])
    return float(numpy.interp(limit, report.overlap.edges, cumulative)), math.nan, 1, "this share was not asked for: no error"


def _overlaps(asked):
    wanted = (("DEM", 0.0025, 0.90), ("DEM", 0.01, 0.97), ("CGPM", 0.01, 0.87), ("CGPM", 0.0275, 0.99))
    found = []
    for method, limit, paper in wanted:
        share = asked.of.get(method) and share_below(asked.of[method].report, limit)
        if not share:
            continue
        value, error, freedom, doubt = share
        off = 0.05  # of the share, that counts as the paper's own
        verdict, half = judged(abs(value - paper), error, freedom, off, True, doubt)
        found.append(Finding(f"{method}: {100 * paper:g} % of the overlaps are below {100 * limit:g} % of d", verdict,
                             f"{_plus(value, half, 100, ' %')}; within 5 points counts as found" + (f"; {doubt}" if doubt else ""), (asked.of[method].name,)))  # fmt: skip
    for sheet in asked.others("TDHS", "CGHS"):
        ours, base = share_below(sheet.report, 0.01), share_below(asked.base.report, 0.01)
        if ours is None or base is None or asked.base.account.method != "DEM":
            continue
        doubt = ours[3] or base[3]
        verdict, half = judged(ours[0] - base[0], math.hypot(ours[1], base[1]), min(ours[2], base[2]), 0, False, doubt)
        found.append(Finding(f"{sheet.account.method}'s overlaps are smaller than DEM's", verdict,
                             f"the share below 1 % of d is {_plus(ours[0] - base[0], half, 100, ' points')} larger" + (f"; {doubt}" if doubt else ""),
                             (sheet.name, asked.base.name)))  # fmt: skip
    if sheet := asked.of.get("MPPIC"):
        if share := share_below(sheet.report, 0.5):
            # Evenly spread up to d: half of them below d/2. The histogram's share has no error; the margin is wide.
            verdict = FOUND if abs(share[0] - 0.5) < 0.2 else NOT_FOUND
            found.append(Finding("MP-PIC's overlaps are spread evenly up to d", verdict,
                                 f"{100 * share[0]:.3g} % are below d/2; 30 to 70 % counts as found", (sheet.name,)))  # fmt: skip
    return found


def _voidage(asked):
    found = []
    for method in ("DEM", "TDHS"):
        sheet = asked.of.get(method)
        if sheet is None or sheet.report.voidage is None:
            continue
        histogram = sheet.report.voidage
        middles = (histogram.edges[1:] + histogram.edges[:-1]) / 2
        dense = middles < 0.8  # above, the surface and the freeboard
        if not histogram.share[dense].any():
            continue
        peak = float(middles[dense][int(histogram.share[dense].argmax())])
        found.append(Finding(f"{method}: the voidage of cells has its peak near 0.45", FOUND if 0.42 <= peak <= 0.50 else NOT_FOUND,
                             f"the fullest class below 0.8 is at {peak:.3g}; 0.42 to 0.50 counts as found", (sheet.name,)))  # fmt: skip
    for sheet in asked.others("MPPIC"):
        if (other_kind := _of_another_kind("MP-PIC has more cells of a voidage below 0.40", sheet, asked.base)) is not None:
            found.append(other_kind)
            continue
        ours, base = (next((q.mean for q in each.report.voidages if q.name.endswith("voidage below 0.4")), None) for each in (sheet, asked.base))
        if ours is None or base is None:
            continue
        doubt = ours.reason or base.reason
        verdict, half = judged(ours.value - base.value, math.hypot(ours.error, base.error), min(ours.freedom, base.freedom), 0, False, doubt)
        found.append(Finding("MP-PIC has more cells of a voidage below 0.40", verdict,
                             f"{_plus(ours.value - base.value, half, 100, ' % of the cells')} more than {asked.base.name}, which has {100 * base.value:.3g} %"
                             + (f"; {doubt}" if doubt else ""), (sheet.name, asked.base.name)))  # fmt: skip
    for sheet in asked.others(*PARCELS):
        both = [each.report.voidage for each in (sheet, asked.base)]
        if None in both:
            continue
        if (other_kind := _of_another_kind(f"{sheet.account.method}: the voidage is spread flatter between 0.5 and 0.8", sheet, asked.base)) is not None:
            found.append(other_kind)
            continue
        flat = [_flatness(each) for each in both]
        found.append(Finding(f"{sheet.account.method}: the voidage is spread flatter between 0.5 and 0.8", FOUND if flat[0] > flat[1] else NOT_FOUND,
                             f"the mean class between 0.5 and 0.8 holds {100 * flat[0]:.3g} % of the fullest class below 0.8; {asked.base.name}: {100 * flat[1]:.3g} %; "
                             "without an error", (sheet.name, asked.base.name)))  # fmt: skip
    return found


def _of_another_kind(claim, sheet, base):
    """A `Finding` that nothing is decided, where one run tells the mapped voidage and the other that of the spheres; else None."""
    kinds = [each.report.kind_of_voidage for each in (sheet, base)]
    if kinds[0] == kinds[1] or not all(each.report.voidages for each in (sheet, base)):
        return None
    return Finding(claim, UNDECIDED, f"of {sheet.name} there is the {kinds[0]}, of {base.name} the {kinds[1]}: measure both alike, by tools/report --snapshots",
                   (sheet.name, base.name))  # fmt: skip


def _flatness(histogram):
    middles = (histogram.edges[1:] + histogram.edges[:-1]) / 2
    between, dense = (middles > 0.5) & (middles < 0.8), middles < 0.8
    top = histogram.share[dense].max(initial=0.0)
    return float(histogram.share[between].mean() / top) if between.any() and top else math.nan


def _costs(asked):
    if "DEM" not in asked.of or asked.of["DEM"].account.cost is None:
        return []
    base, found = asked.of["DEM"].account.cost, []
    for method, paper in PAPERS_COST.items():
        sheet = asked.of.get(method)
        if sheet is None or sheet.account.cost is None:
            continue
        cost = sheet.account.cost
        value = cost.value / base.value
        relative = math.hypot(*(each.error / each.value if math.isfinite(each.error) else 0.0 for each in (cost, base)))
        mixed = "" if cost.kind == base.kind else f"; {cost.kind} against {base.kind}"
        verdict, half = judged(value, value * relative, 20, paper, True)
        found.append(Finding(f"{method} costs at most 1/{1 / paper:g} of DEM", verdict,
                             f"{cost.value:.3g} against {base.value:.3g} s of {cost.kind} per simulated second: 1/{1 / value:.3g} (ratio {_plus(value, half)}){mixed}",
                             (sheet.name, asked.of["DEM"].name)))  # fmt: skip
    return found


def _accuracy(asked):
    found, far = [], {}
    for sheet in asked.others("CGHS", "MPPIC"):
        far[sheet.account.method] = trade.overall(trade.distances(asked.base.report, sheet.report, asked.depth))
    if None in far.values() or len(far) < 2:
        return found
    ours, other = far["MPPIC"], far["CGHS"]
    verdict, _ = judged(ours.square - other.square, math.hypot(ours.square_error, other.square_error), 30, 0, False, ours.reason or other.reason)
    doubt = ours.reason or other.reason
    return [Finding("CGHS is nearer to the reference than MP-PIC", verdict,
                    f"overall distance {other.value:.3g} ({other.low:.3g} to {other.high:.3g}) against {ours.value:.3g} ({ours.low:.3g} to {ours.high:.3g})"
                    + (f"; {doubt}" if doubt else ""), (asked.of["CGHS"].name, asked.of["MPPIC"].name, asked.base.name))]  # fmt: skip
