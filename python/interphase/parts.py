# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a run's folder: OpenFOAM's folders processor*, one for each rank, and those of times."""

import os
import re
import shutil

from interphase import case_folder, launch

ONE = re.compile(r"processor(\d+)")
TIME = re.compile(r"\d+(\.\d*)?([eE][-+]?\d+)?")
COLLATED = re.compile(r"processors(\d+)(_\d+-\d+)?")  # of all ranks, by OpenFOAM's file handler `collated`


def _named(folder, pattern):
    return [name for name in sorted(os.listdir(folder)) if pattern.fullmatch(name) and os.path.isdir(os.path.join(folder, name))]


def times(folder):
    """{name: time [s]} of the time folders in `folder`; none where it is not there."""
    return {name: float(name) for name in (_named(folder, TIME) if os.path.isdir(folder) else ())}


def ranks(folder):
    """The folders processor0, processor1, ... in `folder`, in order."""
    found = []
    while os.path.isdir(os.path.join(folder, f"processor{len(found)}")):
        found.append(os.path.join(folder, f"processor{len(found)}"))
    return found


def collated(folder):
    """Names of the folders that hold the parts of several ranks, written by OpenFOAM's `collated` file handler."""
    return _named(folder, COLLATED)


def number(folder):
    """The ranks that the folder is cut for; 1 where it is not."""
    return len(_named(folder, ONE)) or max([int(COLLATED.fullmatch(name)[1]) for name in collated(folder)], default=1)


def wrote_gas(folder):
    """Whether the parts hold a time after the start."""
    return any(time > 0 for part in ("processor0", *collated(folder)) for time in times(os.path.join(folder, part)).values())


def cut(folder, ranks, gas, step):
    """Cuts the folder for `ranks`; `step` runs a program."""
    if ranks == 1:
        return
    if gas != "none":
        step("decomposePar", "-case", folder, "-force")
    if not collated(folder):
        for rank in range(ranks):  # OpenFOAM wants them even where there is no mesh to be cut
            os.makedirs(os.path.join(folder, f"processor{rank}"), exist_ok=True)


def cut_anew(folder, ranks, gas, step, warn):
    """Cuts the folder of an earlier run for another number of ranks. The times that its parts hold are put together before; where that
    fails, the parts are put aside."""
    if number(folder) == ranks:
        return
    try:
        if gas != "none" and wrote_gas(folder):
            step("reconstructPar", "-case", folder, "-newTimes")
    except launch.StepFailed as error:
        aside = _free_name(os.path.join(folder, f"parts-of-{number(folder)}-ranks"))
        os.makedirs(aside)
        for name in _named(folder, ONE) + collated(folder):
            os.rename(os.path.join(folder, name), os.path.join(aside, name))
        warn(f"{error}\nthe parts of the ranks so far are in {aside}")
    for name in _named(folder, ONE) + collated(folder):
        shutil.rmtree(os.path.join(folder, name))
    if ranks > 1:
        dictionaries = case_folder.Dictionaries(folder)
        case_folder.set_number_of_subdomains(dictionaries, ranks)
        dictionaries.write_into(folder)
    cut(folder, ranks, gas, step)


def _free_name(path):
    free, n = path, 2
    while os.path.exists(free):
        free, n = f"{path}-{n}", n + 1
    return free
