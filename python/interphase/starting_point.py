# SPDX-License-Identifier: GPL-3.0-or-later
"""A prepared case that starts with particles and gas of a run: what tools/run --from does, and tools/bench and tools/gas-study use."""

import os
import re

from interphase import foam_field, parts, starting_gas, starting_particles, starting_run
from interphase.case_folder import CONTROL, COUPLING, Dictionaries
from interphase.input_error import InputError
from interphase.particle_script import particle_source


def checked(text, case, name, method, weight, folder):
    """The `StartingRun` that RUN[@time] names, for `case` (Dictionaries) with `method` and `weight`, to run in `folder`.

    InputError for what can be seen before the case is prepared.
    """
    start = starting_run.find(text)
    inside = [os.path.realpath(path) for path in (start.folder, folder)]
    if os.path.commonpath(inside) in inside:
        raise InputError(f"--from: {start.folder} and the new run's folder {folder} must lie apart; give another one by --out DIR")
    starting_particles.check_weight(start, weight, name)
    starting_particles.check_springs(start, method)
    source = particle_source(case, missing=[])
    if source.file or source.others:
        starting_particles.check_script(source, name)
    if begins := _begins_late(case):
        raise InputError(f"--from: {name} begins at {begins}; the clock of a run that starts from another one begins at 0: set startFrom "
                        "startTime and startTime 0 in system/controlDict")
    return start


def _begins_late(case):
    """What makes the case begin at another time than 0; None where nothing does."""
    zero = re.compile(r"0*\.?0*")
    if case.value(CONTROL, "startFrom", "latestTime") == "startTime":
        begins = case.value(CONTROL, "startTime", "0")
        return None if zero.fullmatch(begins) else f"startTime {begins} s of system/controlDict"
    later = [name for name, time in parts.times(case.folder).items() if time > 0]
    return f"a time folder that it has, {', '.join(sorted(later, key=float)[:3])}" if later else None


def put(start, folder, name, gas, environment, say, moved=0.0):
    """Particles and, unless `gas` is none, gas of the `StartingRun` into the case `name` that is prepared, with its mesh, in `folder`;
    particles moved by `moved` [m] along x. Returns what run.json is to tell of it."""
    before = starting_particles.put(start, folder, name, moved)
    count = len(start.particles.ids)
    say(f"from {start.where}: {count} spheres" + (f", where {name} has {before}" if before != count else ""))
    told = None
    if gas != "none":
        refuse_outside_of_mesh(start, folder, name)
        told = starting_gas.put(start, folder, environment)
        say(told)
    return {**start.provenance(), "gas": told}


def refuse_outside_of_mesh(start, folder, name):
    """Centres more than a radius out of the mesh's box; the program looks at cells, and at those that are nearer."""
    case = Dictionaries(folder)
    points = foam_field.points(folder)
    if points is None or case.value(COUPLING, "outsideMesh", "stop") == "ignore":
        return
    state = start.particles.quantities
    reach = state["diameter"][:, None] / 2
    low, high = points.min(axis=0), points.max(axis=0)
    inside = starting_particles.source_holds(state["position"], low - reach, high + reach, particle_source(case).periodic)
    starting_particles.refuse_outside(~inside, start, state["position"], f"the gas mesh of {name}", low, high)
