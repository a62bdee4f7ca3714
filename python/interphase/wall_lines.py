# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls seen from the front (x to the right, z up), as lines: cut by the middle plane, and the edges of what stands in the vessel."""

from dataclasses import dataclass

import numpy

from interphase import gas_mesh

SHARP = 35.0  # degrees between two triangles whose edge is drawn; the facets of a round wall meet at less
ROUND = 96  # corners of a circle
# From the middle of the depth: a plane that lies in a layer of corners would cut the cells on either side by turns.
BESIDE = 1e-4


@dataclass(frozen=True)
class Lines:
    """`segments` [n, 2 ends, 2 (x, z)], m. `kind`: wall and open, of the gas mesh; solid, solid edge and passage, of the particles' meshes
    and walls (a passage lets particles in or out)."""

    kind: str
    segments: numpy.ndarray


class Walls:
    """All walls of a run: `script`, a `ScriptWalls`, and the cuts of the gas mesh by `y` [m]."""

    def __init__(self, script, meshes, depth, closed=()):
        """`meshes`: the `GasMesh`es, pieces of one; `depth`: (front, back) in y, m; `closed`: names of patches that gas does not pass."""
        self.script, self.closed = script, closed
        self.y = 0.5 * (depth[0] + depth[1]) + BESIDE * (depth[1] - depth[0])
        self.gas = [(mesh, gas_mesh.cut(mesh, self.y)) for mesh in meshes]

    @property
    def known(self):
        return bool(self.gas or self.script.surfaces or self.script.primitives)

    def bounds(self):
        """(low, high) corners [3] of walls that bound the vessel, NaN where none does: meshes of the particles, and planes."""
        low, high = numpy.full(3, numpy.nan), numpy.full(3, numpy.nan)
        corners = [each.triangles.reshape(-1, 3) for each in self.script.surfaces]
        for primitive in self.script.primitives:
            if primitive.style.endswith("plane"):
                place = numpy.full((1, 3), numpy.nan)
                place[0, "xyz".index(primitive.style[0])] = primitive.numbers[0]
                corners.append(place)
        if corners:
            every = numpy.concatenate(corners)
            there = numpy.isfinite(every).any(axis=0)
            low[there], high[there] = numpy.nanmin(every[:, there], axis=0), numpy.nanmax(every[:, there], axis=0)
        return low, high

    def lines(self, elapsed, view):
        """`Lines` at `elapsed` [s] after the start, in the `view` (left, right, bottom, top), m."""
        found = []
        for mesh, section in self.gas:
            found += [Lines(kind, segments) for kind, segments in gas_mesh.boundary(mesh, section, self.closed).items()]
        for primitive in self.script.primitives:
            found.append(Lines("solid", _primitive(primitive, self.y, view)))
        for surface in self.script.surfaces:
            triangles = surface.at(elapsed)
            found.append(Lines("solid" if surface.wall else "passage", section_of(triangles, self.y)))
            found.append(Lines("solid edge" if surface.wall else "passage", edges_of(triangles)))
        return [each for each in found if len(each.segments)]


def section_of(triangles, y):
    """Segments [n, 2, 2] in which the plane at `y` cuts `triangles` [k, 3, 3]."""
    distance = triangles[:, :, 1] - y
    ends = []
    crossed = []
    for a, b in ((0, 1), (1, 2), (2, 0)):
        cut = (distance[:, a] >= 0) != (distance[:, b] >= 0)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            share = (distance[:, a] / (distance[:, a] - distance[:, b]))[:, None]
            ends.append((triangles[:, a] + share * (triangles[:, b] - triangles[:, a]))[:, (0, 2)])
        crossed.append(cut)
    crossed, ends = numpy.array(crossed), numpy.array(ends)
    met = numpy.flatnonzero(crossed.sum(axis=0) == 2)
    first = numpy.argmax(crossed[:, met], axis=0)
    last = 2 - numpy.argmax(crossed[::-1, met], axis=0)
    return numpy.stack([ends[first, met], ends[last, met]], axis=1)


def edges_of(triangles):
    """Segments [n, 2, 2]: edges of one triangle alone, sharp ones, and those between a triangle that faces us and one that does not."""
    size = numpy.ptp(triangles.reshape(-1, 3), axis=0).max() or 1.0
    _, corner = numpy.unique(numpy.round(triangles.reshape(-1, 3) / size, 7), axis=0, return_inverse=True)
    corner = corner.reshape(-1, 3)
    place = numpy.zeros((corner.max() + 1, 3))
    place[corner.reshape(-1)] = triangles.reshape(-1, 3)
    normal = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = numpy.linalg.norm(normal, axis=1)
    normal /= numpy.where(length > 0, length, 1)[:, None]
    pairs = numpy.sort(numpy.concatenate([corner[:, (0, 1)], corner[:, (1, 2)], corner[:, (2, 0)]]), axis=1)
    owner = numpy.tile(numpy.arange(len(triangles)), 3)
    edges, which, count = numpy.unique(pairs, axis=0, return_inverse=True, return_counts=True)
    which = which.reshape(-1)
    order = numpy.argsort(which, kind="stable")
    start = numpy.concatenate([[0], numpy.cumsum(count)[:-1]])
    one = normal[owner[order[start]]]
    other = normal[owner[order[start + numpy.minimum(count, 2) - 1]]]
    # Surfaces without thickness have no inside that the order of their corners could agree on: normals count without their sign, but for outlines.
    sharp = numpy.abs((one * other).sum(axis=1)) < numpy.cos(numpy.radians(SHARP))
    outline = (one[:, 1] > 1e-9) & (other[:, 1] < -1e-9) | (one[:, 1] < -1e-9) & (other[:, 1] > 1e-9)
    drawn = (count != 2) | sharp | outline
    return place[edges[drawn]][:, :, (0, 2)]


def _primitive(primitive, y, view):
    """Segments [n, 2, 2] of a wall without ends, over the whole view; of a plane that faces us, and a cylinder beside the plane of the cut, none."""
    left, right, bottom, top = view
    axis, numbers = primitive.style[0], primitive.numbers
    if primitive.style.endswith("plane"):
        places = {"x": [numbers[0]], "z": [numbers[0]], "y": []}[axis]
    elif axis == "y":
        angle = numpy.linspace(0, 2 * numpy.pi, ROUND + 1)
        circle = numpy.column_stack([numbers[1] + numbers[0] * numpy.cos(angle), numbers[2] + numbers[0] * numpy.sin(angle)])
        return numpy.stack([circle[:-1], circle[1:]], axis=1)
    else:
        # xcylinder R y z, zcylinder R x y
        middle, beside = (numbers[1], numbers[2]) if axis == "z" else (numbers[2], numbers[1])
        half = numpy.sqrt(max(numbers[0] ** 2 - (y - beside) ** 2, 0.0))
        places = [middle - half, middle + half] if half > 0 else []
        axis = "x" if axis == "z" else "z"
    ends = [((place, bottom), (place, top)) if axis == "x" else ((left, place), (right, place)) for place in places]
    return numpy.array(ends, dtype=float).reshape(-1, 2, 2)
