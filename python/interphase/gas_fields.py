# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of the gas in a run's time folders."""

import os
import re
from dataclasses import dataclass

import numpy

from interphase import foam_field
from interphase.input_error import InputError
from interphase.parts import times
from interphase.same_time import same_time
from interphase.run import no_such

BASE_UNITS = ("kg", "m", "s", "K", "mol", "A", "cd")  # the order of OpenFOAM's `dimensions`
NAMED = {(1, -1, -2): "Pa", (0, 0, 0): "1"}


@dataclass(frozen=True)
class GasField:
    """`values` in cells (faces, of a flux), [n] of a scalar, [n, components] of a vector or tensor, in `unit` at `time` [s].
    Where `uniform` they are one row, [1] or [1, components], which holds in all cells."""

    name: str
    time: float
    values: numpy.ndarray
    unit: str
    uniform: bool


def read(folder, name, time=None):
    """The `GasField` `name` at `time` [s] (default: the last) of the run in `folder`; InputError with what there is otherwise."""
    found = times(folder)
    chosen = _chosen(folder, found, time)
    path = foam_field.path_of(os.path.join(folder, chosen), name)
    if path is None:
        there = [each.removesuffix(".gz") for each in os.listdir(os.path.join(folder, chosen)) if each != "uniform"]
        raise no_such(os.path.join(folder, chosen), name, sorted(there))
    field = foam_field.internal_field(path)
    values = field.values[:, 0] if foam_field.COMPONENTS[field.kind] == 1 else field.values
    return GasField(name, found[chosen], values, _unit(foam_field.content(path)), field.uniform)


def _chosen(folder, found, time):
    """The name of the time folder that is asked for."""
    every = {**found, **times(os.path.join(folder, "processor0"))}
    if not every:
        raise InputError(f"{folder}: no fields of the gas were written; writeInterval in system/controlDict asks for them")
    chosen = max(every, key=every.get) if time is None else min(every, key=lambda name: abs(every[name] - time))
    if time is not None and not same_time(every[chosen], time):
        raise InputError(f"{folder}: no fields of the gas at {time:.9g} s; there are those of {', '.join(sorted(every, key=every.get))} s")
    if chosen not in found:
        raise InputError(f"{folder}: the gas at {chosen} s is in the pieces of its ranks: reconstructPar -case {folder} puts them together")
    return chosen


def _unit(data):
    """By the line `dimensions` of a field, in SI units: `m s-1`, `Pa`; nothing where there is none."""
    found = re.search(rb"\bdimensions\s+\[([-+.\d\s]+)\]", data)
    if found is None:
        return ""
    powers = [float(word) for word in found[1].split()]
    if not any(powers[3:]) and tuple(powers[:3]) in NAMED:
        return NAMED[tuple(powers[:3])]
    parts = [(unit, power) for unit, power in zip(BASE_UNITS, powers) if power]
    above = " ".join(unit + (f"{power:g}" if power != 1 else "") for unit, power in parts if power > 0)
    below = " ".join(unit + (f"{-power:g}" if power != -1 else "") for unit, power in parts if power < 0)
    return f"{above or '1'}/{below}" if below else above
