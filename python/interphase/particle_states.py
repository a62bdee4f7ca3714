# SPDX-License-Identifier: GPL-3.0-or-later
"""What particles are doing at one time, whoever wrote it: LIGGGHTS or one of our runs.

Quantities have one name on both sides, in SI units where the script's are: position, velocity, spin (angular
velocity), force, torque, angular_momentum [n,3]; diameter and any further column of a dump [n].
"""

from dataclasses import dataclass
from typing import Callable, Optional

import numpy

UNITS = {
    "position": "m", "velocity": "m/s", "spin": "rad/s", "force": "N", "torque": "N m",
    "angular_momentum": "kg m2/s", "diameter": "m", "mass": "kg", "density": "kg/m3",
}


@dataclass(frozen=True)
class Box:
    """The simulation box: lower corner and edges [m], and which directions repeat."""

    low: tuple
    edges: tuple
    periodic: tuple


@dataclass
class ParticleState:
    """Particles at one time: ids [n], unique and ascending, and the quantities in the same order."""

    ids: numpy.ndarray
    quantities: dict
    box: Optional[Box] = None


@dataclass
class Frame:
    """A time of a source. `where` names it in messages; `step` or `time` [s] is None where the source has none.

    `load` reads the particles; a frame may be loaded once only and before the next one is asked for.
    """

    where: str
    step: Optional[int]
    time: Optional[float]
    load: Callable[[], ParticleState]


def by_id(ids, quantities, box, where, refuse):
    """A `ParticleState` in ascending order of id. `refuse(message)` is called for ids that are none."""
    numbers = numpy.asarray(ids)
    if numbers.dtype.kind == "f":
        whole = numpy.isfinite(numbers) & (numbers == numpy.floor(numbers)) & (numpy.abs(numbers) < 2**53)
        if not whole.all():
            refuse(f"{where}: particle id {numbers[~whole][0]!r} is not a whole number: is the column id what it says?")
    numbers = numbers.astype(numpy.int64)
    steps = numpy.diff(numbers)
    if (steps <= 0).any():
        order = numpy.argsort(numbers, kind="stable")
        numbers = numbers[order]
        quantities = {name: values[order] for name, values in quantities.items()}
        twice = numbers[1:][numpy.diff(numbers) == 0]
        if len(twice):
            refuse(f"{where}: particle id {twice[0]} occurs more than once, so particles cannot be matched; "
                   "in a LIGGGHTS script `set`/`fix insert` gives each particle its own id")
    return ParticleState(numbers, quantities, box)
