# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's polyMesh and cell fields as arrays, in ASCII files."""

import os

import numpy

from interphase import foam_field, gas_mesh

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"


def read_field(folder, time, name, cells):
    """A cell field: [cells] or [cells, 3]."""
    field = foam_field.internal_field(os.path.join(folder, time, name))
    values = numpy.tile(field.values, (cells, 1)) if field.uniform else field.values
    return values[:, 0] if values.shape[1] == 1 else values


class FoamMesh:
    """points [n, 3] [m]; faces: lists of points; owner [faces], neighbour [inner faces]; cells' centres [m] and volumes [m3]
    as OpenFOAM computes them."""

    def __init__(self, folder):
        mesh = gas_mesh.read(folder)
        self.points, self.owner, self.neighbour, self.cells = mesh.points, mesh.owner, mesh.neighbour, mesh.cells
        self.faces = numpy.split(mesh.corners, mesh.first[1:-1])
        self._measure()

    def _measure(self):
        centre, area = numpy.empty((len(self.faces), 3)), numpy.empty((len(self.faces), 3))
        for f, face in enumerate(self.faces):
            corner = self.points[face]
            middle = corner.mean(axis=0)
            following = numpy.roll(corner, -1, axis=0)
            triangle = numpy.cross(following - corner, middle - corner) / 2
            size = numpy.linalg.norm(triangle, axis=1)
            area[f] = triangle.sum(axis=0)
            centre[f] = ((corner + following + middle) / 3 * size[:, None]).sum(axis=0) / size.sum()
        inner = len(self.neighbour)
        cell = numpy.concatenate([self.owner, self.neighbour])
        face_centre = numpy.concatenate([centre, centre[:inner]])
        face_area = numpy.concatenate([area, -area[:inner]])

        def summed(values):
            return numpy.stack([numpy.bincount(cell, values[:, i], self.cells) for i in range(3)], axis=1)

        estimate = summed(face_centre) / numpy.bincount(cell, minlength=self.cells)[:, None]
        pyramid = (face_area * (face_centre - estimate[cell])).sum(axis=1) / 3
        self.volume = numpy.bincount(cell, pyramid, self.cells)
        self.centre = summed((0.75 * face_centre + 0.25 * estimate[cell]) * pyramid[:, None]) / self.volume[:, None]
        self.face_centre, self.face_area = centre, area


def write_cells(folder, points, cells):
    """Writes a polyMesh of cells, given as lists of faces (tuples of points), with one patch `walls`."""
    middle = [numpy.mean([points[p] for face in cell for p in face], axis=0) for cell in cells]
    faces = {}
    for c, cell in enumerate(cells):
        for face in cell:
            faces.setdefault(tuple(sorted(face)), (face, []))[1].append(c)

    def outwards(face, owner):
        corner = points[list(face)]
        area = numpy.cross(corner[1:-1] - corner[0], corner[2:] - corner[0]).sum(axis=0)
        return face if area @ (corner[0] - middle[owner]) > 0 else (face[0], *face[:0:-1])

    # inner faces first, by owner and neighbour: OpenFOAM's upper triangular order
    listed = sorted(faces.values(), key=lambda face: (len(face[1]) == 1, face[1]))
    inner = sum(len(of) == 2 for _, of in listed)
    at = os.path.join(folder, "constant", "polyMesh")
    os.makedirs(at, exist_ok=True)

    def put(name, kind, lines):
        with open(os.path.join(at, name), "w", encoding="utf-8") as file:
            file.write(HEADER.format(kind, name) + f"{len(lines)}\n(\n" + "\n".join(lines) + "\n)\n")

    put("points", "vectorField", ["({!r} {!r} {!r})".format(*map(float, p)) for p in points])
    put("faces", "faceList", ["{}({})".format(len(f), " ".join(map(str, outwards(f, of[0])))) for f, of in listed])
    put("owner", "labelList", [str(of[0]) for _, of in listed])
    put("neighbour", "labelList", [str(of[1]) for _, of in listed[:inner]])
    put("boundary", "polyBoundaryMesh", [f"walls {{ type wall; nFaces {len(listed) - inner}; startFace {inner}; }}"])
