# SPDX-License-Identifier: GPL-3.0-or-later
"""What methods were measured to get wrong, scene by scene, and what of it says something of another scene.

A table is a CSV file with the columns of `Trade`: trades.csv beside this file, and those that stand as trades.csv in the folder `study` of a case, or in one below it.
"""

import csv
import dataclasses
import glob
import math
import os
from dataclasses import dataclass
from typing import Optional

from interphase.foam_file import nearest
from interphase.input_error import InputError
from interphase.tree import CASES

COMMON = os.path.join(os.path.dirname(__file__), "trades.csv")

# A measured scene says something of another one where each of these differs by no more than the factor. Wide: bubbles depend on all of them, and few
# scenes are measured. The parcel's size decides most (van-wachem: half is lost at 0.31 of the depth, two thirds at 0.39).
NEAR = {"velocity_over_minimum": 1.5, "archimedes": 30.0, "parcel_over_depth": 1.5, "parcel_over_cell": 2.0}
NAMES = {"velocity_over_minimum": "U/U_mf", "archimedes": "Ar", "parcel_over_depth": "parcel/depth", "parcel_over_cell": "parcel/cell"}


@dataclass(frozen=True)
class Trade:
    """A `quantity` of a run of `method` in `scene` lay `deviation` (a share of it) off that of the `reference`, with the standard `error`
    of that (None: not known). `steps_per_collision`: of the solids, None of MP-PIC. `command` makes the run."""

    scene: str
    method: str
    weight: float
    steps_per_collision: Optional[float]
    quantity: str
    deviation: float
    error: Optional[float]
    reference: str
    parcel_over_cell: float
    parcel_over_depth: float
    velocity_over_minimum: float
    archimedes: float
    command: str

    @property
    def at_worst(self):
        """The share that it may be off: the deviation and twice its error."""
        return abs(self.deviation) + 2 * (self.error or 0.0)

    @property
    def for_sure(self):
        """The share that it is off at least."""
        return max(0.0, abs(self.deviation) - 2 * (self.error or 0.0))

    @property
    def words(self):
        error = "" if self.error is None else f" +- {100 * self.error:.0f}"
        return f"{self.quantity} {100 * self.deviation:+.0f}{error} %"


TEXTS = ("scene", "method", "quantity", "reference", "command")
MAY_BE_EMPTY = ("steps_per_collision", "error")
COLUMNS = tuple(field.name for field in dataclasses.fields(Trade))


def read(path):
    """The `Trade`s of the table at `path`; InputError with line and column where one is not right."""
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            rows = csv.DictReader(stream)
            if rows.fieldnames is None or set(COLUMNS) - set(rows.fieldnames):
                missing = ", ".join(name for name in COLUMNS if name not in (rows.fieldnames or ()))
                raise InputError(f"{path}: the table of trades lacks the columns {missing}")
            return [_trade(row, f"{path}, line {rows.line_num}") for row in rows]
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None


def _trade(row, where):
    values = {}
    for name in COLUMNS:
        text = (row[name] or "").strip()
        if name in TEXTS:
            values[name] = text
            continue
        if name in MAY_BE_EMPTY and not text:
            values[name] = None
            continue
        try:
            values[name] = float(text)
        except ValueError:
            values[name] = math.nan
        if not math.isfinite(values[name]):
            raise InputError(f"{where}: {name} = '{text}' is no number")
    return Trade(**values)


def tables():
    """Paths of all tables in the tree."""
    return [COMMON, *sorted(glob.glob(os.path.join(CASES, "*", "study", "**", "trades.csv"), recursive=True))]


def everything():
    """All `Trade`s in the tree."""
    return list(dict.fromkeys(trade for path in tables() for trade in read(path)))  # a run may be in two tables


def quantities(trades):
    """Names of what was compared, sorted."""
    return sorted({trade.quantity for trade in trades})


def checked_quantity(name, trades):
    """`name`; InputError with the nearest one where nothing was compared under it."""
    known = quantities(trades)
    if name not in known:
        raise InputError(f"--accuracy {name}: nothing was measured under that name: {nearest(name, known)}; there are {', '.join(known)}")
    return name


def factors(trade, scene):
    """{name: by what factor, from 1 on} the `trade` lies off the numbers of `scene` {name: number or None} in what NEAR names; infinity where the
    scene has no such number."""
    found = {}
    for name in NEAR:
        mine, theirs = scene.get(name), getattr(trade, name)
        found[name] = math.exp(abs(math.log(mine / theirs))) if mine and mine > 0 and theirs > 0 else math.inf
    return found


def is_near(trade, scene):
    """Whether all of them are within NEAR."""
    return all(factor <= NEAR[name] for name, factor in factors(trade, scene).items())


def distance(trade, scene):
    """Largest of the factors' logarithms, each over that of NEAR: near is 1 or less."""
    return max(math.log(factor) / math.log(NEAR[name]) for name, factor in factors(trade, scene).items())


def of_method(trades, method, weight, steps_per_collision):
    """Those of the method with about the same solid step: within a factor 1.2 of `steps_per_collision`; None: MP-PIC, or not known. The weight only has
    to be of the same kind, 1 or more, as the size of parcels is compared by itself."""
    def fits(trade):
        both = trade.steps_per_collision and steps_per_collision
        step = not both or abs(math.log(trade.steps_per_collision / steps_per_collision)) <= math.log(1.2)
        return trade.method == method and (trade.weight > 1) == (weight > 1) and step

    return [trade for trade in trades if fits(trade)]


def nearest_scene(trades, scene):
    """(its name, what differs by more than NEAR in words) of the least distant of `trades`; None where there are none."""
    if not trades:
        return None
    best = min(trades, key=lambda trade: distance(trade, scene))
    off = []
    for name, factor in factors(best, scene).items():
        if factor > NEAR[name]:
            mine = scene.get(name)
            off.append(f"{NAMES[name]} {getattr(best, name):.3g} there, " + (f"{mine:.3g} here" if mine else "not known here"))
    return best.scene, "; ".join(off)


LOSS = 0.2  # a share: of what is lost for sure, from which on one is warned


def warnings(trades, method, parcel_over_depth):
    """Words on what parcels as wide in their vessel, or narrower, have lost elsewhere: of each scene and quantity the narrowest ones that lost more than
    LOSS for sure."""
    if not parcel_over_depth:
        return []
    worst = {}
    for trade in trades:
        if trade.method == method and trade.parcel_over_depth <= parcel_over_depth * 1.001 and trade.for_sure > LOSS and trade.weight > 1:
            key = (trade.scene, trade.quantity)
            if key not in worst or trade.parcel_over_depth > worst[key].parcel_over_depth:
                worst[key] = trade
    return [f"{each.scene}, parcels of W = {each.weight:g}, {each.parcel_over_depth:.2g} of the depth: {each.words} of {each.reference}'s"
            for each in sorted(worst.values(), key=lambda each: (-each.for_sure, each.scene))]
