# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/report is to measure in a case: the block `statistics` of `system/couplingDict` (or an older case's `system/reportDict`), the box mesh of `system/blockMeshDict`, and
for what neither says the vessel and its spheres (report_vessel.py).

x goes across, y is the depth with the front wall at its low end, z is up. The keys and their defaults are in report_keys.py.
"""

import math
import os
from dataclasses import dataclass
from typing import Optional

from interphase.box_mesh import BoxMesh
from interphase.expanded_file import File, parameters_of
from interphase.input_error import InputError
from interphase.report_keys import KEYS

SCENE = "statistics of system/couplingDict"
EARLIER_SCENE = "system/reportDict"

WINDOWS_ACROSS = 5
# A window or a cell below this many diameters tells single spheres.
WINDOW_IN_DIAMETERS = 4.0
CELL_IN_DIAMETERS = 4.0
MOST_CELLS = 10**6
# A tree finds pairs within one distance: beyond this ratio of sizes it finds a hundred that do not touch for one that does.
WIDEST_SIZES = 5.0
DEFAULT_SHARES, DEFAULT_PERCENTILES = (0.001, 0.01, 0.05), (50.0, 90.0, 99.0)
DEFAULT_LIMITS = (0.4, 0.5, 0.8, 0.95)


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
class Voidage:
    """Histogram of `bins` bins from `lowest` to `highest`; `limits` divide the cells into shares.

    `mesh`: on which spheres are put where they lie; None where the voidage is that of the gas's cells, `cells` of them.
    """

    lowest: float
    highest: float
    bins: int
    limits: tuple
    mesh: Optional[BoxMesh]
    cells: int


@dataclass(frozen=True)
class Scene:
    """What is None is not measured."""

    windows: Optional[Windows]
    overlaps: Optional[Overlaps]
    voidage: Optional[Voidage]


def opened(folder, scene_file=None):
    """What the run in `folder` says of its statistics, or `scene_file`, its keys known to be right; nothing where neither says any.

    It is the block `statistics` of system/couplingDict; without one an older case's system/reportDict, with the same keys.
    """
    if scene_file and not os.path.isfile(scene_file):
        raise InputError(f"--scene {scene_file}: no such file")
    parameters = parameters_of(folder)
    if scene_file:
        file = File(scene_file, parameters)
    else:
        file = File(os.path.join(folder, "system/couplingDict"), parameters, block="statistics")
        if not file.given and os.path.isfile(os.path.join(folder, EARLIER_SCENE)):
            file = File(os.path.join(folder, EARLIER_SCENE), parameters)
    file.refuse_unknown(KEYS)
    return file


def start_of(file):
    """The entry `from` [s], None where there is none."""
    return None if file.entry("from") is None else file.number("from")


def scene_of(file, vessel, mesh):
    """(`Scene`, notes) of a file that `opened` gave.

    `vessel`: `Vessel` or None where none is known; `mesh`: the `BoxMesh` of the case, or the reason why there is none. What the file
    does not say, or where no part of it lies in the vessel, is the vessel's.
    """
    notes = []
    windows = _windows(file, vessel, notes) if _wanted(file, "windows") else None
    overlaps = _overlaps(file, vessel, notes) if _wanted(file, "overlaps") else None
    voidage = _voidage(file, vessel, mesh, notes) if _wanted(file, "voidage") else None
    return Scene(windows, overlaps, voidage), notes


def percentiles_of(file):
    """Of the overlaps, %."""
    found = file.ascending("overlaps/percentiles", DEFAULT_PERCENTILES)
    if any(not 0 < value < 100 for value in found):
        raise file.complaint("overlaps/percentiles", f"= {found}: give them in %, between 0 and 100")
    return found


def _wanted(file, block):
    return file.words(block) != ["none"]


def _along(file, vessel, axis, low, high, keys, notes):
    """Whether the range `low` to `high` [m] along `axis`, of which `keys` are given, has a part in the vessel; told where not all is."""
    given = [f"windows/{key}" for key in keys if file.entry(f"windows/{key}") is not None]
    if vessel is None or not given:
        return True
    name, slack = "xyz"[axis], 1e-6 * (vessel.high[axis] - vessel.low[axis])
    inside = high > vessel.low[axis] and low < vessel.high[axis]
    if not inside or low < vessel.low[axis] - slack or high > vessel.high[axis] + slack:
        notes.append(
            f"{' and '.join(given)} of {file.path}: {name} = {low:.4g} to {high:.4g} m is {'partly ' if inside else ''}outside "
            f"{vessel.whence}, {vessel.low[axis]:.4g} to {vessel.high[axis]:.4g} m" + ("" if inside else "; the default is taken")
        )
    return inside


def _windows(file, vessel, notes):
    def value(key, default):
        found = file.entry(f"windows/{key}") is not None
        if not found and default is None:
            raise InputError(f"{file.path}: add windows/{key} [m]: neither mesh nor snapshots of the run tell it")
        return file.number(f"windows/{key}", default)

    spheres = vessel is not None and vessel.largest is not None
    if not spheres and (file.entry("windows") is None or any(
            file.entry(f"windows/{key}") is None for key in ("centre", "height", "frontDepth"))):
        notes.append("no windows: no spheres tell where they would be")
        return None
    least = WINDOW_IN_DIAMETERS * vessel.largest if spheres else 0.0

    left, right = value("left", vessel and vessel.low[0]), value("right", vessel and vessel.high[0])
    if right <= left:
        raise file.complaint("windows/right", f"= {right:g} m is not right of windows/left = {left:g} m")
    if not _along(file, vessel, 0, left, right, ("left", "right"), notes):
        left, right = vessel.low[0], vessel.high[0]
    fitting = max(1, min(WINDOWS_ACROSS, int((right - left) / least))) if least else WINDOWS_ACROSS
    count = file.whole("windows/count", fitting)

    tall = None if vessel is None else min(max((right - left) / count, least), vessel.high[2] - vessel.low[2])
    height, centre = value("height", tall), value("centre", vessel and vessel.middle)
    deep = None if vessel is None or not spheres else min(vessel.largest, vessel.high[1] - vessel.low[1])
    front, depth = value("front", vessel and vessel.low[1]), value("frontDepth", deep)
    for name, length in (("height", height), ("frontDepth", depth)):
        if length <= 0:
            raise file.complaint(f"windows/{name}", f"= {length:g}: a length above 0 is expected [m]")
    if not _along(file, vessel, 2, centre - height / 2, centre + height / 2, ("centre", "height"), notes) and spheres:
        height, centre = tall, vessel.middle
    if not _along(file, vessel, 1, front, front + depth, ("front", "frontDepth"), notes) and spheres:
        front, depth = vessel.low[1], deep
    return Windows(count, left, right, centre, height, front, depth)


def _overlaps(file, vessel, notes):
    if file.entry("overlaps") is None and vessel is not None and vessel.largest is not None \
            and vessel.largest > WIDEST_SIZES * vessel.smallest:
        notes.append(f"overlaps are not measured: diameters of {vessel.smallest:.3g} to {vessel.largest:.3g} m take long; "
                     f"a block `overlaps {{ }}` in {SCENE} asks for them all the same")
        return None
    found = Overlaps(file.ascending("overlaps/shares", DEFAULT_SHARES), percentiles_of(file))
    if any(not value > 0 for value in found.shares):
        raise file.complaint("overlaps/shares", f"= {found.shares}: overlaps over the diameter are above 0, such as 0.01")
    return found


def _voidage(file, vessel, mesh, notes):
    own = [name for name in ("low", "high", "cells") if file.entry(f"voidage/{name}") is not None]
    wanted = None
    if own:
        low, high = file.numbers("voidage/low", 3), file.numbers("voidage/high", 3)
        cells = file.numbers("voidage/cells", 3)
        if any(n != int(n) or n < 1 for n in cells):
            raise file.complaint("voidage/cells", f"= {cells}: three whole numbers above 0 are expected")
        if any(a >= b for a, b in zip(low, high)):
            raise file.complaint("voidage/high", f"= {high} is not above voidage/low = {low} in each direction")
        wanted = BoxMesh(low, high, tuple(int(n) for n in cells))
        if vessel is not None and not all(a < d and c < b for a, b, c, d in zip(low, high, vessel.low, vessel.high)):
            notes.append(f"voidage/low and high of {file.path}: {low} to {high} m has no part in {vessel.whence}; the default is taken")
            wanted = None
    elif isinstance(mesh, BoxMesh) and (vessel is None or vessel.is_box(mesh.low, mesh.high)):
        wanted = mesh
    if wanted is None:
        wanted = _mesh_of(vessel, mesh, notes)
        if wanted is None:
            return None
    found = Voidage(
        file.number("voidage/lowest", 0.3), file.number("voidage/highest", 1.0), file.whole("voidage/bins", 70),
        file.ascending("voidage/limits", DEFAULT_LIMITS), wanted, math.prod(wanted.cells),
    )
    if not found.lowest < found.highest:
        raise file.complaint("voidage/highest", f"= {found.highest:g} is not above voidage/lowest = {found.lowest:g}")
    return found


def _mesh_of(vessel, mesh, notes):
    """A `BoxMesh` of the vessel's box, its cells some mean diameters wide; None, and told, where it cannot be."""
    if vessel is None or vessel.mean is None:
        notes.append("no voidage: no spheres tell how wide its cells should be")
        return None
    size = [high - low for low, high in zip(vessel.low, vessel.high)]
    cells = [max(1, round(edge / (CELL_IN_DIAMETERS * vessel.mean))) for edge in size]
    if math.prod(cells) > MOST_CELLS:
        notes.append(f"no voidage: {vessel.whence} would have {math.prod(cells):.3g} cells of four diameters; give "
                     f"`voidage {{ low (x y z); high (x y z); cells (nx ny nz); }}` in {SCENE}")
        return None
    why = "the case's blockMeshDict has another box" if isinstance(mesh, BoxMesh) else mesh
    notes.append(f"voidage is of {' x '.join(map(str, cells))} cells in {vessel.whence}, as {why}; "
                 "what of them is outside the vessel counts as empty")
    return BoxMesh(tuple(vessel.low), tuple(vessel.high), tuple(cells))
