#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres on a lattice in vessels meshed in many ways, and what the program makes of them: the solid fraction of every cell
after one short step, beside the lattice's own.

    mesh_zoo.py --table                       # every scene: largest deviations, as a table in Markdown
    mesh_zoo.py --table --program PATH        # of another build
    mesh_zoo.py --scene refined --ranks 2     # one scene, deviations cell by cell with --cells
"""

import argparse
import dataclasses
import functools
import math
import os
import re
import tempfile
import time
import typing

import foam_mesh
import numpy
import support
from interphase import data_file, gas_mesh, tables
import zoo_meshes as meshes
import zoo_packings
from zoo_packings import A, D, SPHERE, Packing, lattice, radii, rings


@dataclasses.dataclass
class Scene:
    """`mesh(folder)` makes the mesh; `compared(mesh)` says which cells have the packing's solid fraction, all where it is
    missing, and `empty(mesh)` which have none."""

    title: str
    mesh: typing.Callable
    packing: typing.Callable
    compared: typing.Callable = lambda mesh: numpy.full(mesh.cells, True)
    empty: typing.Callable = lambda mesh: numpy.full(mesh.cells, False)
    periodic: str = ""
    mapping: str = ""  # entries of the block `mapping`


SCENES = {}


def scene(name, title, **options):
    """Adds a scene; the function makes mesh and packing and gives them back."""

    def add(function):
        SCENES[name] = lambda: Scene(title, *function(), **options)
        return function

    return add


def filled(size, mesh, **options):
    """A box [m] full of the lattice."""
    return mesh, lambda _: lattice((0, 0, 0), size, **options)


def column(*steps, cells=(4, 4, 8), cell=2 * A, grading=("1", "1", "1"), periodic="", unresolved="", **options):
    """A box of hexahedra on which `steps`, functions of the folder, are done one after another."""
    size = numpy.multiply(cells, cell)

    def mesh(folder):
        meshes.box(folder, size, cells, grading, periodic, unresolved)
        for step in steps:
            step(folder, size)

    return filled(size, mesh, **options)


def refine_half(folder, size):
    meshes.refine(folder, meshes.below(size[2] / 2 + 1e-9))


def refine_spot(folder, size, within=0.0):
    """Five times; the finest cells lie about the middle, within a part of a cell of the box."""
    cell = size[0] / 6
    meshes.refine_to_spot(folder, size / 2, [within * cell + 1.2 * cell / 2**level for level in range(5)])


scene("uniform", "uniform hexahedra")(column)
scene("refined", "lower half refined 2:1 (refineMesh)")(lambda: column(refine_half))
scene("refined_twice", "lower half refined 4:1 (refineMesh twice)")(lambda: column(refine_half, refine_half))
scene("thin", "cells 4:1 in z only")(
    lambda: column(cells=(4, 4, 20), grading=("1", "1", "((0.5 0.8 1) (0.5 0.2 1))")))  # fmt: skip
scene("graded", "smooth grading 4:1 over 20 cells")(lambda: column(cells=(4, 4, 20), grading=("1", "1", "4")))
scene("spot", "refined 32:1 towards a spot (refineHexMesh, five levels)")(lambda: column(refine_spot, cells=(6, 6, 6)))
scene("wide_spot", "the same, 11,000 finest cells")(
    lambda: column(lambda folder, size: refine_spot(folder, size, 0.4), cells=(6, 6, 6)))  # fmt: skip
scene("cells_d", "uniform cells of d")(lambda: column(cells=(12, 12, 12), cell=D, edge=1.5 * D))
scene("cells_half_d", "uniform cells of d/2")(lambda: column(cells=(18, 18, 18), cell=D / 2, edge=1.5 * D))
scene("cells_1.02d", "uniform cells of 1.02 d")(lambda: column(cells=(12, 12, 12), cell=1.02 * D))
scene("cells_5d", "uniform cells of 5 d")(lambda: column(cells=(4, 4, 4), cell=5 * D))
scene("cells_20d", "uniform cells of 20 d")(lambda: column(cells=(2, 2, 1), cell=20 * D))


def cut(kind, h, cells=(6, 6, 6), **options):
    size = numpy.multiply(cells, h)
    return filled(size, lambda folder: kind(folder, size, cells, **options))


scene("tetrahedra", "tetrahedra, edges 2.5 d to 4.3 d, shaken")(lambda: cut(meshes.tetrahedra, 2.5 * D))
scene("small_tetrahedra", "tetrahedra, edges 1.1 d to 1.9 d, shaken")(lambda: cut(meshes.tetrahedra, 1.1 * D, (8, 8, 8)))
scene("polyhedra", "polyhedra (polyDualMesh of the former)")(lambda: cut(meshes.polyhedra, 2.5 * D))
scene("small_polyhedra", "small polyhedra")(lambda: cut(meshes.polyhedra, 1.1 * D, (8, 8, 8)))
scene("prisms", "prisms, edges 2.5 d to 3.5 d, shaken")(lambda: cut(meshes.prisms, 2.5 * D))

RADIUS, HEIGHT = 12 * D, 16 * D


def mean_radius(mesh):
    return math.sqrt(mesh.volume.sum() / (math.pi * HEIGHT))


def off_axis(mesh):
    return numpy.hypot(*mesh.centre[:, :2].T) > 2.5 * D  # the innermost rings are no lattice


@scene("o_grid", "O-grid in a cylinder", compared=off_axis)
def _():
    return (lambda folder: meshes.o_grid(folder, RADIUS, HEIGHT, 6, 6, 8)), lambda mesh: rings(mean_radius(mesh), HEIGHT)


@scene("snapped", "cylinder by snappyHexMesh, halved at the wall", compared=off_axis)
def _():
    return (lambda folder: meshes.snapped_cylinder(folder, RADIUS, HEIGHT, 2 * D)), lambda mesh: rings(mean_radius(mesh), HEIGHT)


@scene("wedge", "wedge of 5 degrees, cells of 3 d",
       compared=lambda mesh: numpy.hypot(*mesh.centre[:, :2].T) > 6 * D)  # fmt: skip
def _():
    # near the axis the wedge is thinner than a sphere
    angle = math.radians(5)
    return (
        lambda folder: meshes.wedge(folder, 60 * D, 24 * D, (20, 8), angle),
        lambda _: radii(60 * D, 24 * D, angle, D),
    )


# shifted, so that sides that are not joined would show
SHIFT = (0.4 * A, 0.3 * A, 0.2 * A)
for axes in ("x", "xy", "xyz"):
    scene(f"cyclic_{axes}", f"cells of 1.3 d, cyclic in {', '.join(axes)}", periodic=axes)(
        functools.partial(column, cells=(6, 6, 6), cell=1.3 * D, edge=1.3 * D * 1.2, periodic=axes,
                          shift=[s * (axis in axes) for s, axis in zip(SHIFT, "xyz")]))  # fmt: skip
scene("cyclic_refined", "lower half refined 2:1, cyclic in x and y", periodic="xy")(
    lambda: column(refine_half, periodic="xy", shift=(*SHIFT[:2], 0)))  # fmt: skip
scene("own_neighbour", "one cell of 3 d across, cyclic in x, y and z", periodic="xyz")(
    lambda: column(cells=(1, 1, 4), periodic="xyz", shift=SHIFT))  # fmt: skip
scene("two_across", "two cells of 3 d across, cyclic in x, y and z", periodic="xyz")(
    lambda: column(cells=(2, 2, 4), periodic="xyz", shift=SHIFT))  # fmt: skip
scene("flat", "one layer of cells between empty patches")(lambda: column(cells=(6, 1, 8), unresolved="y"))


def in_the_middle(folder, size, **options):
    meshes.baffle(folder, float(size[0] / 2), **options)


scene("short_baffle", "a baffle without thickness that ends in the packing")(
    lambda: column(lambda folder, size: in_the_middle(folder, size, high=(1.0, float(size[2] / 2 + 1e-6)))))  # fmt: skip
scene("joined_baffle", "a cyclic pair in place of faces within the packing")(
    lambda: column(lambda folder, size: in_the_middle(folder, size, joined=True)))  # fmt: skip


@scene("baffle", "a packed and an empty column parted by a baffle without thickness",
       compared=lambda mesh: mesh.centre[:, 0] < 8 * A, empty=lambda mesh: mesh.centre[:, 0] > 8 * A)  # fmt: skip
def _():
    size = numpy.multiply((8, 4, 4), 2 * A)

    def mesh(folder):
        meshes.box(folder, size, (8, 4, 4))
        in_the_middle(folder, size)

    return mesh, lambda _: lattice((0, 0, 0), size / (2, 1, 1))


@scene("large_sphere", "a bed, and one sphere of 5 d in the clear gas above",
       compared=lambda mesh: mesh.centre[:, 2] < 16 * A, empty=lambda mesh: abs(mesh.centre[:, 2] - 28 * A) < 4 * A)  # fmt: skip
def _():
    # compared: two cells below the bed's surface; empty: two cells above it, and 12 d below the large sphere
    size = numpy.multiply((4, 4, 32), 2 * A)
    one = Packing(numpy.array([(3.9 * A, 4.3 * A, 44.3 * A)]), numpy.array([5 * D]), 0)
    return (lambda folder: meshes.box(folder, size, (4, 4, 32))), lambda _: lattice((0, 0, 0), size * (1, 1, 10 / 32)) + one


@scene("two_sizes", "spheres of 3.1 and 9.4 mm in a vessel of 38 mm")
def _():
    size = numpy.array((38e-3, 38e-3, 76e-3))

    def packing(_):
        large = lattice((0, 0, 0), size, 9.4e-3, 19e-3)
        small = lattice((0, 0, 0), size, 3.1e-3, 5.4e-3)
        return Packing(*dataclasses.astuple(large + small)[:2], large.fraction + small.fraction)

    return (lambda folder: meshes.box(folder, size, (6, 6, 12))), packing


CONTROL = ("application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime 1e-6; deltaT 1e-6; "
           "writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 17; timePrecision 8;")  # fmt: skip
FILES = {
    "system/fvSchemes": "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } divSchemes { default Gauss linear; "
    "} laplacianSchemes { default Gauss linear uncorrected; } interpolationSchemes { default linear; } snGradSchemes { default "
    "uncorrected; }",
    "system/fvSolution": 'solvers { "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0.01; } "U.*" { solver '
    "PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0.01; } } PIMPLE { nOuterCorrectors 1; nCorrectors 1; "
    "p_rghRefCell 0; p_rghRefValue 0; }",
    "constant/transportProperties": "rho 1.2; mu 1.8e-5;",
    "constant/g": "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);",
    "0/U": 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField { #includeEtc '
    '"caseDicts/setConstraintTypes"\n ".*" { type noSlip; } open { type pressureInletOutletVelocity; value uniform (0 0 0); } }',
    "0/p_rgh": 'dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; boundaryField { #includeEtc '
    '"caseDicts/setConstraintTypes"\n ".*" { type zeroGradient; } open { type fixedValue; value uniform 0; } }',
}
KINDS = {"g": "uniformDimensionedVectorField", "U": "volVectorField", "p_rgh": "volScalarField"}
SCRIPT = """units si
atom_style granular
atom_modify map array sort 0 0
boundary {boundary}
newton off
communicate single vel yes
read_data dem/bed.data
neighbor {skin!r} bin
neigh_modify delay 0
thermo 1000
thermo_modify norm no lost ignore
"""


def prepare(scene, folder):
    """The case on one rank: mesh, fields and spheres that nothing moves."""
    support.write(os.path.join(folder, "system/controlDict"), foam_mesh.HEADER.format("dictionary", "controlDict") + CONTROL)
    for name in ("system/fvSchemes", "system/fvSolution"):
        support.write(os.path.join(folder, name), foam_mesh.HEADER.format("dictionary", os.path.basename(name)) + FILES[name])
    scene.mesh(folder)
    # only now: createBaffles would change the fields
    for name, text in FILES.items():
        kind = KINDS.get(os.path.basename(name), "dictionary")
        support.write(os.path.join(folder, name), foam_mesh.HEADER.format(kind, os.path.basename(name)) + text + "\n")
    # each step is as short as the whole run: nothing flows
    support.write(os.path.join(folder, "system/couplingDict"), foam_mesh.HEADER.format("dictionary", "couplingDict") +
                  'particles { script "dem/in.liggghts"; solidStep 1e-6; } mapping { maximumPacking 0.99; '
                  f"{scene.mapping} }}\n")  # fmt: skip
    mesh = foam_mesh.FoamMesh(folder)
    packing = scene.packing(mesh)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    support.write(os.path.join(folder, "dem/in.liggghts"), SCRIPT.format(
        boundary=" ".join("p" if axis in scene.periodic else "f" for axis in "xyz"), skin=D / 2))  # fmt: skip
    support.write(os.path.join(folder, "dem/bed.data"), data_file.text("a lattice", low, high, packing.places, packing.diameters, 1131, types=1))
    return mesh, packing


def decompose(folder, mesh, ranks):
    """Cells dealt to the ranks in patches that touch one another everywhere: a chess board of four cells or so."""
    size = 2.5 * mesh.volume.mean() ** (1 / 3)
    owner = (numpy.floor(mesh.centre / size).astype(int) @ (1, 2, 3)) % ranks
    support.write(os.path.join(folder, "constant/rankOfCell"), foam_mesh.HEADER.format("labelList", "rankOfCell") +
                  f"{len(owner)}\n(\n" + "\n".join(map(str, owner)) + "\n)\n")  # fmt: skip
    meshes.dictionary(folder, "decomposeParDict", f"numberOfSubdomains {ranks}; method manual; manualCoeffs {{ dataFile "
                      '"rankOfCell"; }')  # fmt: skip
    support.must(folder, "decomposePar", "-force")


def solids(folder, mesh, ranks=1):
    """Solid fractions [cells] of a case that was run, numbered as in the whole mesh."""
    if ranks == 1:
        return 1 - foam_mesh.read_field(folder, "1e-06", "voidage", mesh.cells)
    whole = numpy.full(mesh.cells, numpy.nan)
    for rank in range(ranks):
        part = os.path.join(folder, f"processor{rank}")
        cells = gas_mesh.labels(os.path.join(part, "constant/polyMesh/cellProcAddressing"))
        whole[cells] = 1 - foam_mesh.read_field(part, "1e-06", "voidage", len(cells))
    return whole


@dataclasses.dataclass
class Outcome:
    mesh: foam_mesh.FoamMesh
    fraction: float  # the packing's own
    solids: numpy.ndarray
    deviation: numpy.ndarray  # of the cells compared, relative
    compared: numpy.ndarray  # their numbers
    leaked: float  # the largest solid fraction where there is none
    total: float  # volume of solids in the cells / of the spheres - 1
    setup: float  # seconds of wall time before the first step


def near_corners(mesh, diameter):
    """Cells [cells] within 1.55 diameters of a corner of a box in all directions, for the face-centred lattice."""
    if zoo_packings.SITES is zoo_packings.CUBIC:
        return numpy.full(mesh.cells, False)
    from_sides = numpy.minimum(mesh.centre - mesh.points.min(axis=0), mesh.points.max(axis=0) - mesh.centre)
    return (from_sides < 1.55 * diameter).all(axis=1)


def evaluated(scene, folder, mesh, packing, ranks=1):
    """Runs the prepared case."""
    if ranks > 1:
        decompose(folder, mesh, ranks)
    started = time.monotonic()
    done = support.execute(folder, ranks)
    if done.code != 0:
        raise AssertionError(f"interphase on {ranks} ranks ended with {done.code}:\n{done.text[-3000:]}")
    wall = time.monotonic() - started
    found = solids(folder, mesh, ranks)
    compared, empty = numpy.flatnonzero(scene.compared(mesh) & ~near_corners(mesh, packing.diameters.max())), scene.empty(mesh)
    volume = SPHERE * (packing.diameters**3).sum()
    setup = re.search(r"^\s*setup\s+(\S+)", done.out, re.M)
    return Outcome(mesh, packing.fraction, found, found[compared] / packing.fraction - 1, compared,
                   float(abs(found[empty]).max(initial=0)), float(found @ mesh.volume / volume - 1),
                   float(setup[1]) if setup else wall)  # fmt: skip


def run(name, ranks=1, **changes):
    with tempfile.TemporaryDirectory(prefix="interphase-") as folder:
        made = dataclasses.replace(SCENES[name](), **changes)
        return evaluated(made, folder, *prepare(made, folder), ranks)


@dataclasses.dataclass
class Flow:
    """Of gas that enters cases/packed-bed at 1.05 m/s with its lower half refined 2:1, layer by layer of cells: voidage and
    superficial velocity [m/s]; and the pressure gradient across the refinement (0.75 coarse cells below to 0.5 above) over
    that of the packing above it (2.5 to 5.5)."""

    height: numpy.ndarray  # of the layers, in coarse cells from the refinement
    voidage: numpy.ndarray
    superficial: numpy.ndarray
    gradient: float


def flow_through_refinement():
    with tempfile.TemporaryDirectory(prefix="interphase-") as root:
        folder = support.ProgramTest.prepare("packed-bed", os.path.join(root, "case"), until=0.1)
        for entry, value in (("writeFormat", "ascii"), ("writePrecision", "17")):
            support.ProgramTest.set_entry(folder, "system/controlDict", entry, value)
        support.must(folder, "blockMesh")
        cell = 2 * A
        middle = 13 * cell  # of 3 + 20 + 3 cells
        meshes.refine(folder, meshes.below(middle + 1e-6))
        done = support.execute(folder)
        if done.code != 0:
            raise AssertionError(f"interphase ended with {done.code}:\n{done.text[-3000:]}")
        mesh = foam_mesh.FoamMesh(folder)
        voidage, velocity, pressure = (foam_mesh.read_field(folder, "0.1", n, mesh.cells) for n in ("voidage", "U", "p_rgh"))
    height = numpy.round((mesh.centre[:, 2] - middle) / cell, 3)
    layers = numpy.unique(height)

    def mean(values):
        return numpy.array([values[height == layer].mean() for layer in layers])

    of_layer = dict(zip(layers.tolist(), mean(pressure)))
    ratio = (of_layer[-0.75] - of_layer[0.5]) / (of_layer[2.5] - of_layer[5.5]) * 3 / 1.25
    return Flow(layers, mean(voidage), mean(voidage * velocity[:, 2]), ratio)


def table(names, mapping):
    print(tables.markdown_head(("mesh", "cells", "solids", "lowest", "highest", "where there are none")))
    for name in names:
        made = SCENES[name]()
        out = run(name, mapping=mapping)
        leaked = f"{out.leaked:.4f}" if made.empty(out.mesh).any() else ""
        least, most = out.deviation.min(), out.deviation.max()
        print(tables.markdown_row((made.title, out.mesh.cells, f"{out.fraction:.3f}", f"{100 * least:+.2f} %", f"{100 * most:+.2f} %", leaked)),
              flush=True)  # fmt: skip
    if "refined" in names and not mapping:
        flow = flow_through_refinement()
        near = abs(flow.height) < 3
        print(f"\nGas through `refined`: superficial velocity {flow.superficial[near].min():.3f} to "
              f"{flow.superficial[near].max():.3f} m/s of 1.05, pressure gradient across it {flow.gradient:.3f} of the packing's")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--table", action="store_true")
    parser.add_argument("--scene", nargs="+", choices=SCENES, default=list(SCENES), metavar="NAME", help=", ".join(SCENES))
    parser.add_argument("--ranks", type=int, default=1)
    parser.add_argument("--cells", action="store_true", help="the cells that are farthest off")
    parser.add_argument("--mapping", default="", help="entries of the block `mapping`, e.g. 'type cellCentre;'")
    parser.add_argument("--program", help="the program to run")
    parser.add_argument("--cubic", action="store_true", help="a simple cubic lattice")
    options = parser.parse_args()
    if options.cubic:
        zoo_packings.SITES = zoo_packings.CUBIC
    if options.program:
        support.PROGRAM = os.path.realpath(options.program)
    if options.table:
        table(options.scene, options.mapping)
        return
    for name in options.scene:
        out = run(name, options.ranks, mapping=options.mapping)
        print(f"{name}: {out.mesh.cells} cells, {100 * out.deviation.min():+.3f} to {100 * out.deviation.max():+.3f} %, rms "
              f"{100 * numpy.sqrt((out.deviation**2).mean()):.3f} %, where there are none {out.leaked:.2e}, total "
              f"{out.total:+.1e}, setup {out.setup:.2f} s")  # fmt: skip
        if options.cells:
            for c in sorted(range(len(out.compared)), key=lambda c: -abs(out.deviation[c]))[:20]:
                cell = out.compared[c]
                print(f"  cell {cell} at ({' '.join(f'{x / D:.3f}' for x in out.mesh.centre[cell])}) d, volume "
                      f"{out.mesh.volume[cell] / D**3:.4f} d3: {100 * out.deviation[c]:+.3f} %")  # fmt: skip


if __name__ == "__main__":
    main()
