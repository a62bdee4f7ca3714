# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed boxes of parcels in a fluid, run by interphase with the plug-in mp_pic (or another integrator for comparison)."""

import os

import numpy

import support
from interphase import data_file

SOURCE = os.environ.get("INTERPHASE_SOURCE") or os.path.realpath(os.path.join(os.path.dirname(__file__), "..", "..", ".."))

HEAD = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
SIDES = {"low_x": (0, 4, 7, 3), "high_x": (1, 2, 6, 5), "low_y": (0, 1, 5, 4), "high_y": (3, 7, 6, 2), "low_z": (0, 3, 2, 1),
         "high_z": (4, 5, 6, 7)}  # fmt: skip

SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; } interpolationSchemes { default linear; }
divSchemes { default Gauss linear; "div\\(.*[pP]hi.*,U\\)" Gauss limitedLinearV 1; }
laplacianSchemes { default Gauss linear corrected; } snGradSchemes { default corrected; }
"""
SOLUTION = """solvers
{
    "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; }
    "U.*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; p_rghRefCell 0; p_rghRefValue 0; }
"""
RESTITUTION = """fix en all property/global coefficientRestitution peratomtypepair 2 {e} {en} {en} {en}
fix et all property/global tangentialRestitution peratomtypepair 2 1.0 {et} {et} {et}
"""
PLANES = "".join(f"fix {axis}{end} all wall/mp_pic primitive type 2 {axis}plane ${{{end}{axis}}}\n" for axis in "xyz" for end in ("low", "high"))  # fmt: skip


class Box:
    """size [m, 3], cells [3], parcels: diameter (one or [n]) and density of the tracked spheres, position [n, 3], velocity [n, 3]."""

    def __init__(self, size, cells, diameter, density, position, velocity=None, weight=1, gravity=0.0, fluid=(1.2, 1.8e-5),
                 step=1e-3, end=1e-2, e=0.9, en=0.9, et=1.0, integrator="fix move all mp_pic\n", walls=PLANES, gas="model pimple; coupling twoWay;",
                 particles="", mapping="type kernel;", write_every=None, sides="slip", method="MPPIC", law="BVK", more="", plugins="mp_pic"):  # fmt: skip
        self.__dict__.update(locals())
        self.position = numpy.atleast_2d(numpy.asarray(position, float))
        self.diameter = numpy.broadcast_to(numpy.asarray(diameter, float), len(self.position))
        self.velocity = numpy.zeros_like(self.position) if velocity is None else numpy.atleast_2d(numpy.asarray(velocity, float))

    def script(self):
        size = self.size
        low = "".join(f"variable low{axis} equal 0.0\nvariable high{axis} equal {length!r}\n" for axis, length in zip("xyz", size))
        return (
            "units si\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\ncommunicate single vel yes\n"
            f"processors 1 1 *\nread_data dem/parcels.data\nneighbor {float(self.diameter.max())!r} bin\nneigh_modify delay 0\n"
            + low + RESTITUTION.format(e=self.e, en=self.en, et=self.et) + self.more + self.walls
            + f"fix gravity all gravity {self.gravity!r} vector 0 0 -1\n" + self.integrator
            + "thermo_style custom step atoms ke\nthermo 100000\nthermo_modify norm no lost ignore\n"
        )  # fmt: skip

    def data(self):
        return data_file.text("parcels", (0, 0, 0), self.size, self.position, self.diameter, self.density, velocity=self.velocity)

    def write(self, folder, ranks=1):
        put = lambda path, kind, text: support.write(os.path.join(folder, path),  # noqa: E731
                                                     HEAD.format(kind=kind, name=os.path.basename(path)) + text)  # fmt: skip
        x, y, z = self.size
        corners = " ".join(f"({a} {b} {c})" for c in (0, z) for a, b in ((0, 0), (x, 0), (x, y), (0, y)))
        patches = "\n".join(f"{name} {{ type wall; faces (({' '.join(map(str, face))})); }}" for name, face in SIDES.items())
        put("system/blockMeshDict", "dictionary",
            f"scale 1; vertices ({corners}); blocks (hex (0 1 2 3 4 5 6 7) ({' '.join(map(str, self.cells))}) simpleGrading (1 1 1));\n"
            f"edges (); boundary (\n{patches}\n); mergePatchPairs ();\n")  # fmt: skip
        put("system/controlDict", "dictionary",
            f"application interphase; startFrom startTime; startTime 0; stopAt endTime; endTime {self.end!r}; deltaT {self.step!r};\n"
            f"writeControl adjustableRunTime; writeInterval {self.write_every or self.end!r}; writeFormat ascii; writePrecision 10; timePrecision 8;\n")  # fmt: skip
        put("system/fvSchemes", "dictionary", SCHEMES)
        put("system/fvSolution", "dictionary", SOLUTION)
        put("system/decomposeParDict", "dictionary",
            f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n (1 1 {ranks}); delta 0.001; }}\n")  # fmt: skip
        put("system/couplingDict", "dictionary",
            f'method {self.method}; weight {self.weight!r}; plugins ({self.plugins});\nparticles {{ script "dem/in.liggghts"; {self.particles} }}\n'
            f"gas {{ {self.gas} }}\ndrag {{ law {self.law}; }}\nmapping {{ {self.mapping} }}\n"
            f"records {{ interval {self.write_every or self.end!r}; }}\n")  # fmt: skip
        put("constant/transportProperties", "dictionary",
            f"rho [1 -3 0 0 0 0 0] {self.fluid[0]!r}; mu [1 -1 -1 0 0 0 0] {self.fluid[1]!r};\n")  # fmt: skip
        put("constant/g", "uniformDimensionedVectorField", f"dimensions [0 1 -2 0 0 0 0]; value (0 0 {-self.gravity!r});\n")
        put("0/U", "volVectorField",
            f'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField {{ ".*" {{ type {self.sides}; }} }}\n')  # fmt: skip
        put("0/p_rgh", "volScalarField",
            "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;\n"
            'boundaryField { ".*" { type fixedFluxPressure; gradient uniform 0; value uniform 0; } }\n')  # fmt: skip
        support.write(os.path.join(folder, "dem/in.liggghts"), self.script())
        support.write(os.path.join(folder, "dem/parcels.data"), self.data())
        for command in ["blockMesh"] + (["decomposePar"] if ranks > 1 else []):
            support.must(folder, command)
        return folder


def weighted(weights, default=1):
    """Lines of a script that give particle i + 1 the weight weights[i], as the README has them."""
    text = f"fix weights all property/atom weight scalar yes no no {default!r}\nrun 0\n"
    for number, weight in enumerate(sorted(set(weights) - {default})):
        ids = [str(i + 1) for i, w in enumerate(weights) if w == weight]
        for start in range(0, len(ids), 200):  # a line of LIGGGHTS ends somewhere
            text += f"group w{number} id {' '.join(ids[start:start + 200])}\n"
        text += f"set group w{number} property/atom weight {weight!r}\n"
    return text


def lattice(size, counts):
    """counts[0] x counts[1] x counts[2] places, evenly in the box."""
    axes = [(numpy.arange(n) + 0.5) * length / n for n, length in zip(counts, size)]
    return numpy.stack([k.ravel() for k in numpy.meshgrid(*axes, indexing="ij")], axis=1)


def field(folder, time, name):
    """Values of a cell field of a run on one rank that was written at `time`."""
    lines = support.read(folder, f"{time:.8g}", name).splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("internalField"))
    if " uniform" in lines[start]:
        return numpy.array([float(lines[start].split()[-1].rstrip(";"))])
    count = int(lines[start + 1])
    return numpy.array([float(line) for line in lines[start + 3:start + 3 + count]])
