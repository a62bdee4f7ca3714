# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a run as ParaView opens them."""

import os
import pprint

from interphase.input_error import InputError

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "paraview_view.py")


def foam_file(folder):
    """The name of the empty file *.foam by which ParaView opens the gas; it is made where there is none."""
    found = sorted(name for name in os.listdir(folder) if name.endswith(".foam"))
    if found:
        return found[0]
    name = os.path.basename(os.path.abspath(folder)) + ".foam"
    try:
        with open(os.path.join(folder, name), "w", encoding="ascii"):
            return name
    except OSError as error:
        raise InputError(f"{os.path.join(folder, name)}: cannot be written: {error.strerror}; ParaView opens the gas by it") from None


def surfaces(scene):
    """[(name of the STL file in the run's folder, scale, move [3] in m)] of the particles' meshes."""
    return [(each.file, each.scale, list(each.move)) for each in scene.walls.script.surfaces]


def literal(known):
    """A dict as Python writes it."""
    return pprint.pformat(known, width=120, sort_dicts=False)
