# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 300
# processors: 2
"""Function objects of OpenFOAM as users of a solver for p_rgh know them: they work on one rank and on two, or are refused
by name with what to take in their place. What `forces` reports is checked in tests/engines/openfoam/wall_forces_test.cpp."""

import os
import shutil

import gas_box
import support

FIELDS, FORCES, SAMPLING, UTILITY = "libs (fieldFunctionObjects);", "libs (forces);", "libs (sampling);", "libs (utilityFunctionObjects);"

WORKING = {
    "forces": f"{FORCES} patches (left); CofR (0 0 0);",
    "forceCoeffs": f"{FORCES} patches (left); rho rhoInf; rhoInf 1.2; magUInf 1; lRef 1; Aref 1; CofR (0 0 0); liftDir (1 0 0); dragDir (0 0 1); "
                   "pitchAxis (0 1 0);",
    "probes": f"{SAMPLING} fields (U p rho voidage); probeLocations ((0.06 0.06 0.11));",
    "patchProbes": f"{SAMPLING} fields (p); patches (top); probeLocations ((0.06 0.06 0.2));",
    "sets": f"{SAMPLING} interpolationScheme cellPoint; setFormat raw; fields (U p); sets (line {{ type uniform; axis z; start (0.06 0.06 0); "
            "end (0.06 0.06 0.2); nPoints 5; });",
    "surfaces": f"{SAMPLING} interpolationScheme cellPoint; surfaceFormat vtk; fields (U p); surfaces (middle {{ type cuttingPlane; "
                "planeType pointAndNormal; pointAndNormalDict { point (0.05 0.05 0.11); normal (0 0 1); } interpolate true; });",
    "surfaceFieldValue": f"{FIELDS} regionType patch; name top; operation weightedAverage; weightField voidagePhi; fields (p); writeFields no;",
    "volFieldValue": f"{FIELDS} regionType all; operation weightedVolIntegrate; weightField voidage; fields (U); writeFields no;",
    "fieldAverage": f"{FIELDS} fields (U {{ mean on; prime2Mean on; base time; }} p {{ mean on; prime2Mean off; base time; }});",
    "fieldMinMax": f"{FIELDS} fields (U p);",
    "yPlus": FIELDS,
    "wallShearStress": FIELDS,
    "CourantNo": FIELDS,
    "PecletNo": FIELDS,
    "continuityError": f"{FIELDS} phi voidagePhi;",
    "turbulenceFields": f"{FIELDS} fields (k epsilon nut R devReff);",
    "pressure": f"{FIELDS} mode total; pRef 0;",
    "derivedFields": f"{FIELDS} derived (rhoU pTotal);",
    "histogram": f"{FIELDS} field p; nBins 10; setFormat raw;",
    "vorticity": FIELDS,
    "Q": FIELDS,
    "enstrophy": FIELDS,
    "grad": f"{FIELDS} field U;",
    "div": f"{FIELDS} field voidagePhi;",
    "mag": f"{FIELDS} field U;",
    "flux": f"{FIELDS} field U;",
    "nearWallFields": f"{FIELDS} fields ((U Unear)); patches (left); distance 0.01;",
    "solverInfo": f"{UTILITY} fields (U p_rgh);",
    "writeObjects": f"{UTILITY} objects (rho gh voidagePhi); writeOption anyWrite;",
    "timeInfo": UTILITY,
}

# What is in postProcessing or among the fields of the last time when it worked.
WRITES = {"forces": "forces/0/force.dat", "forceCoeffs": "forceCoeffs/0/coefficient.dat", "probes": "probes/0/p", "sets": "sets/0.002",
          "surfaces": "surfaces/0.002", "surfaceFieldValue": "surfaceFieldValue/0/surfaceFieldValue.dat", "yPlus": "yPlus/0/yPlus.dat",
          "wallShearStress": "wallShearStress/0/wallShearStress.dat", "fieldMinMax": "fieldMinMax/0/fieldMinMax.dat",
          "solverInfo": "solverInfo/0/solverInfo.dat", "volFieldValue": "volFieldValue/0/volFieldValue.dat"}  # fmt: skip
FIELDS_WRITTEN = ("UMean", "pMean", "Co", "Pe", "vorticity", "Q", "grad(U)", "div(voidagePhi)", "mag(U)", "rho", "gh", "voidagePhi")

REFUSED = {
    "scalarTransport": ("libs (solverFunctionObjects); field T;", "shared with particles"),
    "setTimeStep": (f"{UTILITY} deltaT constant 1e-3;", "the coupler chooses(.|\n)*maxDeltaT"),
    "momentum": (f"{FIELDS} regionType all;", "as if the gas filled them(.|\n)*weightField voidage"),
    "streamFunction": (FIELDS, "not conserved(.|\n)*field voidagePhi"),
    "continuityError": (FIELDS, "not conserved(.|\n)*phi voidagePhi"),
    "residuals": (f"{UTILITY} fields (U);", "another name(.|\n)*take solverInfo"),
    "wallHeatFlux": (FIELDS, "Unable to find compressible turbulence model"),
    "XiReactionRate": (FIELDS, "asks for the volScalarField `b`(.|\n)*name a field that is there"),
    "coded": (f"{UTILITY} name c; codeWrite #{{ #}};", "wmake|dynamicCode"),
    "forcez": (FORCES, r"could not make(.|\n)*\| Unknown function type forcez"),
    "probes": (SAMPLING, r"OpenFOAM stopped at a function object(.|\n)*\| Entry '(fields|probeLocations)' not found"),
}


def functions(chosen):
    blocks = "".join(f"{name} {{ type {name}; writeControl timeStep; log no; {text} }}\n" for name, text in chosen.items())
    return f"functions {{\n{blocks}}}\n"


class FunctionObjects(support.ProgramTest):
    def box(self, chosen, ranks=1, **scene):
        folder = os.path.join(self.root, "box")
        shutil.rmtree(folder, ignore_errors=True)
        gas_box.write(folder, control=functions(chosen), end=0.002, **scene)
        if ranks > 1:
            support.must(folder, "decomposePar")
        return support.execute(folder, ranks, timeout=60)

    def test_they_work(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                done = self.box(WORKING, ranks)
                self.assertEqual(done.code, 0, done.text[-2000:])
                self.assertNotIn("FOAM Warning", support.read(done.path("log.openfoam")))
                for name, path in WRITES.items():
                    self.assertTrue(os.path.exists(done.path("postProcessing", path)), name)
                fields = os.listdir(done.path("processor0" if ranks > 1 else "", "0.002"))
                for name in FIELDS_WRITTEN:
                    self.assertIn(name, fields)
                # the pressure of the column at the probe's cell, its centre at 0.1125 m, and the density
                density = float(support.read(done.path("postProcessing/probes/0/rho")).split()[-1])
                self.assertEqual(density, 1.2)

    def test_refused_by_name(self):
        for name, (text, expected) in REFUSED.items():
            with self.subTest(name):
                done = self.box({name: text})
                self.assertIn(done.code, (1, 5), done.text[-2000:])  # what we, what OpenFOAM refuses
                self.assertEqual(done.text.count("interphase: error:"), 1, done.text)
                self.assertRegex(done.text, expected)
                self.assertRegex(done.text, f"where:  system/controlDict, functions(/{name} of type {name})?")

    def test_one_that_is_off_is_let_be(self):
        done = self.box({"momentum": f"{FIELDS} regionType all; enabled no;"})
        self.assertEqual(done.code, 0, done.text[-2000:])

    def test_refused_on_two_ranks(self):
        for name in ("forcez", "probes", "XiReactionRate"):
            with self.subTest(name):
                done = self.box({name: REFUSED[name][0]}, 2)
                self.assertNotEqual(done.code, 0)
                self.assertEqual(done.text.count("interphase: error:"), 1, done.text)
                self.assertRegex(done.text, REFUSED[name][1])
