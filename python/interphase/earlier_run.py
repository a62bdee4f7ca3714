# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of tools/run that is to go on where its last checkpoint is."""

import os

from interphase import ending, foam_file, run_state
from interphase.case_folder import CONTROL
from interphase.input_error import InputError


def record_of(folder, case):
    """What tools/run wrote of the run in `folder`; refused where there is none, or one of another case."""
    record = run_state.record(folder)
    if not record:
        raise InputError(f"--resume: {folder} holds no run of tools/run; name its folder by --out DIR")
    if record.get("case") != case:
        raise InputError(f"--resume: {folder} holds a run of {record.get('case')}, not of {case}; name its folder by --out DIR")
    if not ending.has_checkpoint(folder):
        raise InputError(
            f"--resume: {folder} has no checkpoints: it ended before the first was due, or in an error; start it anew "
            "(--overwrite)"
        )
    return record


def set_end(folder, until):
    """The end time in the run's own controlDict, where it may differ from that of the run so far."""
    path = os.path.join(folder, CONTROL)
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(foam_file.replaced(text, "endTime", until))


def free_log(folder):
    """A name for the log of the next part."""
    number = 2
    while os.path.exists(os.path.join(folder, f"log.interphase-{number}")):
        number += 1
    return os.path.join(folder, f"log.interphase-{number}")
