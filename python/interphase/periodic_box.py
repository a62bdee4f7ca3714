# SPDX-License-Identifier: GPL-3.0-or-later
"""Which directions of a run's vessel repeat, and over which length."""

import numpy

from interphase.case_folder import Dictionaries
from interphase.input_error import InputError
from interphase.particle_script import particle_source
from interphase.particle_states import Box


def of_run(run):
    """The `Box` of `Records` in which some direction repeats; None where none does, or where the run does not tell (no gas, hence no length)."""
    try:
        periodic = particle_source(Dictionaries(run.path), missing=[]).periodic
    except (InputError, OSError):  # particles of another program, or a folder without its case
        return None
    if not any(periodic) or "domain" not in run.meta:
        return None
    low, high = numpy.asarray(run.meta["domain"], dtype=float).reshape(2, 3)
    return Box(tuple(low), tuple(high - low), tuple(periodic))
