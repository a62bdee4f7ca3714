# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a case that OpenFOAM's solvers act on and this gas does not are refused with their place and what to do; the
same files are let be where they ask for nothing, and so are copies that editors leave."""

import os

import gas_box
import support

ZONE = "zone1 { %s cellZone rotor; origin (0 0 0); axis (0 0 1); omega 10; }"

REFUSED = {
    "constant/dynamicMeshDict": ("dynamicFvMesh dynamicMotionSolverFvMesh;", "moves or refines.*where: +constant/dynamicMeshDict, line 2.*staticFvMesh"),
    "constant/MRFProperties": (ZONE % "", "rotating frames.*constant/MRFProperties.*active no"),
    "constant/fvOptions": ("heat { type scalarSemiImplicitSource; }", "fvOptions.*constant/fvOptions"),
    "system/fvOptions": ("heat { type scalarSemiImplicitSource; active yes; }", "fvOptions.*system/fvOptions"),
    "constant/porosityProperties": ("filter { type DarcyForchheimer; active yes; }", "porous zones"),
    "constant/turbulenceProperties": ("simulationType RAS; RAS { RASModel kEpsilon; }", "turbulence.*turbulenceProperties, line 2.*laminar"),
    "constant/turbulenceProperties.air": ("simulationType LES;", r"turbulence.*turbulenceProperties\.air"),
    "constant/RASProperties": ("RASModel kEpsilon; turbulence on;", "turbulence.*RASProperties"),
    "constant/thermophysicalProperties": ("thermoType { type heRhoThermo; }", "temperature.*thermophysicalProperties"),
    "constant/radiationProperties": ("radiation on; radiationModel P1;", "radiation.*radiation off"),
    "constant/combustionProperties": ("combustionModel EDC;", "combustion"),
    "constant/chemistryProperties": ("chemistry on;", "chemistry"),
    "constant/phaseProperties": ("phases (air water);", "phases"),
    "constant/regionProperties": ("regions ();", "regions"),
    "constant/kinematicCloudProperties": ("solution { active true; }", "cloud.*LIGGGHTS.*active false"),
    "constant/reactingCloud1Properties": ("solution { active true; }", "cloud.*active false"),
    "constant/surfaceFilmProperties": ("active yes;", "surfaceFilmProperties"),
}

LET_BE = {
    "constant/dynamicMeshDict": "dynamicFvMesh staticFvMesh;",
    "constant/MRFProperties": ZONE % "active no;",
    "system/fvOptions": "heat { type scalarSemiImplicitSource; active false; }",
    "constant/turbulenceProperties": "simulationType laminar;",
    "constant/turbulenceProperties.air": "simulationType laminar;",
    "constant/RASProperties": "RASModel laminar; turbulence on;",
    "constant/radiationProperties": "radiation off; radiationModel P1;",
    "constant/combustionProperties": "active false; combustionModel EDC;",
    "constant/chemistryProperties": "chemistry off;",
    "constant/kinematicCloudProperties": "solution { active false; }",
    "constant/thermophysicalProperties.orig": "thermoType { type heRhoThermo; }",
    "constant/phaseProperties~": "phases (air water);",
    "constant/table": "7",
}  # fmt: skip

HEAD = "FoamFile { version 2.0; format ascii; class dictionary; object any; }\n"


class UnsolvedFiles(support.ProgramTest):
    def setUp(self):
        super().setUp()
        self.folder = gas_box.write(os.path.join(self.root, "box"), end=0.001)

    def refused(self, expected, ranks=1):
        done = support.execute(self.folder, ranks, timeout=60)
        self.assertEqual(done.code, 1, done.text)
        self.assertEqual(done.text.count("remedy:"), 1, done.text)
        self.assertRegex(done.text, f"(?s)interphase: error: .*{expected}")

    def test_refused_with_place_and_remedy(self):
        for file, (text, expected) in REFUSED.items():
            with self.subTest(file):
                support.write(os.path.join(self.folder, file), HEAD + text)
                try:
                    self.refused(expected)
                finally:
                    os.remove(os.path.join(self.folder, file))

    def test_once_on_two_ranks(self):
        support.must(self.folder, "decomposePar")
        support.write(os.path.join(self.folder, "constant/MRFProperties"), HEAD + REFUSED["constant/MRFProperties"][0])
        self.refused("rotating frames", 2)

    def test_let_be_where_they_ask_for_nothing(self):
        for file, text in LET_BE.items():
            support.write(os.path.join(self.folder, file), HEAD + text)
        self.run_case(self.folder)

    def test_viscosities(self):
        properties = os.path.join(self.folder, "constant/transportProperties")
        gas = support.read(properties)
        support.write(properties, gas + "transportModel CrossPowerLaw;\n")
        self.refused("another viscosity.*transportProperties, line 3.*Newtonian")
        support.write(properties, gas + "nu 1e-6;\n")
        self.refused("nu = 1e-06 m2/s contradicts mu / rho = 1.5e-05 m2/s.*line 3")
        support.write(properties, gas + "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 1.5e-5;\n")
        self.run_case(self.folder)
