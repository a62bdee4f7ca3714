# SPDX-License-Identifier: GPL-3.0-or-later
"""Read what LIGGGHTS's `fix ave/time ... file NAME` has written in a run's folder, such as the force on a mesh."""

import os

import numpy

from interphase.input_error import InputError


def read(run, name):
    """(time [s, n], values [n, columns]) of the file `name` of a `Run`; None where it is not there. Times are those of the ends of the means."""
    path = os.path.join(run.path, name)
    if not os.path.isfile(path):
        return None
    if "solid_step" not in run.meta:
        raise InputError(f"{run.path}: results.h5 does not tell the solid step, by which the steps of {name} are times")
    try:
        rows = numpy.loadtxt(path, comments="#", ndmin=2)
    except ValueError as error:
        raise InputError(f"{path}: no table of numbers, as fix ave/time writes it: {error}") from None
    return rows[:, 0] * float(run.meta["solid_step"]), rows[:, 1:]
