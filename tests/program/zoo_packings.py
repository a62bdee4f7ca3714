# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres in regular places, whose solid fraction is known everywhere. Lengths in m."""

import dataclasses
import math

import numpy

D = 3.256e-3  # diameter of the spheres [m]: those of cases/packed-bed
SPHERE = math.pi / 6
A = (4 * SPHERE / 0.58) ** (1 / 3) * D  # edge of the face-centred unit cell that holds 0.58 of solids
# places in the unit cell. The planes of walls mirror the layers of both lattices into themselves, but where three walls meet
# the face-centred one has a sphere near the corner or none, instead of half: a surplus or a lack of its own
FACE_CENTRED = numpy.array([(0.25, 0.25, 0.25), (0.75, 0.75, 0.25), (0.75, 0.25, 0.75), (0.25, 0.75, 0.75)])
CUBIC = numpy.array([(0.5, 0.5, 0.5)])


SITES = FACE_CENTRED


@dataclasses.dataclass
class Packing:
    """Spheres: places [n, 3] and diameters [n] [m]; solid fraction inside."""

    places: numpy.ndarray
    diameters: numpy.ndarray
    fraction: float

    def __add__(self, other):
        return Packing(numpy.concatenate([self.places, other.places]),
                       numpy.concatenate([self.diameters, other.diameters]), self.fraction)  # fmt: skip


def lattice(low, high, diameter=D, edge=A, shift=(0, 0, 0), sites=None):
    """Of a whole number of unit cells as near to `edge` [m] (of a face-centred one) as the box allows. Places that a `shift`
    [m] moves out of the box come back on the other side."""
    sites = SITES if sites is None else sites
    low, high = numpy.array(low, float), numpy.array(high, float)
    edge = edge * 0.7 if len(sites) == 1 else edge  # 1.07 d of 1.53 d: cells of d do not fit to it
    count = numpy.maximum(1, numpy.rint((high - low) / edge).astype(int))
    cell = (high - low) / count
    corners = numpy.stack(numpy.meshgrid(*map(numpy.arange, count), indexing="ij"), axis=-1).reshape(-1, 1, 3)
    places = ((corners + sites).reshape(-1, 3) * cell + shift) % (high - low) + low
    fraction = len(sites) * SPHERE * diameter**3 / cell.prod()
    return Packing(places, numpy.full(len(places), diameter), fraction)


def rings(radius, height, diameter=D):
    """In a cylinder about z (its mean radius, where the mesh has chords): rings half a spacing from the wall and from one
    another, each with as many spheres as its share of the area asks for, every second layer turned."""
    count = round(radius / diameter)
    width = radius / count
    layer = SPHERE * diameter**3 / 0.58 / (math.pi * width**2 / 3)
    layers = round(height / layer)
    places = []
    for k in range(layers):
        for i in range(count):
            n = 3 * (2 * i + 1)
            angle = 2 * math.pi * (numpy.arange(n) + 0.5 * (k % 2) + 0.618 * i) / n
            r = math.sqrt(i**2 + i + 0.5) * width  # the ring's mean square of the radius
            places.append(numpy.stack([r * numpy.cos(angle), r * numpy.sin(angle),
                                       numpy.full(n, (k + 0.5) * height / layers)], axis=1))  # fmt: skip
    places = numpy.concatenate(places)
    fraction = len(places) * SPHERE * diameter**3 / (math.pi * radius**2 * height)
    return Packing(places, numpy.full(len(places), diameter), fraction)


def radii(radius, height, angle, diameter):
    """In a wedge: spheres in its middle plane, each for an equal part of the volume."""
    area = radius**2 * math.sin(angle) / 2
    layers = round(height / diameter)
    count = round(0.4 * area * height / layers / (SPHERE * diameter**3))
    places = []
    for k in range(layers):
        r = radius * numpy.sqrt((numpy.arange(count) + (0.25 + 0.5 * (k % 2))) / count) * math.cos(angle / 2)
        places.append(numpy.stack([r, 0 * r, numpy.full(count, (k + 0.5) * height / layers)], axis=1))
    places = numpy.concatenate(places)
    fraction = len(places) * SPHERE * diameter**3 / (area * height)
    return Packing(places, numpy.full(len(places), diameter), fraction)
