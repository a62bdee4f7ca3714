# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of triangles [n, 3 corners, 3], in m, and the STL files that LIGGGHTS's fix mesh/surface reads."""

import numpy


def stl(triangles):
    """Text of an STL file; triangles [n, 3 corners, 3]."""
    text = "solid wall\n"
    for t in numpy.asarray(triangles, float):
        normal = numpy.cross(t[1] - t[0], t[2] - t[0])
        normal /= numpy.linalg.norm(normal)
        text += "facet normal {:.17g} {:.17g} {:.17g}\nouter loop\n".format(*normal)
        text += "".join("vertex {:.17g} {:.17g} {:.17g}\n".format(*corner) for corner in t)
        text += "endloop\nendfacet\n"
    return text + "endsolid wall\n"


def square(cells, origin, along, across, seed=None):
    """A parallelogram of cells x cells x 2 triangles; `seed`: inner corners are moved at random within it."""
    draw = numpy.random.default_rng(seed)
    u, v = numpy.meshgrid(numpy.linspace(0, 1, cells + 1), numpy.linspace(0, 1, cells + 1), indexing="ij")
    if seed is not None:
        u[1:-1, 1:-1] += draw.uniform(-0.3, 0.3, (cells - 1, cells - 1)) / cells
        v[1:-1, 1:-1] += draw.uniform(-0.3, 0.3, (cells - 1, cells - 1)) / cells
    corner = numpy.asarray(origin, float) + u[..., None] * numpy.asarray(along, float) + v[..., None] * numpy.asarray(across, float)
    triangles = []
    for i in range(cells):
        for j in range(cells):
            a, b, c, d = corner[i, j], corner[i + 1, j], corner[i + 1, j + 1], corner[i, j + 1]
            triangles += [[a, b, c], [a, c, d]]
    return triangles
