# SPDX-License-Identifier: GPL-3.0-or-later
"""Which mesh a run has: the case's own where it has one, else what blockMesh makes of a dictionary."""

import os
import re

from interphase.case_folder import PARAMETERS
from interphase.input_error import InputError

MESH = "constant/polyMesh"
DICTIONARIES = ("system/blockMeshDict", "constant/polyMesh/blockMeshDict")


def has_mesh(folder):
    """A finished mesh of OpenFOAM's: its faces and points, compressed or not."""
    def there(name):
        return any(os.path.isfile(os.path.join(folder, MESH, name + end)) for end in ("", ".gz"))

    return there("points") and there("faces") and there("owner")


def dictionary_of(folder):
    """The name of the case's dictionary for blockMesh; None where it has none. InputError where it has two."""
    found = [name for name in DICTIONARIES if os.path.isfile(os.path.join(folder, name))]
    if len(found) > 1:
        raise InputError(f"the case has two dictionaries for blockMesh, {found[0]} and {found[1]}: remove one of them")
    return found[0] if found else None


def check_settings(case, changed):
    """A mesh that is there takes no notice of changes to its dictionary: InputError where --set makes one.

    `changed`: (file, entry) pairs, as --set names them.
    """
    if not has_mesh(case.folder):
        return
    dictionary = dictionary_of(case.folder)
    if dictionary is None:
        return
    used = set(re.findall(r"\$[:.]*\{?[:.]*(\w+)", case.text(dictionary)))
    for file, entry in changed:
        if file == dictionary or (file == PARAMETERS and entry in used):
            raise InputError(
                f"{entry} is of the mesh that {dictionary} describes, and the case has a finished one in {MESH}, which is used as it "
                f"is: remove {MESH}{' but for its dictionary' if dictionary.startswith(MESH) else ''} to have it made anew, or leave {entry} alone"
            )


def is_newer(case, dictionary):
    """Whether the dictionary, or the case's parameters, were written after the mesh."""
    def times(*names):
        return [os.stat(path).st_mtime for path in (os.path.join(case, name) for name in names) if os.path.isfile(path)]

    mesh = times(f"{MESH}/points", f"{MESH}/points.gz")
    return bool(mesh) and max(times(dictionary, PARAMETERS), default=0) > max(mesh)


def choose(folder, case, gas):
    """(program, what to say): the program that makes the mesh in the run's folder, or None where it is there; `case` is the folder
    that it was copied from, whose files have their times."""
    dictionary = dictionary_of(folder)
    if has_mesh(folder):
        told = f"mesh: {MESH} of the case, as it is"
        if dictionary:
            newer = ", though it is newer," if is_newer(case, dictionary) else ""
            told += f"; {dictionary}{newer} is not looked at (remove {MESH} to have the mesh made of it)"
        return None, told
    if dictionary:
        return "blockMesh", f"mesh: of {dictionary}, by blockMesh"
    raise InputError(
        f"the case has no mesh: no {MESH} with points, faces and owner, no dictionary {' or '.join(DICTIONARIES)}, and gas model '{gas}' needs "
        f"one: add a dictionary, or a mesh (of snappyHexMesh -overwrite, fluentMeshToFoam, ...) in {MESH}; gas {{ model none; }} runs particles alone"
    )
