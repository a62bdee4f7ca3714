# SPDX-License-Identifier: GPL-3.0-or-later
"""The stress as the fix has it: what its word `table` writes. ctest sets RUNNER (interphase-liggghts) and PLUGIN (the library)."""

import os
import subprocess
import tempfile

import numpy

SCRIPT = """
units           si
atom_style      granular
boundary        f f f
newton          off
communicate     single vel yes
region          box block 0 0.1 0 0.1 0 0.1 units box
create_box      1 box
fix             move all {style} {words} table table.txt
"""


def table(words, style="mp_pic/@NAME@", plugin=None):
    """Solid fractions and stresses [Pa] that a fix of that style has with these words of the script. AssertionError, with all that LIGGGHTS
    said, where it refuses them."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "in.script"), "w", encoding="utf-8") as file:
            file.write(SCRIPT.format(style=style, words=words))
        command = [os.environ["RUNNER"], "-plugin", plugin or os.environ["PLUGIN"], "-in", "in.script", "-log", "none"]
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=250)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        return numpy.loadtxt(os.path.join(folder, "table.txt"), unpack=True)
