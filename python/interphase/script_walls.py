# SPDX-License-Identifier: GPL-3.0-or-later
"""The walls that the particles of a run meet, by the commands which LIGGGHTS has written into dem/log.liggghts with all values put in.

What a script has taken away again (`unfix`) by the end of its log is left out. What is not understood is told in `notes`, not guessed.
"""

import os
from dataclasses import dataclass

import numpy

from interphase.input_error import InputError
from interphase.stl import read_stl

LOG = os.path.join("dem", "log.liggghts")
PRIMITIVES = {"xplane": 1, "yplane": 1, "zplane": 1, "xcylinder": 3, "ycylinder": 3, "zcylinder": 3}  # and how many numbers follow


@dataclass(frozen=True)
class Surface:
    """A mesh of triangles [n, 3, 3], m, where it starts. `wall`: particles bounce off it; others let them in or out.
    `motion`: the words of move/mesh, () at rest. `file`: its STL file from the run's folder on, to which `scale` and `move` [m] were done."""

    name: str
    triangles: numpy.ndarray
    wall: bool
    motion: tuple = ()
    file: str = ""
    scale: float = 1.0
    move: tuple = (0.0, 0.0, 0.0)

    def at(self, elapsed):
        """The triangles [n, 3, 3] at `elapsed` [s] after it was made; where they start, if `known` is False."""
        moved = _moved(self.triangles, self.motion, elapsed)
        return self.triangles if moved is None else moved

    @property
    def known(self):
        """Whether its place is known at all times."""
        return _moved(self.triangles, self.motion, 0.0) is not None


@dataclass(frozen=True)
class Primitive:
    """`style` xplane ... with its place [m]; xcylinder ... with radius and the two coordinates of its axis [m]."""

    style: str
    numbers: tuple


@dataclass(frozen=True)
class ScriptWalls:
    surfaces: tuple = ()
    primitives: tuple = ()
    notes: tuple = ()


def read(folder):
    """The `ScriptWalls` of the run in `folder`; none where LIGGGHTS has left no log."""
    try:
        with open(os.path.join(folder, LOG), encoding="utf-8", errors="replace") as stream:
            fixes = _fixes(stream.read())
    except OSError:
        return ScriptWalls()
    notes, surfaces, primitives = [], [], []
    walls = {name for words in fixes.values() if words[0].startswith("wall/") for name in _meshes_of(words)}
    motions = {}
    for words in fixes.values():
        if words[0] == "move/mesh" and "mesh" in words[1:-1]:
            motions.setdefault(words[words.index("mesh") + 1], []).append(words)
    for name, words in fixes.items():
        if words[0].startswith("mesh/surface"):
            try:
                file, scale, move = _placed(words)
                triangles = read_stl(os.path.join(folder, file)) * scale + numpy.array(move)
                if not len(triangles):
                    raise InputError(f"{file} holds no triangles")
            except InputError as error:
                notes.append(f"{name} is not drawn: {error}")
                continue
            # Motions add up in LIGGGHTS; of two, none is followed.
            moves = motions.get(name, [])
            motion = tuple(moves[0][moves[0].index("mesh") + 2:]) if len(moves) == 1 else ("several",) * bool(moves)
            surface = Surface(name, triangles, name in walls, motion, file, scale, move)
            if not surface.known:
                notes.append(f"{name} moves ({' '.join(motion)}): drawn where it starts")
            surfaces.append(surface)
        elif words[0].startswith("wall/") and "primitive" in words:
            primitive = _primitive(words)
            if primitive is None:
                notes.append(f"wall {name} is not drawn: {' '.join(words[words.index('primitive'):])}")
            else:
                primitives.append(primitive)
        elif words[0].startswith("wall/") and not _meshes_of(words):
            notes.append(f"wall {name} is not drawn: {' '.join(words)}")
    return ScriptWalls(tuple(surfaces), tuple(primitives), tuple(notes))


def _fixes(log):
    """{ID: [style, argument, ...]} of the fixes that are there at the end of a log. A line with variables comes again with each of them
    put in: the last one counts."""
    fixes = {}
    for line in log.replace("&\n", " ").splitlines():
        words = line.partition("#")[0].split()
        if len(words) > 3 and words[0] == "fix":
            fixes[words[1]] = words[3:]
        elif len(words) == 2 and words[0] == "unfix":
            fixes.pop(words[1], None)
    return fixes


def _meshes_of(words):
    """wall/... mesh n_meshes N meshes A B ..."""
    if "n_meshes" not in words or "meshes" not in words:
        return []
    count, at = words[words.index("n_meshes") + 1], words.index("meshes") + 1
    return words[at:at + int(count)] if count.isdigit() else []


def _placed(words):
    """(file, scale, move) of mesh/surface file F type N [scale S | move X Y Z]. In which order LIGGGHTS does more than one of these is not relied
    on."""
    if "file" not in words[:-1]:
        raise InputError("its command names no file")
    name = words[words.index("file") + 1]
    changes = [word for word in ("scale", "move", "rotate") if word in words]
    if len(changes) > 1 or "rotate" in changes:
        raise InputError(f"placed by {' and '.join(changes)}; one of scale and move is understood")
    if not name.lower().endswith(".stl"):
        raise InputError(f"{name} is no .stl file")
    try:
        scale = float(words[words.index("scale") + 1]) if "scale" in changes else 1.0
        move = tuple(float(word) for word in words[words.index("move") + 1:][:3]) if "move" in changes else (0.0, 0.0, 0.0)
    except (ValueError, IndexError):
        raise InputError(f"its place is not understood: {' '.join(words)}") from None
    return name, scale, move


def _primitive(words):
    at = next((n for n, word in enumerate(words) if word in PRIMITIVES), None)
    if at is None:
        return None
    try:
        numbers = tuple(float(word) for word in words[at + 1:at + 1 + PRIMITIVES[words[at]]])
    except ValueError:
        return None
    return Primitive(words[at], numbers) if len(numbers) == PRIMITIVES[words[at]] else None


def _moved(triangles, motion, elapsed):
    """The triangles after the motion of LIGGGHTS's move/mesh has gone on for `elapsed` [s]; None for one that is not known."""
    if not motion:
        return triangles
    try:
        if motion[0] == "linear":
            return triangles + numpy.array(motion[1:4], dtype=float) * elapsed
        if motion[0] == "wiggle":
            amplitude, period = numpy.array(motion[2:5], dtype=float), float(motion[motion.index("period") + 1])
            return triangles + amplitude * numpy.sin(2 * numpy.pi * elapsed / period)
        if motion[0] == "rotate":
            origin = numpy.array(motion[2:5], dtype=float)
            axis = numpy.array(motion[motion.index("axis") + 1:][:3], dtype=float)
            return _turned(triangles - origin, axis, 2 * numpy.pi * elapsed / float(motion[motion.index("period") + 1])) + origin
    except (ValueError, IndexError, ZeroDivisionError):
        pass
    return None


def _turned(points, axis, angle):
    """`points` [..., 3] turned about `axis` through the origin by `angle`, right-handed (Rodrigues)."""
    axis = axis / numpy.linalg.norm(axis)
    along = (points @ axis)[..., None] * axis
    return along + (points - along) * numpy.cos(angle) + numpy.cross(axis, points) * numpy.sin(angle)
