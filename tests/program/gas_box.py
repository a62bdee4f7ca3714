# SPDX-License-Identifier: GPL-3.0-or-later
"""A box of gas, 0.1 m x 0.1 m x 0.2 m high, of 4 x 4 x 8 cells with a patch on each side, and in it one light sphere of
0.1 mm that falls: what the gas does is that of the gas alone."""

import os

import support

SIDES = {"bottom": "(0 3 2 1)", "top": "(4 5 6 7)", "left": "(0 4 7 3)", "right": "(1 2 6 5)", "front": "(0 1 5 4)", "back": "(3 7 6 2)"}
FLOOR = ((0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1))

CONTROL = """application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime {end}; deltaT 1e-3;
writeControl timeStep; writeInterval 1000000; writeFormat ascii; writePrecision 12; timePrecision 10; runTimeModifiable no;
"""

COUPLING = """method DEM;
particles { script "dem/in.liggghts"; solidStep 1e-4; }
gas { model pimple; coupling oneWay; }
drag { law SchillerNaumann; }
mapping { type cellCentre; }
records { interval 1e-3; }
"""

SCRIPT = """units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block -0.1 0.2 -0.1 0.2 -0.1 0.3 units box
create_box 1 box
create_atoms 1 single {sphere} 0.11 units box
set group all diameter 1e-4 density 100
neighbor 0.01 bin
neigh_modify delay 0
fix gravity all gravity 9.81 vector 0.0 0.0 -1.0
fix move all nve/sphere
thermo_modify norm no lost ignore
"""

SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; "div\\(.*[pP]hi.*,U\\)" Gauss upwind; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; } wallDist { method meshWave; }
"""

SOLUTION = """solvers { "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; }
"U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-12; relTol 0; } }
PIMPLE { nOuterCorrectors 1; nCorrectors 2; %s }
"""

WALL = {"U": "type noSlip;", "p_rgh": "type fixedFluxPressure; gradient uniform 0; value uniform 0;"}
INLET = {"U": "type fixedValue; value uniform (0 0 0.5);", "p_rgh": WALL["p_rgh"]}
OUTLET = {"U": "type pressureInletOutletVelocity; value uniform (0 0 0);", "p_rgh": "type fixedValue; value uniform 0;"}


def _file(folder, name, kind, text):
    head = f"FoamFile {{ version 2.0; format ascii; class {kind}; object {os.path.basename(name)}; }}\n"
    support.write(os.path.join(folder, name), head + text)


def write(folder, patches=(), types=(), end=0.004, control="", solution="", density=1.2, viscosity=1.8e-5, at_start="(0 0 0)",
          cells="4 4 8", floor=FLOOR, sphere="0.051 0.051", files=(), mesh=True):  # fmt: skip
    """The case in `folder`, with its mesh unless told otherwise. `patches`: {patch: {"U": ..., "p_rgh": ...}} takes the place of an inlet of
    0.5 m/s at the bottom, an outlet at the top and walls; `types`: {patch: type of the mesh, with what it needs};
    `floor`: the corners' x and y [m]; `files`: {name: text} beside the case's own."""
    conditions = {side: {**WALL} for side in SIDES}
    conditions["bottom"], conditions["top"] = {**INLET}, {**OUTLET}
    for side, changed in dict(patches).items():
        conditions[side].update(changed)
    of_mesh = {side: "type wall;" for side in SIDES} | {"bottom": "type patch;", "top": "type patch;"} | dict(types)

    corners = " ".join(f"({x} {y} {z})" for z in (0, 0.2) for x, y in floor)
    sides = "".join(f"{side} {{ {of_mesh[side]} faces ({corner}); }}\n" for side, corner in SIDES.items())
    _file(folder, "system/blockMeshDict", "dictionary",
          f"scale 1; vertices ({corners}); edges (); blocks (hex (0 1 2 3 4 5 6 7) ({cells}) simpleGrading (1 1 1));\n"
          f"boundary ({sides});\n")  # fmt: skip
    for field, kind, unit, inner in (("U", "volVectorField", "[0 1 -1 0 0 0 0]", at_start), ("p_rgh", "volScalarField", "[1 -1 -2 0 0 0 0]", "0")):
        of_patches = "".join(f"{side} {{ {conditions[side][field]} }}\n" for side in SIDES)
        _file(folder, f"0/{field}", kind, f"dimensions {unit}; internalField uniform {inner};\nboundaryField {{ {of_patches} }}\n")
    _file(folder, "constant/transportProperties", "dictionary", f"rho {density}; mu {viscosity};\n")
    _file(folder, "constant/g", "uniformDimensionedVectorField", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n")
    _file(folder, "system/controlDict", "dictionary", CONTROL.format(end=end) + control)
    _file(folder, "system/couplingDict", "dictionary", COUPLING)
    _file(folder, "system/fvSchemes", "dictionary", SCHEMES)
    _file(folder, "system/fvSolution", "dictionary", SOLUTION % solution)
    _file(folder, "system/decomposeParDict", "dictionary", "numberOfSubdomains 2; method simple; simpleCoeffs { n (1 1 2); delta 0.001; }\n")
    support.write(os.path.join(folder, "dem/in.liggghts"), SCRIPT.format(sphere=sphere))
    for name, text in dict(files).items():
        _file(folder, name, "uniformDimensionedScalarField" if name.endswith("hRef") else "dictionary", text)
    if mesh:
        support.must(folder, "blockMesh")
    return folder


def last_line(done, file):
    """The numbers of the last line that a function object wrote to postProcessing/`file`, the time first."""
    line = support.read(done.path("postProcessing", file)).splitlines()[-1]
    return [float(word) for word in line.replace("(", " ").replace(")", " ").split()]
