# SPDX-License-Identifier: GPL-3.0-or-later
"""A small vessel, blown from below, whose spheres come and go as a test says: cases/sscp1 with a script of its own."""

import os
import shutil

import support

WIDTH, DEPTH, HEIGHT = 0.048, 0.024, 0.096  # [m]
CELLS = "(8 4 16)"
DIAMETER, DENSITY = 2e-3, 1131.0  # [m], [kg/m3]
GAS_STEP = 1e-3  # [s]

HEAD = """\
units           si
atom_style      granular
atom_modify     map array
boundary        {boundary}
newton          off
communicate     single vel yes
processors      * 1 1
region          vessel block {box} units box
create_box      2 vessel
"""
# the walls that sscp1's scripts have, as far as they are kept
SCENE = """\
variable left   equal 0.0
variable right  equal ${width}
variable front  equal 0.0
variable back   equal ${depth}
variable bottom equal 0.0
variable top    equal ${height}
variable stress     string "stress harris_crighton 100 3 close_packing 0.6"
variable wallSlide  equal ${wallTangentialRestitution}
"""
TAIL = """\
fix gravity all gravity ${gravity} vector 0.0 0.0 -1.0
thermo_style    custom step atoms ke
thermo          100000
thermo_modify   norm no lost ignore
"""


def bed(layers, above=0, diameter=DIAMETER, spacing=1.02, kind=1):
    """(script lines, number) of a simple cubic lattice of spheres, `layers` high, above as many empty layers."""
    a = spacing * diameter
    nx, ny = int(WIDTH / a), int(DEPTH / a)
    lines = f"""\
lattice         sc {a!r} origin 0.5 0.5 0.5
region          bed block 0 {nx * a!r} 0 {ny * a!r} {above * a!r} {(above + layers) * a!r} units box
create_atoms    {kind} region bed
set             type {kind} diameter {diameter!r} density {DENSITY!r}
"""
    return lines, nx * ny * layers


WALLS = ("left", "right", "front", "back", "bottom", "top")


def case(root, particles="", fixes="", boundary="f f f", box=None, walls=WALLS, edits=()):
    """A case folder below `root`. `particles`: script lines before contacts, `fixes`: after them; `box`: of the particles."""
    folder = os.path.join(root, "vessel")
    others = shutil.ignore_patterns("*.png", "prepare", "README.md")
    shutil.copytree(os.path.join(support.SOURCE, "cases", "sscp1"), folder, ignore=others)
    box = box or f"0 {WIDTH} 0 {DEPTH} 0 {HEIGHT}"
    support.write(
        os.path.join(folder, "dem/in.liggghts"),
        HEAD.format(boundary=boundary, box=box) + particles
        + "include dem/scene.liggghts\ninclude dem/${method}.liggghts\n" + TAIL + fixes,
    )
    support.write(os.path.join(folder, "dem/scene.liggghts"), SCENE)
    for name in WALLS:
        if name in walls:
            continue
        for file in ("soft_spheres", "hard_spheres", "MPPIC"):
            support.ProgramTest.edit(folder, f"dem/{file}.liggghts", rf"^fix {name} .*$", "")
    edit = support.ProgramTest.edit
    edit(folder, "system/blockMeshDict", r"\(16 4 85\)", CELLS)
    low, high = (f"({WIDTH / 2} {DEPTH / 2} {z})" for z in (0.003, 0.093))
    edit(folder, "system/couplingDict", r"^    pressureTaps .*$", f"    pressureTaps ({low} {high});")
    edit(folder, "system/couplingDict", r"interval            0.05;", f"interval {GAS_STEP};")
    for file, pattern, replacement in edits:
        edit(folder, file, pattern, replacement)
    return folder


NUMBERS = {"width": WIDTH, "depth": DEPTH, "height": HEIGHT, "diameter": DIAMETER, "weight": 1, "inletVelocity": 0.8}


def numbered(folder, method):
    """That case with its own numbers in `parameters`, for tools/run."""
    for name, value in {**NUMBERS, "method": method}.items():
        support.ProgramTest.set_entry(folder, "parameters", name, value)
    return folder


def prepared(test, folder, method, ranks=1, until=0.05, **settings):
    """That case, meshed and cut into parts."""
    run = os.path.join(os.path.dirname(folder), f"run-{method}-{ranks}")
    return test.prepare(folder, run, ranks, until=until, **{**NUMBERS, "method": method, **settings})
