# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of triangles as STL files, which snappyHexMesh and LIGGGHTS read. Lengths in m."""

import numpy

from interphase.input_error import InputError

BINARY = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])  # a triangle; 80 bytes and their number come before


def write_stl(path, solids):
    """`solids`: {name: triangles [n, 3 corners, 3]}; snappyHexMesh makes a patch of each name."""
    with open(path, "w", encoding="ascii") as file:
        for name, triangles in solids.items():
            file.write(f"solid {name}\n")
            for triangle in numpy.asarray(triangles, float):
                normal = numpy.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
                normal /= numpy.linalg.norm(normal)
                file.write(" facet normal {!r} {!r} {!r}\n  outer loop\n".format(*normal.tolist()))
                file.writelines("   vertex {!r} {!r} {!r}\n".format(*corner) for corner in triangle.tolist())
                file.write("  endloop\n endfacet\n")
            file.write(f"endsolid {name}\n")


def revolved(profile, around):
    """Triangles of the surface that a line through `profile` [n, 2], points (radius, height), makes about the z axis with `around`
    corners; a radius of 0 is a tip. A line that goes up has its outside away from the axis."""
    angle = 2 * numpy.pi * numpy.arange(around + 1) / around
    circle = numpy.column_stack([numpy.cos(angle), numpy.sin(angle)])
    circle[-1] = circle[0]
    triangles = []
    for (low, bottom), (high, top) in zip(profile[:-1], profile[1:]):
        for here, there in zip(circle[:-1], circle[1:]):
            a, b = (numpy.append(low * c, bottom) for c in (here, there))
            c, d = (numpy.append(high * c, top) for c in (there, here))
            if low > 0:
                triangles.append((a, b, c) if high > 0 else (a, b, d))
            if high > 0:
                triangles.append((a, c, d))
    return numpy.array(triangles)


def read_stl(path):
    """Triangles [n, 3 corners, 3] of all solids in the file, ASCII or binary; InputError where it is neither."""
    try:
        with open(path, "rb") as file:
            data = file.read()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    # A binary file may begin with "solid", too; its length tells.
    if len(data) >= 84 and len(data) == 84 + BINARY.itemsize * int.from_bytes(data[80:84], "little"):
        return numpy.frombuffer(data, BINARY, offset=84)["corners"].astype(float)
    words = [line.split() for line in data.splitlines()]
    try:
        corners = numpy.array([[float(number) for number in each[1:4]] for each in words if each[:1] == [b"vertex"]])
        return corners.reshape(-1, 3, 3)
    except ValueError:
        raise InputError(f"{path}: is no STL file: corners of triangles, three numbers each, are expected") from None
