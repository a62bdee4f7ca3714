# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that a mapping may meet, made in a case folder by OpenFOAM's own tools, or written cell by cell.

Sizes in m. Walls are patches of type wall. The folder has system/controlDict, as OpenFOAM's tools want.
"""

import itertools
import os

import foam_mesh
import numpy
import support

AXES = "xyz"


def dictionary(folder, name, text):
    support.write(os.path.join(folder, "system", name), foam_mesh.HEADER.format("dictionary", name) + text + "\n")


def vector(v):
    return "({!r} {!r} {!r})".format(*map(float, v))


def box(folder, size, cells, grading=("1", "1", "1"), periodic="", unresolved=""):
    """Hexahedra; `grading` per axis as blockMesh takes it; axes in `periodic` have cyclic sides, those in `unresolved` empty
    ones. The top is the patch `open`."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    sides = {"x": ("0 4 7 3", "1 2 6 5"), "y": ("0 1 5 4", "3 7 6 2"), "z": ("0 3 2 1", "4 5 6 7")}
    patches = ""
    for axis in AXES:
        for side in range(2):
            name, kind = f"{axis}{side}", "type wall;"
            if axis in unresolved:
                kind = "type empty;"
            elif axis in periodic:
                kind = f"type cyclic; neighbourPatch {axis}{1 - side};"
            elif name == "z1":
                name, kind = "open", "type patch;"
            patches += f"{name} {{ {kind} faces (({sides[axis][side]})); }}\n"
    dictionary(folder, "blockMeshDict", "scale 1; edges ();\nvertices ({});\nblocks (hex (0 1 2 3 4 5 6 7) ({} {} {}) "
               "simpleGrading ({} {} {}));\nboundary (\n{});".format(
                   " ".join(vector(numpy.multiply(c, size)) for c in corners), *cells, *grading, patches))  # fmt: skip
    support.must(folder, "blockMesh")


def refine(folder, selection):
    """Each cell of the set into eight, whatever its neighbours are. `selection`: a source for topoSet."""
    choose(folder, selection)
    dictionary(folder, "refineMeshDict", "set chosen; coordinateSystem global; globalCoeffs { tan1 (1 0 0); tan2 (0 1 0); } "
               "directions (tan1 tan2 normal); useHexTopology yes; geometricCut no; writeMesh no;")  # fmt: skip
    support.must(folder, "refineMesh", "-overwrite", "-dict", "system/refineMeshDict")


def choose(folder, selection, kind="cell"):
    dictionary(folder, "topoSetDict", f"actions ({{ name chosen; type {kind}Set; action new; {selection} }});")
    support.must(folder, "topoSet")


def below(height):
    return f"source boxToCell; box (-1 -1 -1) (1 1 {height!r});"


def refine_to_spot(folder, centre, radii):
    """Halves the cells within each radius [m], one after another; neighbours stay within 2:1."""
    for radius in radii:
        choose(folder, f"source sphereToCell; centre {vector(centre)}; origin {vector(centre)}; radius {float(radius)!r};")
        support.must(folder, "refineHexMesh", "-overwrite", "chosen")


def grid(size, cells, shaken, seed=5):
    """Points of a box of hexahedra [n, 3], moved at random by up to `shaken` of a cell, in the box's sides where they lie
    there; and the number of the point (i, j, k)."""
    n = numpy.array(cells)
    index = numpy.stack(numpy.meshgrid(*(numpy.arange(m + 1) for m in n), indexing="ij"), axis=-1)
    move = numpy.random.default_rng(seed).uniform(-shaken, shaken, index.shape)
    move[(index == 0) | (index == n)] = 0
    points = ((index + move) * (numpy.array(size) / n)).reshape(-1, 3)
    return points, lambda i, j, k: int((i * (n[1] + 1) + j) * (n[2] + 1) + k)


def tetrahedra(folder, size, cells, shaken=0.15):
    """Six in each hexahedron, around its diagonal, one for each order of the axes (Kuhn), shaken."""
    points, number = grid(size, cells, shaken)
    made = []
    for corner in itertools.product(*map(range, cells)):
        for order in itertools.permutations(range(3)):
            at = [numpy.array(corner)]
            for axis in order:
                at.append(at[-1] + numpy.eye(3, dtype=int)[axis])
            a, b, c, d = (number(*p) for p in at)
            made.append([(a, b, c), (a, b, d), (a, c, d), (b, c, d)])
    foam_mesh.write_cells(folder, points, made)


def polyhedra(folder, size, cells):
    """The dual of tetrahedra."""
    tetrahedra(folder, size, cells)
    support.must(folder, "polyDualMesh", "-overwrite", "60")


def prisms(folder, size, cells, shaken=0.15):
    """Two prisms of triangles in each hexahedron, shaken across and of unequal height."""
    points, number = grid(size, cells, shaken)
    layers = points.reshape(*(n + 1 for n in cells), 3)
    layers[..., :2] = layers[:, :, :1, :2]
    layers[..., 2] = layers[:1, :1, :, 2]
    made = []
    for i, j, k in itertools.product(*map(range, cells)):
        for base in (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1))):
            low = [number(i + x, j + y, k) for x, y in base]
            high = [p + 1 for p in low]
            made.append([tuple(low), tuple(high),
                         *((low[e], low[(e + 1) % 3], high[(e + 1) % 3], high[e]) for e in range(3))])  # fmt: skip
    foam_mesh.write_cells(folder, points, made)


def o_grid(folder, radius, height, across, around_core, layers):
    """A cylinder along z: a square core of across x across cells, and `around_core` cells from it to the wall."""
    square, round_ = 0.5 * radius / 2**0.5 * 1.1, radius / 2**0.5
    plane = [(x * s, y * s) for s in (square, round_) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    vertices = [(x, y, z) for z in (0, height) for x, y in plane]
    blocks = [f"hex (0 1 2 3 8 9 10 11) ({across} {across} {layers}) simpleGrading (1 1 1)"]
    walls, arcs = [], []
    for e in range(4):
        a, b = e, (e + 1) % 4
        blocks.append(f"hex ({a + 4} {b + 4} {b} {a} {a + 12} {b + 12} {b + 8} {a + 8}) ({across} {around_core} {layers}) "
                      "simpleGrading (1 1 1)")  # fmt: skip
        middle = [radius * c for c in ((0, -1), (1, 0), (0, 1), (-1, 0))[e]]
        arcs += [f"arc {a + 4 + up} {b + 4 + up} {vector((*middle, z))}" for up, z in ((0, 0), (8, height))]
        walls.append(f"({a + 4} {b + 4} {b + 12} {a + 12})")
    dictionary(folder, "blockMeshDict", "scale 1;\nvertices ({});\nedges ({});\nblocks ({});\nboundary (shell {{ type wall; "
               "faces ({}); }});\ndefaultPatch {{ name ends; type wall; }}".format(
                   " ".join(map(vector, vertices)), " ".join(arcs), "\n".join(blocks), " ".join(walls)))  # fmt: skip
    support.must(folder, "blockMesh")


def wedge(folder, radius, height, cells, angle):
    """Of a cylinder along z, `angle` [rad] wide about the plane y = 0; `cells`: along the radius and the height."""
    x, y = radius * numpy.cos(angle / 2), radius * numpy.sin(angle / 2)
    vertices = [(0, 0, 0), (x, -y, 0), (x, y, 0), (0, 0, height), (x, -y, height), (x, y, height)]
    dictionary(folder, "blockMeshDict", "scale 1; edges ();\nvertices ({});\nblocks (hex (0 1 2 0 3 4 5 3) ({} 1 {}) "
               "simpleGrading (1 1 1));\nboundary (front {{ type wedge; faces ((0 1 4 3)); }} back {{ type wedge; faces "
               "((0 3 5 2)); }} shell {{ type wall; faces ((1 2 5 4) (0 2 1 0) (3 4 5 3)); }} "
               "axis {{ type empty; faces ((0 3 3 0)); }});".format(
                   " ".join(map(vector, vertices)), *cells))  # fmt: skip
    support.must(folder, "blockMesh")


def snapped_cylinder(folder, radius, height, cell):
    """snappyHexMesh: cells of `cell` [m], halved at the wall of a cylinder along z, and snapped to it."""
    n = int(numpy.ceil(2 * radius / cell)) + 2
    m = round(height / cell)
    corners = [(x, y, z) for z in (0, height) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    half = n * cell / 2
    dictionary(folder, "blockMeshDict", "scale 1; edges ();\nvertices ({});\nblocks (hex (0 1 2 3 4 5 6 7) ({} {} {}) "
               "simpleGrading (1 1 1));\nboundary ();\ndefaultPatch {{ name ends; type wall; }}".format(
                   " ".join(vector((x * half, y * half, z)) for x, y, z in corners), n, n, m))  # fmt: skip
    support.must(folder, "blockMesh")
    dictionary(folder, "snappyHexMeshDict", f"""
castellatedMesh true; snap true; addLayers false;
geometry {{ shell {{ type searchableCylinder; point1 (0 0 {-height!r}); point2 (0 0 {2 * height!r}); radius {radius!r}; }} }}
castellatedMeshControls
{{
    maxLocalCells 1000000; maxGlobalCells 2000000; minRefinementCells 0; nCellsBetweenLevels 2; features ();
    refinementSurfaces {{ shell {{ level (1 1); }} }}
    resolveFeatureAngle 30; refinementRegions {{}}
    locationInMesh {vector((0.13 * cell, 0.21 * cell, 0.37 * cell))}; allowFreeStandingZoneFaces true;
}}
snapControls {{ nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; }}
addLayersControls
{{
    relativeSizes true; layers {{}} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1; nGrow 0; featureAngle 60;
    nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;
}}
meshQualityControls
{{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol -1e30; minTetQuality -1e30;
    minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1;
    nSmoothScale 4; errorReduction 0.75;
}}
mergeTolerance 1e-6;""")
    support.must(folder, "snappyHexMesh", "-overwrite")


def baffle(folder, x, low=(-1, -1), high=(1, 1), joined=False):
    """A wall without thickness in the plane `x` [m], made of the faces there between `low` and `high` in y and z; or, where
    `joined`, a cyclic pair in the same place, which parts nothing."""
    box_ = f"({x - 1e-6!r} {low[0]!r} {low[1]!r}) ({x + 1e-6!r} {high[0]!r} {high[1]!r})"
    dictionary(folder, "topoSetDict", "actions ("
               f"{{ name plane; type faceSet; action new; source boxToFace; box {box_}; }}"
               "{ name plane; type faceZoneSet; action new; source setToFaceZone; faceSet plane; });")  # fmt: skip
    support.must(folder, "topoSet")
    halves = "".join(
        f"{half} {{ name {half}; type cyclic; neighbourPatch {other}; }}" if joined else f"{half} {{ name baffle; type wall; }}"
        for half, other in (("master", "slave"), ("slave", "master"))
    )
    dictionary(folder, "createBafflesDict", "internalFacesOnly true; baffles { plane { type faceZone; zoneName plane; patches "
               f"{{ {halves} }} }} }}")  # fmt: skip
    support.must(folder, "createBaffles", "-overwrite")
