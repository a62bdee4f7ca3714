#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/picture: spheres at their true size and place, in their velocity's colour, the front ones on top."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import matplotlib
import numpy as np
from matplotlib import pyplot as plt

from interphase.commands import picture as tool

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PICTURE = os.path.join(REPOSITORY, "tools/picture")


class Bench(unittest.TestCase):
    def setUp(self):
        self.run_folder = tempfile.mkdtemp(prefix="interphase-picture-")
        self.addCleanup(shutil.rmtree, self.run_folder)
        self.picture_file = os.path.join(self.run_folder, "bed.png")

    def particles(self, snapshots):
        """snapshots: (time, position [n, 3], vertical velocity [n], diameter [n])"""
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "w") as file:
            for number, (time, position, vertical, diameter) in enumerate(snapshots):
                group = file.create_group(f"snapshots/{number:06d}")
                group.attrs["time"] = time
                group["position"] = np.asarray(position, dtype=float).reshape(-1, 3)
                group["velocity"] = np.column_stack([np.zeros(len(vertical)), np.zeros(len(vertical)), vertical])
                group["diameter"] = np.asarray(diameter, dtype=float)

    def results(self, domain=None, series=False, **meta):
        with h5py.File(os.path.join(self.run_folder, "results.h5"), "w") as file:
            file.create_group("meta").attrs.update(meta)
            if domain is not None:
                file["meta"].attrs["domain"] = domain
            if series:
                file["series/time"] = np.linspace(0, 1, 100)
                file["series/pressure_drop"] = np.full(100, 1000.0)

    def picture(self, *given, code=0):
        done = subprocess.run([PICTURE, self.run_folder, *given], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done


class Torn(Bench):
    """What a full disk or a copy that was cut leaves: the rest is drawn, with a word."""

    SCENE = [(t, [[0.1, 0.1, 0.1]], [t], [0.05]) for t in (0.0, 0.1, 0.2)]

    def test_a_snapshot_without_its_file(self):
        self.particles(self.SCENE)
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "a") as file:
            file["snapshots/000003"] = h5py.ExternalLink("snapshots/000003.h5", "/")
        self.assertRegex(self.picture().stderr, "snapshot 000003 is torn .* left out")

    def test_a_snapshot_whose_file_was_cut(self):
        self.particles(self.SCENE)
        os.mkdir(os.path.join(self.run_folder, "snapshots"))
        path = os.path.join(self.run_folder, "snapshots/000003.h5")
        with h5py.File(path, "w") as file:
            file.attrs["time"] = 0.3
            file["position"] = np.zeros((1000, 3))
        os.truncate(path, os.path.getsize(path) - 1000)
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "a") as file:
            file["snapshots/000003"] = h5py.ExternalLink("snapshots/000003.h5", "/")
        self.assertRegex(self.picture("--time", "0.3").stderr, "snapshot 000003 is torn .* left out")

    def test_a_last_snapshot_of_which_a_part_is_there(self):
        self.particles(self.SCENE)
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "a") as file:
            group = file.create_group("snapshots/000003")
            group["position"] = np.zeros((1, 3))
        self.assertRegex(self.picture("--series").stderr, "snapshot 000003 is torn .* left out")
        self.assertEqual(len(os.listdir(os.path.join(self.run_folder, "frames"))), 3)

    def test_rows_of_which_a_column_is_shorter(self):
        self.particles(self.SCENE)
        self.results(series=True)
        with h5py.File(os.path.join(self.run_folder, "results.h5"), "a") as file:
            del file["series/pressure_drop"]
            file["series/pressure_drop"] = np.full(97, 1000.0)
        self.assertRegex(self.picture().stderr, "/series has 97 whole rows; of its last 3 columns are missing")


class Files(Bench):
    SCENE = [(t, [[0.1, 0.1, 0.1]], [t], [0.05]) for t in (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)]

    def test_the_strip_is_the_default_and_goes_into_the_run(self):
        self.particles(self.SCENE)
        self.results(domain=[[0, 0, 0], [0.2, 0.2, 1]], case=b"bed", method="DEM", weight=1.0)
        self.assertEqual(self.picture().stdout.strip(), self.picture_file)
        strip = plt.imread(self.picture_file).shape
        self.picture("--time", "0.31", "-o", self.picture_file)
        single = plt.imread(self.picture_file).shape
        self.assertGreater(strip[1], 1.5 * single[1])

    def test_weights_are_told(self):
        told = tool.weights
        self.assertEqual(told({"weight": 8.0}), "8")
        self.assertEqual(told({"weight": 8.0, "lowest_weight": 8.0, "highest_weight": 8.0}), "8")
        self.assertEqual(told({"weight": 3.7, "lowest_weight": 1.0, "highest_weight": 27.0}), "1 to 27")

    def test_pressure_drop_adds_a_panel_below(self):
        self.particles(self.SCENE)
        self.picture()
        without = plt.imread(self.picture_file).shape
        self.results(series=True, bed_weight_per_area=1093.6)
        self.picture()
        self.assertGreater(plt.imread(self.picture_file).shape[0], without[0] + 200)

    def test_a_series_numbers_every_snapshot(self):
        self.particles(self.SCENE)
        folder = os.path.join(self.run_folder, "film")
        self.picture("--series", "-o", folder)
        self.assertEqual(sorted(os.listdir(folder)), [f"bed-{n:06d}.png" for n in range(6)])
        self.assertEqual(len({plt.imread(os.path.join(folder, f)).shape for f in os.listdir(folder)}), 1)

    def test_without_results_the_particles_are_enough(self):
        self.particles(self.SCENE[:1])
        self.picture()

    def test_nothing_to_draw_is_told(self):
        self.assertIn("no particles.h5", self.picture(code=1).stderr)
        self.particles([])
        self.assertIn("no snapshots", self.picture(code=1).stderr)
        self.particles([(0.0, np.zeros((0, 3)), [], [])])
        self.assertIn("no particles", self.picture(code=1).stderr)


class Drawing(Bench):
    """The pixels of one panel whose data limits are known."""

    def drawn(self, position, vertical, diameter, scale=1.0):
        snapshot = tool.Snapshot(0.0, np.array(position, dtype=float), np.array(diameter, dtype=float), np.array(vertical, dtype=float))
        figure = plt.figure(figsize=(4, 4), dpi=200)
        self.addCleanup(plt.close, figure)
        axes = figure.add_axes((0, 0, 1, 1))
        mapper = plt.cm.ScalarMappable(matplotlib.colors.Normalize(-scale, scale), tool.COLOURS)
        tool.draw_bed(axes, snapshot, mapper, (0, 1, 0, 1), True, (0.0, 1.0), 72 * 4)
        axes.set_axis_off()
        figure.canvas.draw()
        # Row 0 is the top: turn it so that [i, j] is x, z.
        return np.asarray(figure.canvas.buffer_rgba())[::-1, :, :3].transpose(1, 0, 2).astype(float) / 255, mapper

    def test_true_size_and_place(self):
        image, _ = self.drawn([[0.3, 0.5, 0.7], [0.8, 0.5, 0.2]], [1.0, -1.0], [0.2, 0.1])
        inked = image.min(axis=2) < 0.98
        self.assertAlmostEqual(inked.mean(), np.pi / 4 * (0.2**2 + 0.1**2), delta=0.001)
        x, z = (np.argwhere(inked[:400]).mean(axis=0) + 0.5) / 800
        self.assertAlmostEqual(x, 0.3, delta=0.002)
        self.assertAlmostEqual(z, 0.7, delta=0.002)

    def test_the_front_one_is_on_top_whatever_the_order(self):
        for front_first in (True, False):
            places, speeds = [[0.5, 0.0, 0.5], [0.5, 0.9, 0.5]], [0.8, -0.8]
            order = slice(None, None, 1 if front_first else -1)
            image, mapper = self.drawn(places[order], speeds[order], [0.2, 0.2])
            np.testing.assert_allclose(image[400, 400], mapper.to_rgba(0.8)[:3], atol=0.01)

    def test_colours_are_symmetric_about_rest(self):
        image, mapper = self.drawn([[0.2, 0, 0.5], [0.5, 0, 0.5], [0.8, 0, 0.5]], [-1, 0, 1], [0.1] * 3)
        down, rest, up = image[160, 400], image[400, 400], image[640, 400]
        self.assertGreater(down[2], down[0] + 0.3, "downwards is blue")
        self.assertGreater(up[0], up[2] + 0.3, "upwards is red")
        self.assertLess(np.ptp(rest), 0.02, "rest is grey")


class Choices(unittest.TestCase):
    def snapshot(self, vertical, position=None):
        count = len(vertical)
        position = np.full((count, 3), 0.1) if position is None else np.asarray(position, dtype=float)
        return tool.Snapshot(0.0, position, np.full(count, 0.02), np.asarray(vertical, dtype=float))

    def test_evenly_spaced_times_end_with_the_last(self):
        times = [0.05 * n for n in range(21)]
        self.assertEqual(tool.evenly_spaced(times, 4), [5, 10, 15, 20])
        self.assertEqual(tool.evenly_spaced([0.0, 0.1], 4), [0, 1])
        self.assertEqual(tool.evenly_spaced([0.0, 0.01, 0.02, 0.03, 0.04, 1.0], 4)[-1], 5)

    def test_the_scale_is_round_and_ignores_few_outliers(self):
        speeds = np.concatenate([np.linspace(-1.7, 0.5, 1000), [50.0]])
        self.assertEqual(tool.velocity_scale([self.snapshot(speeds)]), 2.0)
        self.assertEqual(tool.velocity_scale([self.snapshot([0.0, 0.0])]), 1.0)

    def test_the_view_holds_every_sphere_and_crops_the_empty_top_only(self):
        domain = np.array([[0, 0, 0], [0.2, 0.2, 2.0]])
        low, high = self.snapshot([0.0]), self.snapshot([0.0], [[0.1, 0.1, 1.9]])
        (left, right, bottom, top), closed, _ = tool.view([low], domain)
        self.assertEqual((left, right, bottom), (0, 0.2, 0))
        self.assertTrue(0.11 < top < 0.5 and not closed)
        box, closed, _ = tool.view([low, high], domain)
        self.assertEqual((box[3], closed), (2.0, True))
        outside, _, _ = tool.view([self.snapshot([0.0], [[-0.05, 0.1, 0.1]])], domain)
        self.assertAlmostEqual(outside[0], -0.06)


if __name__ == "__main__":
    sys.exit(unittest.main())
