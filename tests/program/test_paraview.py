# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView's own readers open what a run leaves: particles.xdmf and the gas, decomposed or not, with all times and
arrays; and the bed that it renders is a picture, not a blank.

ParaView runs in a process of its own (under Xvfb: Debian's build renders through X).
"""

import json
import os
import subprocess

import numpy
from scipy.spatial import cKDTree

import support
import vessel

READ_AND_RENDER = r"""
import json, sys
from paraview.simple import *
folder, picture, decomposed = sys.argv[1], sys.argv[2], sys.argv[3] == "decomposed"
particles = XDMFReader(FileNames=[folder + "/particles.xdmf"])
particles.UpdatePipeline()
last = particles.TimestepValues[-1]
particles.UpdatePipeline(last)
gas = OpenFOAMReader(FileName=folder + "/case.foam", CaseType="Decomposed Case" if decomposed else "Reconstructed Case")
gas.UpdatePipelineInformation()
gas.UpdatePipeline()
gas.UpdatePipeline(gas.TimestepValues[-1])

def names(data):
    return sorted(data.GetArray(i).Name for i in range(data.GetNumberOfArrays()))

found = {
    "particle times": list(particles.TimestepValues), "points": particles.GetDataInformation().GetNumberOfPoints(),
    "bounds": particles.GetDataInformation().GetBounds(), "arrays": names(particles.PointData),
    "gas times": list(gas.TimestepValues), "cells": gas.GetDataInformation().GetNumberOfCells(),
    "fields": names(gas.CellData)}

view = CreateView("RenderView")
view.ViewSize = [300, 600]
shown = Show(particles, view)
shown.SetRepresentationType("Point Gaussian")
shown.GaussianRadius = 0.003
ColorBy(shown, ("POINTS", "velocity", "Z"))
view.ViewTime = last
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.114, -1.2, 0.2], [0.114, 0.038, 0.2], [0, 0, 1]
Render(view)
SaveScreenshot(picture, view)

print("FOUND " + json.dumps(found))
"""


READ_TIMES = r"""
import json, sys
from paraview.simple import *
particles = XDMFReader(FileNames=[sys.argv[1] + "/particles.xdmf"])
particles.UpdatePipeline()
seen = {}
for time in particles.TimestepValues:
    particles.UpdatePipeline(time)
    seen[time] = particles.GetDataInformation().GetNumberOfPoints()
arrays = sorted(particles.PointData.GetArray(i).Name for i in range(particles.PointData.GetNumberOfArrays()))
print("FOUND " + json.dumps([seen, arrays]))
"""


ARRAYS = ["angular_velocity", "density", "diameter", "force", "id", "type", "velocity"]


class OpenedInParaView(support.ProgramTest):
    def opened(self, ranks):
        folder = self.prepared(
            "sscp1", ranks=ranks, until=0.02,
            **{"system/controlDict:writeInterval": 0.01, "system/couplingDict:records/snapshotInterval": 0.01},
        )  # fmt: skip
        done = self.run_case(folder, ranks)
        support.write(done.path("case.foam"), "")
        picture = done.path("paraview.png")
        viewer = subprocess.run(
            # a display of its own: looking for a free one (-a) was seen to take one that was just closing;
            # -noreset: ParaView connects, leaves and connects again, and a server that starts afresh between the two
            # refuses the second (17 of 50 viewers failed without it, none of 50 with it)
            ["xvfb-run", "--server-num", str(100 + os.getpid() % 10000 + ranks),
             "-s", "-screen 0 640x800x24 -noreset", "/usr/bin/python3", "-c", READ_AND_RENDER, folder, picture,
             "decomposed" if ranks > 1 else "whole"],
            env=support.environment(LIBGL_ALWAYS_SOFTWARE="1"), capture_output=True, text=True, timeout=300,
        )
        line = [line for line in viewer.stdout.splitlines() if line.startswith("FOUND ")]
        self.assertTrue(line, f"ParaView did not get through:\n{(viewer.stdout + viewer.stderr)[-3000:]}")
        return done, json.loads(line[0][6:]), picture

    def check(self, ranks):
        done, found, picture = self.opened(ranks)
        last = done.last()
        self.assertEqual(len(found["particle times"]), 3)  # start, two write times
        for seen, written in zip(found["particle times"], sorted(done.snapshots())):
            self.assertAlmostEqual(seen, written, delta=1e-11)  # the XDMF has twelve digits
        self.assertEqual(found["points"], len(last["id"]))
        self.assertEqual(found["arrays"], ARRAYS)
        for axis in range(3):
            # ParaView keeps the coordinates in single precision: 1e-7 of a metre-sized bed
            self.assertAlmostEqual(found["bounds"][2 * axis], last["position"][:, axis].min(), delta=1e-6)
            self.assertAlmostEqual(found["bounds"][2 * axis + 1], last["position"][:, axis].max(), delta=1e-6)
        self.assertEqual(found["cells"], 16 * 4 * 85)
        self.assertAlmostEqual(max(found["gas times"]), 0.02)
        self.assertLessEqual({"U", "p", "p_rgh", "voidage"}, set(found["fields"]))

        import matplotlib.image

        pixels = matplotlib.image.imread(picture)[..., :3]
        background = pixels[0, 0]
        drawn = (abs(pixels - background).max(axis=-1) > 0.05).mean()
        # the bed is 0.23 m x 0.23 m of a view some 0.32 m x 0.64 m: a quarter of the picture
        self.assertGreater(drawn, 0.1)
        self.assertLess(drawn, 0.6)
        self.assertGreater(len({tuple(p) for p in (pixels[::7, ::7].reshape(-1, 3) * 255).astype(int)}), 20)  # colours
        self.by_script(done, ranks)

    def by_script(self, done, ranks):
        """tools/paraview: the script opens the run by itself, spheres at true size, the voidage beside them."""
        picture, script = done.path("by-script.png"), done.path("show-in-paraview.py")
        words = [os.path.join(support.TOOLS, "paraview"), done.folder, "--screenshot", picture]
        shown = subprocess.run(words, env=support.environment(DISPLAY=""), capture_output=True, text=True, timeout=300)
        self.assertEqual(shown.returncode, 0, shown.stdout + shown.stderr)
        self.assertEqual(shown.stdout.split(), [script, picture])
        self.assertIn(f"'decomposed': {ranks > 1}", support.read(script))

        import matplotlib.image

        pixels = matplotlib.image.imread(picture)[:820, :940, :3]  # without title, time and colour bars
        ink = pixels.min(axis=-1) < 0.97
        columns = numpy.flatnonzero(ink.mean(axis=0) > 0.1)
        (gap,) = numpy.flatnonzero(numpy.diff(columns) > 10)  # between the particles and the gas
        left, right = columns[[0, gap]]
        bed = numpy.flatnonzero(ink[:, left + 5:right - 5].mean(axis=1) > 0.5)
        # 95,000 real spheres of 3.256 mm at a packing of 0.4 in 0.2286 m x 0.0762 m: 0.2465 m high; a sphere's diameter (6.5 mm) of room
        width, height = right - left, bed[-1] - bed[0]
        self.assertAlmostEqual(height / width * 0.2286, 0.2465, delta=0.01)
        # the white between them is what spheres of their true size leave: a place is covered where the nearest centre is within a radius
        last = done.last()
        x, z = numpy.meshgrid(numpy.linspace(0.01, 0.21, 300), numpy.linspace(0.02, 0.22, 300))
        distance, nearest = cKDTree(last["position"][:, (0, 2)]).query(numpy.column_stack([x.ravel(), z.ravel()]))
        pixel = 0.2286 / width
        covered = [(distance < share * last["diameter"][nearest] / 2 + 0.3 * pixel).mean() for share in (0.9, 1.0, 1.1)]  # a fifth of a pixel counts
        part = ink[int(bed[-1] - 0.22 / pixel):int(bed[-1] - 0.02 / pixel), int(left + 0.01 / pixel):int(left + 0.21 / pixel)]
        self.assertTrue(covered[0] < part.mean() < covered[2], f"{part.mean()} of the picture; {covered} where spheres are 10 % smaller, true, larger")
        gas = pixels[bed[0] + 8:bed[-1] - 8, columns[gap + 1] + 5:columns[-1] - 5].reshape(-1, 3).mean(axis=0)
        self.assertLess(gas.max(), 0.6, "the bed's voidage is dark")
        free = pixels[bed[0] - 40, columns[gap + 1] + 5:columns[-1] - 5].mean(axis=0)
        self.assertGreater(free[0], 0.8, "and that above it bright")

    def test_a_vessel_that_starts_empty(self):
        kinds = (
            f"fix one all particletemplate/sphere 15485863 atom_type 1 density constant 1131 radius constant {vessel.DIAMETER / 2}\n"
            "fix kinds all particledistribution/discrete 32452843 1 one 1.0\nregion fill block 0.005 0.02 0.005 0.02 0.02 0.05 units box\n"
            "fix pour all insert/pack seed 49979687 distributiontemplate kinds insert_every once overlapcheck yes all_in yes "
            "vel constant 0 0 0 region fill particles_in_region 50\n"
        )
        done = self.run_case(vessel.prepared(self, vessel.case(self.root, fixes=kinds), "TDHS", until=0.002))
        viewer = subprocess.run(
            ["xvfb-run", "--server-num", str(100 + os.getpid() % 10000 + 7), "-s", "-screen 0 640x800x24 -noreset",
             "/usr/bin/python3", "-c", READ_TIMES, done.folder],
            env=support.environment(LIBGL_ALWAYS_SOFTWARE="1"), capture_output=True, text=True, timeout=300,
        )
        self.assertNotIn("Error", viewer.stdout + viewer.stderr)
        self.assertNotIn("ERR|", viewer.stdout + viewer.stderr)
        line = [line for line in viewer.stdout.splitlines() if line.startswith("FOUND ")]
        self.assertTrue(line, viewer.stdout + viewer.stderr)
        seen, arrays = json.loads(line[0][6:])
        self.assertEqual(list(seen.values()), [0, 50])
        self.assertEqual(arrays, ARRAYS)

    def test_one_rank(self):
        self.check(1)

    def test_two_ranks_decomposed(self):
        self.check(2)
