# SPDX-License-Identifier: GPL-3.0-or-later
"""The uniform mesh of boxes that a case's system/blockMeshDict makes, where it makes one."""

import math
import os
from dataclasses import dataclass

from interphase.expanded_file import File, parameters_of

MESH = "system/blockMeshDict"


@dataclass(frozen=True)
class BoxMesh:
    """A uniform mesh of boxes: corners [m] and numbers of cells along x, y, z."""

    low: tuple
    high: tuple
    cells: tuple

    @property
    def cell_volume(self):
        """Of each cell, m3."""
        return math.prod((high - low) / n for low, high, n in zip(self.low, self.high, self.cells))


def box_mesh(folder):
    """The `BoxMesh` of system/blockMeshDict, or the reason why there is none."""
    path = os.path.join(folder, MESH)
    if not os.path.isfile(path):
        return f"there is no {path}"
    file = File(path, parameters_of(folder))
    blocks = file.words("blocks") or []
    opened = [at for at, word in enumerate(blocks) if word == "hex"]
    if len(opened) != 1:
        return f"{path} has {len(opened)} blocks"
    try:
        numbers = [float(w) for w in file.words("vertices") or [] if w not in ("(", ")")]
        words = blocks[opened[0] + 1:]
        first = words.index(")")
        corners = [int(w) for w in words[1:first]]
        cells = [int(w) for w in words[first + 2:first + 5]]
        grading = words[first + 6:]
        scale = file.number("scale", file.number("convertToMeters", 1.0))
    except ValueError:
        return f"{path}: vertices and block are more than plain numbers"
    if len(corners) != 8 or len(cells) != 3 or min(cells) < 1 or len(numbers) % 3 or max(corners) >= len(numbers) // 3:
        return f"{path}: no block of eight corners and three numbers of cells"
    if grading[:1] not in (["simpleGrading"], ["edgeGrading"]) or any(w not in ("1", "(", ")") for w in grading[1:]):
        return f"the block of {path} is graded"
    points = [tuple(scale * v for v in numbers[3 * c:3 * c + 3]) for c in corners]
    low, high = (tuple(f(p[axis] for p in points) for axis in range(3)) for f in (min, max))
    # The first corners of a `hex` lie along its first, second and third direction from corner 0.
    around = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    expected = [(x, y, z) for z in (low[2], high[2]) for x, y in around]
    if points != expected or any(a >= b for a, b in zip(low, high)):
        return f"the block of {path} is no upright box, its first corner the lowest in x, y and z"
    return BoxMesh(low, high, tuple(cells))
