# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of a run: where it is by default, and which ones are refused."""

import os
import re

from interphase.input_error import InputError
from interphase.run_state import MARK
from interphase.tree import REPOSITORY


def default_folder(case_path, method, weight, ranks):
    name = f"{os.path.basename(case_path)}-{method}-w{weight:g}" + (f"-{ranks}ranks" if ranks > 1 else "")
    return os.path.join(REPOSITORY, "runs", name)


def check_folder(folder, case_path, overwrite):
    """Refuse a folder that the engines cannot take, or that holds what must not be lost."""
    unfit = re.search(r"[\s\"';{}$\\]", folder)
    if unfit:
        raise InputError(f"'{folder}': OpenFOAM bears no '{unfit[0]}' in a path; give another folder by --out DIR")
    inside = os.path.realpath(folder)
    case = os.path.realpath(case_path)
    if os.path.commonpath([inside, case]) in (inside, case):
        raise InputError(f"{folder}: the run's folder and the case {case_path} must lie apart; give another --out DIR")
    if not os.path.lexists(folder):
        return
    if not os.path.isdir(folder):
        raise InputError(f"{folder} is a file; give another folder by --out DIR")
    if not os.listdir(folder):
        return
    if not os.path.isfile(os.path.join(folder, MARK)):
        raise InputError(f"{folder} holds files that are no run of tools/run: they stay; give another folder by --out DIR")
    if not overwrite:
        raise InputError(f"{folder} holds an earlier run: --overwrite replaces it, --out DIR writes elsewhere")
