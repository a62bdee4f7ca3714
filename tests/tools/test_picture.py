# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/picture: spheres at their true size and place, in their velocity's colour, the front ones on top; walls where they are, the gas
beside them, one range of colours, words that do not touch; and what tells more of few particles, packings and runs without gas."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace

import h5py
import matplotlib
import numpy as np
from matplotlib import pyplot as plt

from block_of_cells import write_field, write_mesh
from interphase import picture_curves, picture_labels, picture_law, picture_panels, picture_quantities, picture_scene
from interphase.commands import picture as tool
from interphase.stl import write_stl

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PICTURE = os.path.join(REPOSITORY, "tools/picture")


def scene(*times):
    """Snapshots of more particles than have their paths drawn."""
    return [(t, [[0.1, 0.1, 0.1]] * 30, [t] * 30, [0.05] * 30) for t in times]


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
                group["id"] = np.arange(1, len(vertical) + 1)
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

    SCENE = scene(0.0, 0.1, 0.2)

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
        self.assertRegex(self.picture().stderr, "snapshot 000003 is torn .* left out")

    def test_rows_of_which_a_column_is_shorter(self):
        self.particles(self.SCENE)
        self.results(series=True)
        with h5py.File(os.path.join(self.run_folder, "results.h5"), "a") as file:
            del file["series/pressure_drop"]
            file["series/pressure_drop"] = np.full(97, 1000.0)
        self.assertRegex(self.picture().stderr, "/series has 97 whole rows; of its last 3 columns are missing")


class Files(Bench):
    SCENE = scene(0.0, 0.1, 0.2, 0.3, 0.4, 0.5)

    def test_the_strip_is_the_default_and_goes_into_the_run(self):
        self.particles(self.SCENE)
        self.results(domain=[[0, 0, 0], [0.2, 0.2, 1]], case=b"bed", method="DEM", weight=1.0)
        self.assertEqual(self.picture().stdout.splitlines()[0], self.picture_file)
        strip = plt.imread(self.picture_file).shape
        self.picture("--time", "0.31", "-o", self.picture_file)
        single = plt.imread(self.picture_file).shape
        self.assertGreater(strip[1], 1.5 * single[1])

    def test_weights_are_told(self):
        told = picture_scene.weights
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
        shown = picture_scene.Shown(0.0, np.array(position, dtype=float), np.array(diameter, dtype=float), np.array(vertical, dtype=float))
        figure = plt.figure(figsize=(4, 4), dpi=200)
        self.addCleanup(plt.close, figure)
        axes = figure.add_axes((0, 0, 1, 1))
        mapper = plt.cm.ScalarMappable(matplotlib.colors.Normalize(-scale, scale), "coolwarm")
        picture_panels.draw_bed(axes, shown, mapper, (0.0, 1.0), 72 * 4)
        picture_panels.frame(axes, (0, 1, 0, 1), True, True)
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
    VELOCITY = picture_quantities.PARTICLES["vertical_velocity"]

    def shown(self, vertical, position=None):
        count = len(vertical)
        position = np.full((count, 3), 0.1) if position is None else np.asarray(position, dtype=float)
        return picture_scene.Shown(0.0, position, np.full(count, 0.02), np.asarray(vertical, dtype=float))

    def view(self, shown, domain=((0, 0, 0), (0.2, 0.2, 2.0))):
        nothing = np.full(3, np.nan)
        scene = SimpleNamespace(domain=np.array(domain, dtype=float), walls=SimpleNamespace(bounds=lambda: (nothing, nothing)))
        return picture_scene.view([scene], shown)

    def test_evenly_spaced_times_end_with_the_last(self):
        times = [0.05 * n for n in range(21)]
        self.assertEqual(picture_scene.evenly_spaced(times, 4), [5, 10, 15, 20])
        self.assertEqual(picture_scene.evenly_spaced([0.0, 0.1], 4), [0, 1])
        self.assertEqual(picture_scene.evenly_spaced([0.0, 0.01, 0.02, 0.03, 0.04, 1.0], 4)[-1], 5)

    def test_the_range_is_round_and_ignores_few_outliers(self):
        speeds = np.concatenate([np.linspace(-1.7, 0.5, 1000), [50.0]])
        self.assertEqual(picture_quantities.range_of(self.VELOCITY, [speeds]), (-2.0, 2.0))
        self.assertEqual(picture_quantities.range_of(self.VELOCITY, [np.zeros(2)]), (-1.0, 1.0))
        self.assertEqual(picture_quantities.range_of(picture_quantities.PARTICLES["speed"], [[0.03]]), (0.0, 0.05))

    def test_the_view_holds_every_sphere_and_crops_the_empty_top_only(self):
        low, high = self.shown([0.0]), self.shown([0.0], [[0.1, 0.1, 1.9]])
        (left, right, bottom, top), closed = self.view([low])
        self.assertEqual((left, right, bottom), (0, 0.2, 0))
        self.assertTrue(0.11 < top < 0.5 and not closed)
        box, closed = self.view([low, high])
        self.assertEqual((box[3], closed), (2.0, True))
        outside, _ = self.view([self.shown([0.0], [[-0.05, 0.1, 0.1]])])
        self.assertAlmostEqual(outside[0], -0.06)


class Looks(Bench):
    """Whole pictures: of a vessel 0.2 x 0.2 x 0.4 m with a tube across."""

    TIMES = (0.0, 0.1, 0.2, 0.3, 0.4)

    def given(self, *words):
        sys.argv = ["picture", self.run_folder, *words]
        return tool.arguments()

    def drawn(self, *words):
        """(figure, words on ranges)"""
        given = self.given(*words)
        figure, told = tool.picture_of(given, [picture_scene.Scene(path) for path in given.runs])
        self.addCleanup(plt.close, figure)
        return figure, told

    def vessel(self, size=(0.2, 0.2, 0.4), count=30, times=TIMES, speed=1.0):
        """Particles that rest in the vessel's lower half, or rise."""
        random = np.random.default_rng(1)
        place = random.uniform(0.1, 0.9, (count, 3)) * size * np.array((1, 1, 0.5))
        self.particles([(t, place, speed * np.linspace(-1, 1, count), np.full(count, 0.05 * min(size))) for t in times])
        self.results(domain=[(0, 0, 0), size], series=True, case="vessel", method="DEM", weight=1.0, drag_law="BVK", gas_step=1e-3,
                     real_particles=float(count), particles=float(count))  # fmt: skip

    def gas(self, time="0.2"):
        """A mesh with a tube of 0.05 m across the middle, at z = 0.1 m; the voidage rises with x."""
        centres = write_mesh(self.run_folder, (0.2, 0.2, 0.4), (8, 2, 16),
                             left_out=lambda c: abs(c[0] - 0.1) < 0.025 and abs(c[2] - 0.1) < 0.025)  # fmt: skip
        write_field(self.run_folder, time, "voidage", 0.4 + 3 * centres[:, 0])
        write_field(self.run_folder, time, "U", np.column_stack([0 * centres[:, 0], 0 * centres[:, 0], 1 + centres[:, 0]]))

    @staticmethod
    def panel(figure, title):
        (axes,) = [each for each in figure.axes if each.get_title() == title]
        return axes

    @staticmethod
    def colour_at(figure, axes, x, z):
        figure.canvas.draw()
        image = np.asarray(figure.canvas.buffer_rgba())
        column, row = axes.transData.transform((x, z))
        return image[image.shape[0] - 1 - int(row), int(column), :3].astype(float) / 255

    def test_walls_are_where_the_meshes_have_them(self):
        self.vessel(count=0)
        self.gas()
        os.mkdir(os.path.join(self.run_folder, "dem"))
        write_stl(os.path.join(self.run_folder, "dem/baffle.stl"), {"baffle": [[(0.15, 0, 0.2), (0.15, 0.2, 0.2), (0.15, 0.2, 0.3)],
                                                                               [(0.15, 0, 0.2), (0.15, 0.2, 0.3), (0.15, 0, 0.3)]]})  # fmt: skip
        with open(os.path.join(self.run_folder, "dem/log.liggghts"), "w", encoding="ascii") as file:
            file.write("fix b all mesh/surface file dem/baffle.stl type 2\nfix w all wall/gran mesh n_meshes 1 meshes b\n"
                       "fix p all wall/gran primitive type 2 xplane 0.05\n")  # fmt: skip
        figure, _ = self.drawn("--time", "0.2", "--gas", "none")
        axes = self.panel(figure, "t = 0.2 s")
        for x, z, what in ((0.075, 0.1, "tube"), (0.1, 0.125, "tube"), (0.15, 0.25, "baffle"), (0.05, 0.3, "plane"), (0.2, 0.3, "side")):
            self.assertLess(self.colour_at(figure, axes, x, z).max(), 0.6, what)
        for x, z, what in ((0.1, 0.1, "inside of the tube"), (0.15, 0.15, "below the baffle"), (0.12, 0.25, "free")):
            self.assertEqual(self.colour_at(figure, axes, x, z).min(), 1.0, what)
        floor = self.colour_at(figure, axes, 0.12, 0.0)
        self.assertGreater(floor[2], floor[0] + 0.2, "gas passes the floor: blue")

    def test_the_gas_beside_the_particles_is_its_field(self):
        self.vessel()
        self.gas()
        figure, told = self.drawn("--time", "0.2")
        axes = self.panel(figure, "voidage")
        mapper = plt.cm.ScalarMappable(matplotlib.colors.Normalize(0.4, 1.0), "YlGnBu_r")
        for x in (0.0375, 0.0875, 0.1625):  # cells' middles
            np.testing.assert_allclose(self.colour_at(figure, axes, x, 0.1875), mapper.to_rgba(0.4 + 3 * x)[:3], atol=0.01)
        self.assertEqual(self.colour_at(figure, axes, 0.0975, 0.1).min(), 1.0, "nothing is drawn inside of the tube")
        self.assertIn("--gas-range=0.4,1", told)
        _, told = self.drawn("--time", "0.2", "--gas", "velocity", "--gas-range", "0,3")
        self.assertIn("gas speed [m/s]: --gas-range=0,3", told)

    def test_a_gas_of_another_time_is_said_and_none_is_refused(self):
        self.vessel()
        self.gas(time="0.25")
        self.assertNotIn("voidage", [axes.get_title() for axes in self.drawn("--time", "0.3")[0].axes])
        self.panel(self.drawn("--time", "0.3", "--gas", "voidage")[0], "voidage, 0.25 s")
        shutil.rmtree(os.path.join(self.run_folder, "0.25"))
        self.assertIn("no voidage of the gas was written; writeInterval", self.picture("--gas", "voidage", code=1).stderr)

    def test_times_with_gas_are_preferred(self):
        self.vessel()
        for time in ("0.1", "0.3"):
            self.gas(time=time)
        titles = [axes.get_title() for axes in self.drawn()[0].axes]
        self.assertEqual([each for each in titles if each], ["t = 0.1 s", "voidage", "t = 0.3 s", "voidage"])

    def test_the_range_is_kept(self):
        self.vessel(speed=0.7)
        self.assertIn("--range=-1,1", self.drawn()[1])
        figure, told = self.drawn("--range=-0.2,0.3", "--time", "0.1")
        self.assertIn("--range=-0.2,0.3", told)
        (bar,) = [axes for axes in figure.axes if "velocity" in axes.get_ylabel()]
        self.assertEqual(bar.get_ylim(), (-0.2, 0.3))
        self.assertIn("LOW must be below HIGH", self.picture("--range", "1,1", code=2).stderr)
        self.assertIn("two numbers LOW,HIGH", self.picture("--range", "1", code=2).stderr)

    def test_two_runs_have_one_range_and_like_times(self):
        self.vessel(speed=0.7)
        other = tempfile.mkdtemp(prefix="interphase-picture-")
        self.addCleanup(shutil.rmtree, other)
        first, self.run_folder = self.run_folder, other
        self.vessel(speed=4.0, times=(0.0, 0.1, 0.2, 0.3, 0.4, 0.8))
        figure, told = self.drawn(first)
        self.assertIn("--range=-5,5", told)
        titles = [axes.get_title() for axes in figure.axes if axes.get_title()]
        self.assertEqual(titles, 2 * ["t = 0.1 s", "t = 0.2 s", "t = 0.3 s", "t = 0.4 s"])
        self.assertEqual({axes.get_ylim() for axes in figure.axes if "velocity" in axes.get_ylabel()}, {(-5.0, 5.0)})

    def test_colours_by_other_quantities(self):
        self.vessel()
        for name in ("speed", "diameter", "height-at-start"):
            self.drawn("--colour", name)
        self.assertIn("the snapshots of this run hold no weight; there are vertical_velocity, speed, diameter", self.picture("--colour", "weight", code=1).stderr)

    def test_no_words_touch_in_any_shape(self):
        shapes = {"narrow": (0.02, 0.02, 1.0), "flat": (2.0, 0.1, 0.05), "long numbers": (1.2345e-4, 1e-4, 3.2e-4), "far": (0.2, 0.2, 0.4)}
        for name, size in shapes.items():
            for words in ((), ("--time", "0.2")):
                self.vessel(size=size)
                with self.subTest(name, words=words):
                    figure, _ = self.drawn(*words)
                    self.check_words(figure)
        self.vessel()
        self.gas()
        self.check_words(self.drawn("--gas", "voidage")[0])

    def check_words(self, figure):
        figure.canvas.draw()
        boxes = [(text.get_text(), text.get_window_extent()) for text in figure.texts if text.get_text()]
        for axes in figure.axes:
            boxes += [("title " + axes.get_title(), axes.title.get_window_extent())] if axes.get_title() else []
            boxes += [("tick", box) for which in "xy" for _, box in picture_labels.tick_labels(axes, which)]
            boxes += [("label", label.get_window_extent()) for label in (axes.xaxis.label, axes.yaxis.label) if label.get_text()]
            boxes += [("legend", axes.get_legend().get_window_extent())] if axes.get_legend() else []
        boxes += [("legend", each.get_window_extent()) for each in figure.legends]
        for n, (name, box) in enumerate(boxes):
            self.assertTrue(0 <= box.x0 and box.x1 <= figure.bbox.x1 and 0 <= box.y0 and box.y1 <= figure.bbox.y1, f"{name} leaves the picture")
            for other, beside in boxes[:n]:
                self.assertFalse(box.x0 < beside.x1 and beside.x0 < box.x1 and box.y0 < beside.y1 and beside.y0 < box.y1,
                                 f"{name} and {other} overlap")  # fmt: skip

    def test_the_title_tells_case_and_operating_point(self):
        self.vessel()
        with open(os.path.join(self.run_folder, "parameters"), "w", encoding="ascii") as file:
            file.write("inletVelocity 2.19;\ndiameter 1e-3;\n")
        words = [text.get_text() for text in self.drawn()[0].texts]
        self.assertIn("vessel  ·  DEM  ·  W = 1", words)
        self.assertIn("30 particles  ·  inlet velocity 2.19 m/s  ·  drag BVK  ·  gas step 1 ms", words)


class Others(Bench):
    """Runs of which a strip of the bed tells little."""

    def parameters(self, **values):
        with open(os.path.join(self.run_folder, "parameters"), "w", encoding="ascii") as file:
            file.writelines(f"{name} {value};\n" for name, value in values.items())

    def fall(self, law="SchillerNaumann"):
        times = np.linspace(0, 0.5, 6)
        self.particles([(t, [[0.1, 0.1, 3.0 - t]], [-t], [2e-4]) for t in times])
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "a") as file:
            for group in file["snapshots"].values():
                group["density"] = [2500.0]
        self.results(domain=[[0, 0, 0], [0.2, 0.2, 4]], case="settling", drag_law=law, weight=1.0)
        self.parameters(gasDensity=1.204, gasViscosity=1.825e-5, gravity=9.81)
        for folder, name, text in (("system", "couplingDict", "gas { model frozen; }\nforces ();\n"),
                                   ("0", "U", "FoamFile { version 2.0; }\ninternalField uniform (0 0 0);\n")):  # fmt: skip
            os.makedirs(os.path.join(self.run_folder, folder), exist_ok=True)
            with open(os.path.join(self.run_folder, folder, name), "w", encoding="ascii") as file:
                file.write(text)
        return picture_scene.Scene(self.run_folder)

    def test_a_sphere_that_falls_is_drawn_beside_its_law(self):
        scene = self.fall()
        self.assertTrue(scene.few)
        law, terminal, on_the_way = picture_law.fall(scene, 0)
        self.assertAlmostEqual(terminal, -1.410, delta=0.001)  # cases/settling/README.md, whose scene this is
        self.assertAlmostEqual(on_the_way[1] / (-9.81 * (1 - 1.204 / 2500) * 0.1), 1, delta=0.25)  # little drag at first
        self.assertLess(on_the_way[1], 0)
        self.assertAlmostEqual(on_the_way[-1], terminal, delta=0.03)
        self.picture()
        with self.subTest("a law that is not known here is left out"):
            self.assertIsNone(picture_law.fall(self.fall(law="KochHill"), 0))
            self.picture()

    def test_a_packing_that_is_held_has_its_pressure_over_the_height(self):
        self.particles([(t, np.random.default_rng(1).uniform(0, 0.1, (40, 3)), np.zeros(40), np.full(40, 0.01)) for t in (0.0, 0.1, 0.2)])
        self.results(domain=[[0, 0, 0], [0.1, 0.1, 0.2]], series=True, case="packing", drag_law="Ergun")
        centres = write_mesh(self.run_folder, (0.1, 0.1, 0.2), (2, 2, 20))
        write_field(self.run_folder, "0.2", "voidage", np.full(len(centres), 0.4))
        # Ergun's own equation at U = 1 m/s, for spheres of 1 cm in air
        slope = 150 * 0.6**2 * 1.8e-5 / (0.4**3 * 0.01**2) + 1.75 * 0.6 * 1.2 / (0.4**3 * 0.01)
        write_field(self.run_folder, "0.2", "p_rgh", 1e5 - slope * centres[:, 2])
        write_field(self.run_folder, "0.2", "U", np.tile((0, 0, 1 / 0.4), (len(centres), 1)))
        self.parameters(gasDensity=1.2, gasViscosity=1.8e-5, diameter=0.01)
        scene = picture_scene.Scene(self.run_folder)
        self.assertTrue(scene.held)
        _, pressure, law = picture_law.profile(scene, *(scene.gas.nearest(field, 0.2) for field in ("voidage", "p_rgh", "U")))
        np.testing.assert_allclose(law, pressure, atol=1e-6 * slope)
        self.picture()

    def test_without_gas_the_energy_and_the_number_are_drawn(self):
        self.particles([(t, [[0.1, 0.1, 0.1]] * 30, [t] * 30, [0.05] * 30) for t in (0.0, 0.1)])
        with h5py.File(os.path.join(self.run_folder, "results.h5"), "w") as file:
            file["series/time"], file["series/kinetic_energy"], file["series/particles"] = (np.linspace(0, 1, 9) for _ in range(3))
        curves = picture_curves.curves_of([picture_scene.Scene(self.run_folder)])
        self.assertEqual([curve.series for curve in curves], ["particles", "kinetic_energy"])
        self.picture()

    def test_the_legend_is_above_the_curves(self):
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        axes.plot([0, 1], [0, 1], label="one")
        axes.plot([0, 1], [1, 0], label="two")
        picture_curves.finish(axes, "pressure drop [kPa]")
        figure.canvas.draw()
        self.assertGreaterEqual(axes.get_legend().get_window_extent().y0, axes.get_window_extent().y1 - 1)


if __name__ == "__main__":
    sys.exit(unittest.main())
