# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of OpenFOAM's of equal boxes, from which cells may be left out, and fields in it; ASCII or binary."""

import os

import numpy

# corners of a cell's six faces, outwards: by the offsets of its eight corners
SIDES = {
    (-1, 0, 0): ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)), (1, 0, 0): ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
    (0, -1, 0): ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)), (0, 1, 0): ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
    (0, 0, -1): ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)), (0, 0, 1): ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}  # fmt: skip


def header(kind, name, binary):
    form = 'format binary; arch "LSB;label=32;scalar=64"' if binary else "format ascii"
    return f"FoamFile {{ version 2.0; {form}; class {kind}; object {name}; }}\n".encode()


def _list(values, kind, binary):
    values = numpy.asarray(values, dtype=kind)
    if binary:
        return b"\n%d\n(" % len(values) + values.tobytes() + b")\n"
    rows = (" ".join(map(repr, numpy.atleast_1d(row).tolist())) for row in values)
    return ("\n%d\n(\n" % len(values) + "\n".join(f"({row})" if values.ndim > 1 else row for row in rows) + "\n)\n").encode()


def write_mesh(folder, size, cells, left_out=lambda at: False, binary=False):
    """In `folder`/constant/polyMesh: `size` [m] (x, y, z) from the origin in `cells`; patches inlet (below), outlet (above), of type patch, and
    walls. `left_out(centre [3])`: whether a cell is not there. Returns the centres [n, 3] of the cells that are."""
    edge = numpy.array(size) / numpy.array(cells)
    places = [at for at in numpy.ndindex(*cells) if not left_out((numpy.array(at) + 0.5) * edge)]
    number = {at: n for n, at in enumerate(places)}
    corner = {}
    inner, patches = [], {"inlet": [], "outlet": [], "walls": []}
    for at in places:
        for side, offsets in SIDES.items():
            face = [corner.setdefault(tuple(numpy.add(at, offset).tolist()), len(corner)) for offset in offsets]
            beside = tuple(numpy.add(at, side).tolist())
            if beside in number:
                if number[at] < number[beside]:
                    inner.append((face, number[at], number[beside]))
                continue
            outside = not all(0 <= b < c for b, c in zip(beside, cells))
            name = {(0, 0, -1): "inlet", (0, 0, 1): "outlet"}.get(side, "walls") if outside else "walls"
            patches[name].append((face, number[at], None))
    faces = inner + [face for each in patches.values() for face in each]
    at = os.path.join(folder, "constant", "polyMesh")
    os.makedirs(at, exist_ok=True)

    def put(name, kind, *lists):
        with open(os.path.join(at, name), "wb") as file:
            file.write(header(kind, name, binary) + b"".join(lists))

    put("points", "vectorField", _list(numpy.array(list(corner)) * edge, "<f8", binary))
    put("owner", "labelList", _list([face[1] for face in faces], "<i4", binary))
    put("neighbour", "labelList", _list([face[2] for face in inner], "<i4", binary))
    if binary:
        first = numpy.arange(len(faces) + 1) * 4
        put("faces", "faceCompactList", _list(first, "<i4", True), _list(numpy.ravel([face[0] for face in faces]), "<i4", True))
    else:
        rows = "".join("4({} {} {} {})\n".format(*face[0]) for face in faces)
        put("faces", "faceList", f"\n{len(faces)}\n(\n{rows})\n".encode())
    text, start = "", len(inner)
    for name, each in patches.items():
        kind = "wall" if name == "walls" else "patch"
        text += f"{name} {{ type {kind}; inGroups 1({kind}); nFaces {len(each)}; startFace {start}; }}\n"
        start += len(each)
    put("boundary", "polyBoundaryMesh", f"\n3\n(\n{text})\n".encode())
    return (numpy.array(places) + 0.5) * edge


def write_field(folder, time, name, values, binary=False):
    """A field of cells, [n] or [n, 3]."""
    values = numpy.asarray(values, dtype=float)
    kind = "vector" if values.ndim > 1 else "scalar"
    os.makedirs(os.path.join(folder, time), exist_ok=True)
    with open(os.path.join(folder, time, name), "wb") as file:
        file.write(header(f"vol{kind.capitalize()}Field", name, binary) + b"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<%s>" % kind.encode())
        file.write(_list(values, "<f8", binary).rstrip(b"\n") + b";\nboundaryField\n{\n    inlet\n    {\n        type fixedValue;\n    }\n}\n")
