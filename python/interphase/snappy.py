# SPDX-License-Identifier: GPL-3.0-or-later
"""The gas mesh of a case whose vessel stands about the z axis, by snappyHexMesh in the current folder. Lengths in m."""

import math
import subprocess
import sys


def mesh_vessel(radius, height, cell):
    """A box of cubes of `cell` about the vessel (system/background/blockMeshDict, which includes the file `size` that is written here),
    cut and snapped by system/snappyHexMeshDict. Ends the program where one of OpenFOAM's fails."""
    side = math.ceil(radius / cell) + 1  # cells from the axis to the side, and a margin that snappyHexMesh cuts off
    up = math.ceil(height / cell) + 2
    with open("system/background/size", "w", encoding="utf-8") as file:
        file.write(f"// By prepare\nback {-side * cell!r};\nfront {side * cell!r};\nlow {-cell!r};\nhigh {(up - 1) * cell!r};\n"
                   f"cells ({2 * side} {2 * side} {up});\n")  # fmt: skip
    for program, *words in (("blockMesh", "-dict", "system/background/blockMeshDict"), ("snappyHexMesh", "-overwrite")):
        with open(f"log.{program}", "w", encoding="utf-8") as log:
            if subprocess.run([program, *words], stdout=log, stderr=subprocess.STDOUT).returncode != 0:
                sys.exit(f"prepare: {program} failed; see log.{program}")
