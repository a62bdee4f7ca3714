# SPDX-License-Identifier: GPL-3.0-or-later
"""What the spheres and the gas of a picture are coloured by, and over which range."""

from dataclasses import dataclass

import numpy

from interphase.input_error import InputError

STEPS = (1, 2, 5, 10)  # few, so that pictures of like runs have like ranges
OUTLIERS = 98  # per cent of the values that the range holds


@dataclass(frozen=True)
class Quantity:
    """`label` with unit for the colour bar; `map`: matplotlib's; `kind` of its range: symmetric about 0, from 0, or between its ends."""

    label: str
    map: str
    kind: str
    of: object  # function of (snapshot, first snapshot) -> [n]; of a gas field's values [n] or [n, 3] for the gas
    needs: tuple = ()


def _at_start(snapshot, first):
    """The height of each at the first snapshot; NaN for those that came later."""
    at = numpy.searchsorted(first.ids, snapshot.ids)
    at = numpy.minimum(at, len(first.ids) - 1) if len(first.ids) else numpy.zeros(len(snapshot.ids), int)
    known = first.ids[at] == snapshot.ids if len(first.ids) else numpy.zeros(len(snapshot.ids), bool)
    return numpy.where(known, first.positions[at, 2] if len(first.ids) else 0.0, numpy.nan)


# coolwarm diverges, and at rest it is grey: visible on white.
PARTICLES = {
    "vertical_velocity": Quantity("vertical velocity [m/s]", "coolwarm", "symmetric", lambda s, _: s.velocities[:, 2]),
    "speed": Quantity("speed [m/s]", "viridis", "from zero", lambda s, _: numpy.linalg.norm(s.velocities, axis=1)),
    "diameter": Quantity("diameter [m]", "viridis", "between", lambda s, _: s.diameters),
    "type": Quantity("type", "tab10", "numbers", lambda s, _: s.read("type").values, ("type",)),
    "weight": Quantity("real particles per parcel", "viridis", "between", lambda s, _: s.read("weight").values, ("weight",)),
    "force": Quantity("force [N]", "magma", "from zero", lambda s, _: numpy.linalg.norm(s.forces, axis=1), ("force",)),
    "height-at-start": Quantity("height at the start [m]", "viridis", "between", _at_start, ("id",)),
}
GAS = {
    "voidage": ("voidage", Quantity("voidage", "YlGnBu_r", "voidage", lambda v: v)),
    "velocity": ("U", Quantity("gas speed [m/s]", "viridis", "from zero", lambda v: numpy.linalg.norm(v, axis=1))),
}
VOIDAGE = (0.4, 1.0)  # a packing, and free gas


def range_text(text):
    """LOW,HIGH as two numbers; ValueError with what is expected otherwise."""
    words = text.split(",")
    try:
        low, high = (float(word) for word in words)
    except ValueError:
        raise ValueError(f"'{text}': two numbers LOW,HIGH are expected, such as -1,1") from None
    if not (numpy.isfinite([low, high]).all() and low < high):
        raise ValueError(f"'{text}': LOW must be below HIGH, and both finite")
    return low, high


def range_of(quantity, values):
    """(low, high) of the colours by a list of arrays: round numbers that hold 98 % of them."""
    if quantity.kind == "voidage":
        return VOIDAGE
    every = numpy.concatenate([numpy.ravel(each) for each in values]) if values else numpy.zeros(0)
    every = every[numpy.isfinite(every)]
    if not every.size:
        return (-1.0, 1.0) if quantity.kind == "symmetric" else (0.0, 1.0)
    if quantity.kind == "symmetric":
        end = above(float(numpy.percentile(numpy.abs(every), OUTLIERS)))
        return -end, end
    if quantity.kind == "from zero":
        return 0.0, above(float(numpy.percentile(every, OUTLIERS)))
    if quantity.kind == "numbers":
        return float(every.min()) - 0.5, max(float(every.max()), float(every.min()) + 1) + 0.5
    low, high = float(every.min()), float(every.max())
    # One value alone has no range of its own.
    return (low, high) if high - low > 1e-6 * abs(high) else (0.5 * low, 1.5 * high) if high > 0 else (low - 1, high + 1)


def above(value):
    """The round number at or above `value`: 1, 2 or 5 and zeros; 1 for 0."""
    if not value > 0:
        return 1.0
    unit = 10.0 ** numpy.floor(numpy.log10(value))
    return float(f"{unit * next(step for step in STEPS if step * unit >= value * (1 - 1e-9)):.3g}")


def check(name, quantity, snapshot):
    """InputError where the snapshots do not hold what the colours are of."""
    missing = [each for each in quantity.needs if each not in snapshot.names]
    if missing:
        others = ", ".join(each for each, other in PARTICLES.items() if not set(other.needs) - set(snapshot.names))
        raise InputError(f"--colour {name}: the snapshots of this run hold no {missing[0]}; there are {others}")
