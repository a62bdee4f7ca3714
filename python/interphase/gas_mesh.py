# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh of the gas, whole or in the pieces of its ranks, and its cut by an upright plane. Cells and faces may have any number of corners."""

import os
import re
from dataclasses import dataclass

import numpy

from interphase import foam_field
from interphase.input_error import InputError
from interphase.parts import ranks, times

# Patches of one layer of cells in y, or that join pieces: no place where the vessel ends.
INNER = ("processor", "processorCyclic", "empty", "cyclic", "cyclicAMI", "wedge", "symmetry", "symmetryPlane")

CLOSED = ("slip", "noSlip", "movingWallVelocity", "partialSlip")  # conditions of a velocity through which nothing passes


@dataclass(frozen=True)
class Patch:
    name: str
    kind: str  # OpenFOAM's type: wall, patch, ...
    start: int
    count: int


@dataclass(frozen=True)
class GasMesh:
    """`points` [n, 3], m; the corners of face f are `corners[first[f]:first[f + 1]]`; `owner` [faces] and `neighbour` [inner faces] are cells."""

    points: numpy.ndarray
    corners: numpy.ndarray
    first: numpy.ndarray
    owner: numpy.ndarray
    neighbour: numpy.ndarray
    patches: tuple

    @property
    def volumes(self):
        """[cells], m3: by the triangles between each face's corners and their mean."""
        counts = numpy.diff(self.first)
        face = numpy.repeat(numpy.arange(len(counts)), counts)
        following = numpy.arange(1, len(self.corners) + 1)
        following[self.first[1:] - 1] = self.first[:-1]
        a, b = self.points[self.corners], self.points[self.corners[following]]
        middle = numpy.add.reduceat(a, self.first[:-1]) / counts[:, None]
        normal = numpy.cross(a - middle[face], b - middle[face]) / 2
        # by the divergence theorem; about the mesh's middle, so that little cancels
        outward = numpy.einsum("ij,ij->i", (a + b + middle[face]) / 3 - self.points.mean(axis=0), normal) / 3
        of_face = numpy.bincount(face, outward, len(counts))
        own = numpy.bincount(self.owner, of_face, self.cells)
        return own - numpy.bincount(self.neighbour, of_face[:len(self.neighbour)], self.cells)

    @property
    def cells(self):
        """Their number."""
        return int(max(self.owner.max(initial=-1), self.neighbour.max(initial=-1))) + 1


@dataclass(frozen=True)
class Cut:
    """A mesh cut by a plane y = constant: `segments` [n, 2 ends, 2 (x, z)] in m, one of each face that it meets, of number `face` [n]."""

    segments: numpy.ndarray
    face: numpy.ndarray


def pieces(folder):
    """The folders that together hold the mesh of the run in `folder`: itself, or its processor folders; [] where there is no mesh."""
    if _has_mesh(folder):
        return [folder]
    return [each for each in ranks(folder) if _has_mesh(each)]


def _has_mesh(folder):
    return all(foam_field.mesh_file(folder, name) for name in ("points", "faces", "owner", "neighbour", "boundary"))


def read(folder):
    """The `GasMesh` in constant/polyMesh of `folder`; InputError where its files cannot be read."""
    def path(name):
        found = foam_field.mesh_file(folder, name)
        if found is None:
            raise InputError(f"{os.path.join(folder, 'constant/polyMesh')}: has no file {name}")
        return found

    points = foam_field.whole_list(path("points"), foam_field.content(path("points")), 3)
    corners, first = _faces(path("faces"))
    return GasMesh(points, corners, first, labels(path("owner")), labels(path("neighbour")), _patches(path("boundary")))


def labels(path):
    """The whole numbers [n] of a file of a mesh: owner, cellProcAddressing, ..."""
    return foam_field.whole_list(path, foam_field.content(path), 1, labels=True)[:, 0].astype(int)


def _faces(path):
    """(corners, first) of `GasMesh`: of a list of faces, or of a compact list (two lists of labels), which binary files hold."""
    data = foam_field.content(path)
    if foam_field.header(data, "class") == "faceCompactList":
        first = foam_field.whole_list(path, data, 1, labels=True)[:, 0].astype(int)
        head, body = data[:len(data) - len(foam_field.body(data))], foam_field.body(data)
        found = re.search(rb"(?:^|\n)\s*(\d+)\s*\(", body)
        width = (first.size * (8 if b"label=64" in head else 4) if foam_field.header(data, "format") == "binary"
                 else body.index(b")", found.end()) - found.end())  # fmt: skip
        rest = head + b"\n" + body[found.end() + width + 1:]
        return foam_field.whole_list(path, rest, 1, labels=True)[:, 0].astype(int), first
    body = foam_field.body(data)
    faces = [numpy.array(found.split(), dtype=int) for found in re.findall(rb"\d+\s*\(([\d\s]+)\)", body)]
    if not faces:
        raise InputError(f"{path}: holds no faces")
    return numpy.concatenate(faces), numpy.concatenate([[0], numpy.cumsum([len(face) for face in faces])])


def _patches(path):
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", foam_field.body(foam_field.content(path)).decode("utf-8", "replace"), flags=re.S)
    found = []
    for name, entries in re.findall(r"([^\s{}()]+)\s*\{([^{}]*)\}", text):
        values = dict(re.findall(r"(\w+)\s+([^;]+);", entries))
        found.append(Patch(name, values.get("type", "patch"), int(values["startFace"]), int(values["nFaces"])))
    return tuple(found)


def cut(mesh, y):
    """The `Cut` of the mesh at `y` [m]. A corner in the plane counts as behind it, so that each convex face is met at two of its edges or not at all;
    others, which turn inwards, are left out."""
    counts = numpy.diff(mesh.first)
    face = numpy.repeat(numpy.arange(len(counts)), counts)
    following = numpy.arange(1, len(mesh.corners) + 1)
    following[mesh.first[1:] - 1] = mesh.first[:-1]
    start, end = mesh.points[mesh.corners], mesh.points[mesh.corners[following]]
    from_plane, to_plane = start[:, 1] - y, end[:, 1] - y
    crossed = numpy.flatnonzero((from_plane >= 0) != (to_plane >= 0))
    share = (from_plane[crossed] / (from_plane[crossed] - to_plane[crossed]))[:, None]
    place = (start[crossed] + share * (end[crossed] - start[crossed]))[:, (0, 2)]
    faces, at, times = numpy.unique(face[crossed], return_index=True, return_counts=True)
    two = times == 2
    return Cut(numpy.stack([place[at[two]], place[at[two] + 1]], axis=1), faces[two])


def polygons(mesh, section):
    """(cells [n], corners of each [n] arrays [k, 2] (x, z) in m): what the plane of the `Cut` meets of the cells. They are convex."""
    inner = section.face < len(mesh.neighbour)
    cell = numpy.concatenate([mesh.owner[section.face], mesh.neighbour[section.face[inner]]])
    ends = numpy.concatenate([section.segments, section.segments[inner]]).reshape(-1, 2)
    cell = numpy.repeat(cell, 2)
    if not len(cell):
        return cell, []
    count = numpy.bincount(cell)
    middle = numpy.stack([numpy.bincount(cell, ends[:, axis]) for axis in (0, 1)], axis=1) / numpy.maximum(count, 1)[:, None]
    spoke = ends - middle[cell]
    order = numpy.lexsort((numpy.arctan2(spoke[:, 1], spoke[:, 0]), cell))
    found, start = numpy.unique(cell[order], return_index=True)
    return found, numpy.split(ends[order], start[1:])


def closed_patches(folder):
    """Names of patches that gas does not pass though they are of no type wall, by the conditions of the velocity that was written last; those of
    0/U, where names may be patterns, are what the case asks for. () where none is read."""
    written = sorted(((time, os.path.join(base, name)) for base in [folder, *ranks(folder)[:1]] for name, time in times(base).items()),
                     reverse=True)  # fmt: skip
    path = next(filter(None, (foam_field.path_of(each, "U") for _, each in written)), None)
    conditions = foam_field.content(path).partition(b"boundaryField")[2] if path else b""
    found = re.findall(rb'([^\s{}"]+)"?\s*\{\s*type\s+(\w+)\s*;', conditions)
    return tuple(name.decode("utf-8", "replace") for name, kind in found if kind.decode() in CLOSED)


def boundary(mesh, section, closed=()):
    """{kind: segments [n, 2, 2]} of the cut through the patches: "wall", of that type or of a name in `closed` (patterns), and "open"."""
    found = {"wall": [], "open": []}
    for patch in mesh.patches:
        if patch.kind in INNER:
            continue
        inside = (section.face >= patch.start) & (section.face < patch.start + patch.count)
        wall = patch.kind == "wall" or any(name == patch.name or re.fullmatch(name, patch.name) for name in closed)
        found["wall" if wall else "open"].append(section.segments[inside])
    return {kind: numpy.concatenate(each) if each else numpy.zeros((0, 2, 2)) for kind, each in found.items()}
