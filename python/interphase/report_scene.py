# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/report is to measure in a case: `system/reportDict`, and the box mesh of `system/blockMeshDict`.

x goes across, y is the depth with the front wall at its low end, z is up. `$name` is looked up in the file itself, then
in the case's `parameters`. A block that is left out (windows, overlaps, voidage) is not measured.
"""

import math
import os
from dataclasses import dataclass
from typing import Optional

from interphase import foam_file
from interphase.case_folder import PARAMETERS
from interphase.foam_file import Dictionary, FoamFileError
from interphase.input_error import InputError

SCENE, MESH = "system/reportDict", "system/blockMeshDict"

# The keys of each block, "" the file itself.
KEYS = {
    "": ("from", "windows", "overlaps", "voidage"),
    "windows": ("count", "left", "right", "centre", "height", "front", "frontDepth"),
    "overlaps": ("shares", "percentiles"),
    "voidage": ("lowest", "highest", "bins", "limits", "low", "high", "cells"),
}


@dataclass(frozen=True)
class Windows:
    """`count` windows side by side in x from `left` to `right`, `height` high about z = `centre` [m].

    `front`: y of the front wall; `front_depth`: depth of the slice behind it [m].
    """

    count: int
    left: float
    right: float
    centre: float
    height: float
    front: float
    front_depth: float


@dataclass(frozen=True)
class Overlaps:
    """`shares`: overlaps (over the diameter) below which the share is asked for; `percentiles` in %."""

    shares: tuple
    percentiles: tuple


@dataclass(frozen=True)
class BoxMesh:
    """A uniform mesh of boxes: corners [m] and numbers of cells along x, y, z."""

    low: tuple
    high: tuple
    cells: tuple

    @property
    def cell_volume(self):
        return math.prod((high - low) / n for low, high, n in zip(self.low, self.high, self.cells))


@dataclass(frozen=True)
class Voidage:
    """Histogram of `bins` bins from `lowest` to `highest`; `limits` divide the cells into shares."""

    lowest: float
    highest: float
    bins: int
    limits: tuple
    mesh: BoxMesh


@dataclass(frozen=True)
class Scene:
    """`start`: what comes before it is left out [s]. What is None is not measured."""

    start: float
    windows: Optional[Windows]
    overlaps: Optional[Overlaps]
    voidage: Optional[Voidage]


class _File:
    """A dictionary with its macros expanded; complaints name the file."""

    def __init__(self, path, parameters=None):
        """`parameters`: the `_File` to look macros up in that this file does not define."""
        self.path, self.parameters = path, parameters
        try:
            with open(path, encoding="utf-8") as stream:
                self.text = stream.read()
            self.root = foam_file.parse(self.text)
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
        except FoamFileError as error:
            raise InputError(f"{path}: {error}") from None

    def complaint(self, name, message):
        entry = self.entry(name)
        known = entry is not None and not isinstance(entry, Dictionary)
        line = f", line {foam_file.line_of(self.text, entry.start)}" if known else ""
        return InputError(f"{self.path}{line}: {name} {message}")

    def entry(self, name):
        level = self.root
        for part in name.split("/"):
            found = level.all_named(part) if isinstance(level, Dictionary) else []
            if not found:
                return None
            level = found[0]
        return level

    def words(self, name, depth=0):
        """The words of the value at `name`, macros expanded; None where there is none."""
        entry = self.entry(name)
        if entry is None or isinstance(entry, Dictionary):
            return None
        found = []
        for token in foam_file.tokens(entry.value):
            if not token.text.startswith("$"):
                found.append(token.text)
                continue
            macro = token.text.lstrip("$:.").strip("{}")
            words = None
            if depth < 10:
                words = self.words(macro, depth + 1)
                if words is None and self.parameters is not None:
                    words = self.parameters.words(macro, depth + 1)
            if words is None:
                where = f" or {self.parameters.path}" if self.parameters is not None else ""
                raise self.complaint(name, f"= {entry.value}: {token.text} is not in this file{where}")
            found += words
        return found

    def number(self, name, default=None):
        words = self.words(name)
        if words is None:
            if default is None:
                raise InputError(f"{self.path}: no entry {name}: add one")
            return default
        try:
            value = float(words[0]) if len(words) == 1 else math.nan
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise self.complaint(name, f"= {' '.join(words)}: one number is expected")
        return value

    def whole(self, name, default=None):
        value = self.number(name, default)
        if value != int(value) or value < 1:
            raise self.complaint(name, f"= {value:g}: a whole number above 0 is expected")
        return int(value)

    def numbers(self, name, count=None):
        """A list `(a b ...)` of numbers, `count` of them if given."""
        words = self.words(name)
        if words is None:
            raise InputError(f"{self.path}: no entry {name}: add one")
        try:
            if words[:1] != ["("] or words[-1:] != [")"]:
                raise ValueError
            values = tuple(float(word) for word in words[1:-1])
        except ValueError:
            values = (math.nan,)
        if not all(map(math.isfinite, values)) or (count is not None and len(values) != count):
            many = f"{count} numbers" if count else "numbers"
            raise self.complaint(name, f"= {' '.join(words)}: a list of {many} in parentheses is expected")
        return values

    def ascending(self, name):
        values = self.numbers(name)
        if any(later <= earlier for earlier, later in zip(values, values[1:])):
            raise self.complaint(name, f"= {values}: values must ascend")
        return values

    def refuse_unknown(self):
        for block, keys in KEYS.items():
            level = self.entry(block) if block else self.root
            for key in level.names() if level is not None else ():
                name = f"{block}/{key}" if block else key
                if name == "FoamFile":
                    continue
                if key not in keys:
                    raise self.complaint(name, f"is unknown: {foam_file.nearest(key, keys)}")
                if isinstance(self.entry(name), Dictionary) != (name in KEYS):
                    wanted = "a block { ... }" if name in KEYS else "a value, not a block"
                    raise self.complaint(name, f"must be {wanted}")


def _parameters(folder):
    path = os.path.join(folder, PARAMETERS)
    return _File(path) if os.path.isfile(path) else None


def _box_mesh(folder, parameters):
    """The `BoxMesh` of system/blockMeshDict, or the reason why there is none."""
    path = os.path.join(folder, MESH)
    if not os.path.isfile(path):
        return f"there is no {path}"
    file = _File(path, parameters)
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


def read(folder, scene_file=None):
    """The `Scene` of the run in `folder`, from its system/reportDict or from `scene_file`."""
    path = scene_file or os.path.join(folder, SCENE)
    if not os.path.isfile(path):
        if scene_file:
            raise InputError(f"--scene {scene_file}: no such file")
        raise InputError(
            f"{path}: no such file: it says what to measure, see cases/sscp1/{SCENE}; put one into the case, or name one "
            "by --scene FILE"
        )
    parameters = _parameters(folder)
    file = _File(path, parameters)
    file.refuse_unknown()
    mesh = _box_mesh(folder, parameters)
    start = file.number("from", 0.0)
    windows = _windows(file, mesh) if file.entry("windows") is not None else None
    overlaps = _overlaps(file) if file.entry("overlaps") is not None else None
    voidage = _voidage(file, mesh) if file.entry("voidage") is not None else None
    return Scene(start, windows, overlaps, voidage)


def _windows(file, mesh):
    front = mesh.low[1] if isinstance(mesh, BoxMesh) else None
    if front is None and file.entry("windows/front") is None:
        raise InputError(f"{file.path}: add windows/front, the y of the front wall [m]; the mesh does not tell it: {mesh}")
    found = Windows(
        file.whole("windows/count"), file.number("windows/left"), file.number("windows/right"),
        file.number("windows/centre"), file.number("windows/height"), file.number("windows/front", front),
        file.number("windows/frontDepth"),
    )
    if found.right <= found.left:
        raise file.complaint("windows/right", f"= {found.right:g} m is not right of windows/left = {found.left:g} m")
    for name, value in (("height", found.height), ("frontDepth", found.front_depth)):
        if value <= 0:
            raise file.complaint(f"windows/{name}", f"= {value:g}: a length above 0 is expected [m]")
    return found


def _overlaps(file):
    found = Overlaps(file.ascending("overlaps/shares"), file.ascending("overlaps/percentiles"))
    if any(not value > 0 for value in found.shares):
        raise file.complaint("overlaps/shares", f"= {found.shares}: overlaps over the diameter are above 0, such as 0.01")
    if any(not 0 < value < 100 for value in found.percentiles):
        raise file.complaint("overlaps/percentiles", f"= {found.percentiles}: give them in %, between 0 and 100")
    return found


def _voidage(file, mesh):
    own = [name for name in ("low", "high", "cells") if file.entry(f"voidage/{name}") is not None]
    if own:
        low, high = file.numbers("voidage/low", 3), file.numbers("voidage/high", 3)
        cells = file.numbers("voidage/cells", 3)
        if any(n != int(n) or n < 1 for n in cells):
            raise file.complaint("voidage/cells", f"= {cells}: three whole numbers above 0 are expected")
        if any(a >= b for a, b in zip(low, high)):
            raise file.complaint("voidage/high", f"= {high} is not above voidage/low = {low} in each direction")
        mesh = BoxMesh(low, high, tuple(int(n) for n in cells))
    elif not isinstance(mesh, BoxMesh):
        raise InputError(
            f"{file.path}: voidage is taken on a uniform mesh of boxes, but {mesh}; give one by `low (x y z); "
            "high (x y z); cells (nx ny nz);` in the block voidage, or leave the block out"
        )
    found = Voidage(
        file.number("voidage/lowest", 0.3), file.number("voidage/highest", 1.0), file.whole("voidage/bins", 70),
        file.ascending("voidage/limits"), mesh,
    )
    if not found.lowest < found.highest:
        raise file.complaint("voidage/highest", f"= {found.highest:g} is not above voidage/lowest = {found.lowest:g}")
    return found
