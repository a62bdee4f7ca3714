# SPDX-License-Identifier: GPL-3.0-or-later
# timeout: 600
"""Boundary conditions of OpenFOAM as users of a solver for p_rgh know them: each does what it says, or is refused by
name, with what to take in its place."""

import os
import shutil

import gas_box
import support

REPORT = """functions {
    %s
}
"""
ON_PATCH = """{name} {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name {patch}; operation {operation};
    fields ({field}); writeFields no; log no; writeControl timeStep; }}
"""
SCALAR, VECTOR = "value uniform 0;", "value uniform (0 0 0);"
RHO, WEIGHT = 1.2, 9.81 * 1.2  # kg/m3, N/m3
FLOW = 0.5 * 0.01  # of the box's own inlet [m3/s]

# Conditions of the top, where the gas leaves: for p_rgh, U or both; what p_rgh [Pa] is there, or None.
LEAVING = {
    "fixedValue": ({"p_rgh": "type fixedValue; value uniform 7;"}, 7),
    "prghPressure": ({"p_rgh": f"type prghPressure; p uniform 100; {SCALAR}"}, 100 + WEIGHT * 0.2),
    "totalPressure": ({"p_rgh": f"type totalPressure; p0 uniform 100; {SCALAR}"}, 100),
    "prghTotalPressure": ({"p_rgh": f"type prghTotalPressure; p0 uniform 100; {SCALAR}"}, 100 + WEIGHT * 0.2),
    "uniformTotalPressure": ({"p_rgh": "type uniformTotalPressure; p0 table ((0 0) (1 100));"}, 0.4),
    "rotatingTotalPressure": ({"p_rgh": f"type rotatingTotalPressure; omega (0 0 1); p0 uniform 5; {SCALAR}"}, 5),
    "fixedMean": ({"p_rgh": f"type fixedMean; meanValue 5; {SCALAR}"}, 5),
    "uniformFixedValue": ({"p_rgh": f"type uniformFixedValue; uniformValue table ((0 0) (1 100)); {SCALAR}"}, 0.4),
    "exprFixedValue": ({"p_rgh": f'type exprFixedValue; valueExpr "3"; {SCALAR}'}, 3),
    "fanPressure": ({"p_rgh": f'type fanPressure; file "constant/fan"; outOfBounds clamp; direction out; p0 uniform 0; {SCALAR}'}, -10),
    "advective": ({"p_rgh": f"type advective; {SCALAR}"}, None),
    "outletInlet": ({"p_rgh": f"type outletInlet; outletValue uniform 0; {SCALAR}"}, 0),
    "timeVaryingMappedFixedValue": ({"p_rgh": "type timeVaryingMappedFixedValue; mapMethod nearest;"}, 4),
    "freestream": ({"U": "type freestream; freestreamValue uniform (0 0 0.5);"}, 0),
    "inletOutlet": ({"U": f"type inletOutlet; inletValue uniform (0 0 0); {VECTOR}"}, 0),
    "zeroGradient": ({"U": "type zeroGradient;"}, 0),
    "advective of U": ({"U": f"type advective; {VECTOR}"}, 0),
    "pressureNormalInletOutletVelocity": ({"U": f"type pressureNormalInletOutletVelocity; {VECTOR}"}, 0),
    "pressureDirectedInletOutletVelocity": ({"U": f"type pressureDirectedInletOutletVelocity; inletDirection uniform (0 0 1); {VECTOR}"}, 0),
    "fluxCorrectedVelocity": ({"U": f"type fluxCorrectedVelocity; {VECTOR}"}, 0),
    "flowRateOutletVelocity": ({"U": f"type flowRateOutletVelocity; volumetricFlowRate {FLOW}; {VECTOR}"}, 0),
}

# Conditions of the bottom, where it enters; the flow in [m3/s].
ENTERING = {
    "fixedValue": ("type fixedValue; value uniform (0 0 0.3);", 0.003),
    "flowRateInletVelocity, mass": (f"type flowRateInletVelocity; massFlowRate 0.006; {VECTOR}", 0.006 / RHO),
    "flowRateInletVelocity, volume": ("type flowRateInletVelocity; volumetricFlowRate 0.004;", 0.004),
    "flowRateInletVelocity, profile": (f"type flowRateInletVelocity; volumetricFlowRate 0.004; extrapolateProfile yes; {VECTOR}", 0.004),
    "swirlFlowRateInletVelocity": (f"type swirlFlowRateInletVelocity; flowRate constant 0.004; rpm constant 10; {VECTOR}", 0.004),
    "swirlInletVelocity": ("type swirlInletVelocity; axis (0 0 1); origin (0.05 0.05 0); axialVelocity constant 0.4; "
                           f"radialVelocity constant 0; tangentialVelocity constant 0.1; {VECTOR}", 0.004),
    "cylindricalInletVelocity": ("type cylindricalInletVelocity; axis (0 0 1); origin (0.05 0.05 0); axialVelocity constant 0.4; "
                                 f"radialVelocity constant 0; rpm constant 0; {VECTOR}", 0.004),
    "surfaceNormalFixedValue": ("type surfaceNormalFixedValue; refValue uniform -0.4;", 0.004),
    "uniformNormalFixedValue": ("type uniformNormalFixedValue; uniformValue constant -0.4;", 0.004),
    "uniformFixedValue": (f"type uniformFixedValue; uniformValue table ((0 (0 0 0)) (0.01 (0 0 1))); {VECTOR}", 0.004),
    "uniformInletOutlet": (f"type uniformInletOutlet; uniformInletValue (0 0 0.4); {VECTOR}", 0),
    "exprFixedValue": (f'type exprFixedValue; valueExpr "vector(0, 0, 0.4)"; {VECTOR}', 0.004),
    "fixedProfile": ("type fixedProfile; profile polynomial (((0 0 0.4) (0 0 0))); direction (1 0 0); origin 0;", 0.004),
    "interstitialInletVelocity": (f"type interstitialInletVelocity; inletVelocity uniform (0 0 0.4); alpha voidage; {VECTOR}", 0.004),
    "turbulentInlet": (f"type turbulentInlet; referenceField uniform (0 0 0.4); fluctuationScale (0 0 0); value uniform (0 0 0.4);", 0.004),
    "noSlip": ("type noSlip;", 0),
    "slip": ("type slip;", 0),
    "partialSlip": ("type partialSlip; valueFraction uniform 0.5;", 0),
    "movingWallVelocity": (f"type movingWallVelocity; {VECTOR}", 0),
    "translatingWallVelocity": ("type translatingWallVelocity; U (1 0 0);", 0),
    "rotatingWallVelocity": ("type rotatingWallVelocity; origin (0.05 0.05 0); axis (0 0 1); omega 1;", 0),
}

# Field of the top, its condition, and what the message says.
REFUSED = {
    "waveTransmissive": ("p_rgh", f"type waveTransmissive; gamma 1.4; {SCALAR}", "compressible.*(.|\n)*take `advective`"),
    "waveTransmissive of U": ("U", f"type waveTransmissive; gamma 1.4; {VECTOR}", "compressible.*(.|\n)*take `advective`"),
    "uniformDensityHydrostaticPressure": ("p_rgh", f"type uniformDensityHydrostaticPressure; rho 1.2; pRefValue 0; pRefPoint (0 0 0); {SCALAR}",
                                          "p_rgh is without it(.|\n)*`prghPressure`"),
    "phaseHydrostaticPressure": ("p_rgh", f"type phaseHydrostaticPressure; rho 1.2; pRefValue 0; pRefPoint (0 0 0); phaseFraction alpha.air; {SCALAR}",
                                 "free surface(.|\n)*`prghPressure`"),
    "prghTotalHydrostaticPressure": ("p_rgh", f"type prghTotalHydrostaticPressure; {SCALAR}", "ph_rgh(.|\n)*`prghTotalPressure`"),
    "variableHeightFlowRateInletVelocity": ("U", f"type variableHeightFlowRateInletVelocity; flowRate 0.1; alpha alpha.water; {VECTOR}",
                                            "free surface(.|\n)*`flowRateInletVelocity`"),
    "supersonicFreestream": ("U", f"type supersonicFreestream; pInf 1; TInf 1; UInf (0 0 1); gamma 1.4; {VECTOR}",
                             "compressible(.|\n)*`freestreamVelocity`"),
    "totalPressure": ("p_rgh", f"type totalPressure; psi thermo:psi; gamma 1.4; p0 uniform 100; {SCALAR}",
                      r"asks for the volScalarField `thermo:psi`(.|\n)*0/p_rgh, patch `top`, type totalPressure(.|\n)*name a field that is there"),
    "codedFixedValue": ("p_rgh", f"type codedFixedValue; name ramped; code #{{ operator==(3.0); #}}; {SCALAR}",
                        r"p_rgh\.boundaryField\.top, line \d+(.|\n)*(wmake(.|\n)*uniformFixedValue|dynamicCode)"),
    "fixedVaule": ("p_rgh", f"type fixedVaule; {SCALAR}", "fixedVaule(.|\n)*p_rgh.boundaryField.top"),
}

OF_THE_MESH = {
    "symmetry": {"types": {"left": "type symmetry;"}},
    "symmetryPlane": {"types": {"left": "type symmetryPlane;", "right": "type symmetryPlane;"}},
    "cyclic": {"types": {"left": "type cyclic; neighbourPatch right;", "right": "type cyclic; neighbourPatch left;"}},
    "empty": {"types": {"front": "type empty;", "back": "type empty;"}, "cells": "4 1 8"},
    "wedge": {"types": {"front": "type wedge;", "back": "type wedge;"}, "cells": "4 1 8", "sphere": "0.051 0",
              "floor": ((0.01, -0.0005), (0.1, -0.005), (0.1, 0.005), (0.01, 0.0005))},
}  # fmt: skip

FAN = "2\n(\n(0 10)\n(1 10)\n)\n"  # pressure rise [Pa] over flow [m3/s]
MAPPED = {
    "points": "4\n(\n(0 0 0.2)\n(0.1 0 0.2)\n(0 0.1 0.2)\n(0.1 0.1 0.2)\n)\n",
    "0/p_rgh": "4\n(\n4 4 4 4\n)\n",
}


class Box(support.ProgramTest):
    def box(self, patches=(), measured=(), **scene):
        """A run of the box, and the values of `measured`: (patch, field, operation)."""
        functions = "".join(
            ON_PATCH.format(name=f"number{i}", patch=patch, field=field, operation=operation)
            for i, (patch, field, operation) in enumerate(measured)
        )
        folder = os.path.join(self.root, "box")
        shutil.rmtree(folder, ignore_errors=True)
        gas_box.write(folder, patches, control=REPORT % functions, **scene)
        support.write(os.path.join(folder, "constant/fan"), FAN)
        for name, text in MAPPED.items():
            support.write(os.path.join(folder, "constant/boundaryData/top", name), text)
        done = support.execute(folder, timeout=60)
        return done, [gas_box.last_line(done, f"number{i}/0/surfaceFieldValue.dat")[1] for i in range(len(measured)) if done.code == 0]

    def ran(self, *given, **scene):
        done, values = self.box(*given, **scene)
        self.assertEqual(done.code, 0, done.text[-2000:])
        return values

    def refused(self, expected, *given, **scene):
        done, _ = self.box(*given, **scene)
        self.assertIn(done.code, (1, 5), done.text[-2000:])  # what we, what OpenFOAM refuses
        self.assertEqual(done.text.count("interphase: error:"), 1, done.text)
        self.assertRegex(done.text[done.text.index("interphase: error:"):], expected)


class Patches(Box):
    def test_where_the_gas_leaves(self):
        for name, (conditions, pressure) in LEAVING.items():
            with self.subTest(name):
                measured = [("top", "voidagePhi", "sum"), ("top", "p_rgh", "areaAverage")]
                flow, mean = self.ran({"top": conditions}, measured)
                self.assertAlmostEqual(flow, FLOW, delta=1e-7 * FLOW)  # the pressure solver's tolerance
                if pressure is not None:
                    self.assertAlmostEqual(mean, pressure, delta=1e-6 * max(1, abs(pressure)))

    def test_where_it_enters(self):
        for name, (condition, flow) in ENTERING.items():
            with self.subTest(name):
                values = self.ran({"bottom": {"U": condition}}, [("bottom", "voidagePhi", "sum"), ("top", "voidagePhi", "sum")])
                self.assertAlmostEqual(values[0], -flow, delta=1e-6 * FLOW)
                self.assertAlmostEqual(values[1], flow, delta=1e-6 * FLOW)

    def test_a_total_pressure_drives_gas_in(self):
        """With the velocity from the flux the pressure at the inlet is p0 less rho U^2 / 2; both are of the same step but
        for the last correction."""
        for velocity in ("pressureInletVelocity", "pressureInletUniformVelocity", "pressureInletOutletVelocity"):
            for pressure in ("totalPressure; p0 uniform 1", "uniformTotalPressure; p0 constant 1"):
                with self.subTest(velocity, pressure=pressure):
                    bottom = {"U": f"type {velocity}; {VECTOR}", "p_rgh": f"type {pressure}; {SCALAR}"}
                    measured = [("bottom", "voidagePhi", "sum"), ("bottom", "p_rgh", "areaAverage")]
                    sides = {side: {"U": "type slip;"} for side in ("left", "right", "front", "back")}
                    flow, mean = self.ran({"bottom": bottom, **sides}, measured, end=0.1)
                    speed = -flow / 0.01
                    self.assertGreater(speed, 0.2)
                    self.assertAlmostEqual(mean, 1 - RHO / 2 * speed**2, delta=0.02)

    def test_freestream_all_around(self):
        free = {"U": "type freestreamVelocity; freestreamValue uniform (0 0 0.5);", "p_rgh": "type freestreamPressure; freestreamValue uniform 0;"}
        sides = {side: {"U": "type slip;"} for side in ("left", "right", "front", "back")}
        flow, = self.ran({"bottom": free, "top": free, **sides}, [("top", "voidagePhi", "sum")], at_start="(0 0 0.5)")
        self.assertAlmostEqual(flow, FLOW, delta=1e-6 * FLOW)

    def test_of_the_mesh(self):
        for name, scene in OF_THE_MESH.items():
            with self.subTest(name):
                patches = {side: {"U": kind.split(" neigh")[0], "p_rgh": kind.split(" neigh")[0]} for side, kind in scene["types"].items()}
                into, out = self.ran(patches, [("bottom", "voidagePhi", "sum"), ("top", "voidagePhi", "sum")], **scene)
                self.assertAlmostEqual(out, -into, delta=1e-6 * FLOW)
                self.assertLess(into, 0)

    def test_refused_by_name(self):
        for name, (field, condition, expected) in REFUSED.items():
            with self.subTest(name):
                self.refused(expected, {"top": {field: condition}})

    def test_the_level_that_heights_are_counted_from(self):
        """constant/hRef shifts p_rgh against p: p = p_rgh + rho g.x - rho g.hRef."""
        files = {"constant/hRef": "dimensions [0 1 0 0 0 0 0]; value 0.2;"}
        top = {"p_rgh": f"type prghPressure; p uniform 100; {SCALAR}"}
        measured = [("top", "p_rgh", "areaAverage"), ("top", "p", "areaAverage"), ("bottom", "p", "areaAverage"), ("bottom", "p_rgh", "areaAverage")]
        p_rgh, p, p_below, p_rgh_below = self.ran({"top": top}, measured, files=files)
        self.assertAlmostEqual(p_rgh, 100, delta=1e-9)
        self.assertAlmostEqual(p, 100, delta=1e-9)
        self.assertAlmostEqual(p_below - p_rgh_below, WEIGHT * 0.2, delta=1e-9)


class Control(Box):
    CLOSED = {side: {**gas_box.WALL} for side in gas_box.SIDES}

    def test_the_pressure_of_a_cell(self):
        """In the first cell, at 0.0125 m, and thus at the bottom: p_rgh is uniform in gas at rest."""
        for control, at_bottom in (("pRefCell 0; pRefValue 50;", 50 + WEIGHT * 0.0125), ("p_rghRefCell 0; p_rghRefValue 50;", 50),
                                   ("pRefPoint (0.05 0.05 0.19); pRefValue 50;", 50 + WEIGHT * 0.1875)):  # fmt: skip
            with self.subTest(control):
                p, = self.ran(self.CLOSED, [("bottom", "p", "areaAverage")], solution=control)
                self.assertAlmostEqual(p, at_bottom, delta=1e-6)

    def test_none_or_two_of_them(self):
        self.refused("no boundary condition of p_rgh gives a pressure(.|\n)*fvSolution, PIMPLE(.|\n)*pRefCell 0; pRefValue 0;", self.CLOSED)
        self.refused("two references", self.CLOSED, solution="pRefCell 0; pRefValue 0; p_rghRefCell 0; p_rghRefValue 0;")

    def test_control_of_another_solver(self):
        folder = gas_box.write(os.path.join(self.root, "box"))
        self.edit(folder, "system/fvSolution", "PIMPLE", "PISO")
        done = support.execute(folder)
        self.assertEqual(done.code, 1)
        self.assertRegex(done.text, r"stands in PISO(.|\n)*fvSolution, line \d+(.|\n)*rename the block to PIMPLE")

    def test_time_schemes(self):
        for scheme in ("steadyState", "CrankNicolson 0.9", "bounded Euler", "localEuler"):
            with self.subTest(scheme):
                folder = gas_box.write(os.path.join(self.root, scheme.split()[0]))
                self.edit(folder, "system/fvSchemes", "default Euler", f"default {scheme}")
                done = support.execute(folder)
                self.assertEqual(done.code, 1)
                self.assertRegex(done.text, f"time scheme {scheme.split()[0]} of (.|\n)*ddtSchemes(.|\n)*take Euler, or backward")
