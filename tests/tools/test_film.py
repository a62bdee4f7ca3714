# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/film: a frame of every whole snapshot, of one size and scale, over the time that is asked for; and what is refused."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import matplotlib.image
import numpy as np

from interphase import film
from interphase.input_error import InputError

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
FILM = os.path.join(REPOSITORY, "tools/film")


class Films(unittest.TestCase):
    def setUp(self):
        self.run_folder = tempfile.mkdtemp(prefix="interphase-film-")
        self.addCleanup(shutil.rmtree, self.run_folder)

    def particles(self, count):
        """`count` snapshots 0.05 s apart, of spheres that rise."""
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "w") as file:
            for number in range(count):
                group = file.create_group(f"snapshots/{number:06d}")
                group.attrs["time"] = 0.05 * number
                group["id"] = np.arange(1, 31)
                group["position"] = np.random.default_rng(1).uniform(0, 0.1, (30, 3)) + (0, 0, 0.01 * number)
                group["velocity"] = np.tile((0, 0, 0.2), (30, 1))
                group["diameter"] = np.full(30, 0.01)

    def film(self, *given, code=0, **environment):
        done = subprocess.run([FILM, self.run_folder, *given], capture_output=True, text=True, timeout=300, env={**os.environ, **environment})
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    @staticmethod
    def probe(path, *entries):
        """What ffprobe tells of its picture."""
        words = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", f"stream={','.join(entries)}", "-of", "csv=p=0", path],
                               capture_output=True, text=True, check=True).stdout.strip()  # fmt: skip
        return words.split(",")

    def test_a_film_that_browsers_play(self):
        self.particles(5)
        said = self.film("--speed", "0.1", "--height", "201").stdout
        path = os.path.join(self.run_folder, "bed.mp4")
        self.assertIn(f"{path}: 5 frames, 2.5 s, 2 frames a second", said)
        codec, width, height, kind, rate, duration, count = self.probe(
            path, "codec_name", "width", "height", "pix_fmt", "r_frame_rate", "duration", "nb_read_frames")  # fmt: skip
        self.assertEqual((codec, kind, rate, count), ("h264", "yuv420p", "2/1", "5"))
        self.assertAlmostEqual(float(duration), 2.5)
        self.assertEqual((int(width) % 2, int(height)), (0, 202))
        self.assertEqual(sorted(os.listdir(self.run_folder)), ["bed.mp4", "particles.h5"], "nothing else is left")

    def test_every_frame_has_its_own_spheres(self):
        self.particles(4)
        path = os.path.join(self.run_folder, "bed.gif")
        self.film("--fps", "5", "--height", "200", "-o", path)
        subprocess.run(["ffmpeg", "-v", "error", "-i", path, os.path.join(self.run_folder, "f%d.png")], check=True)
        frames = [matplotlib.image.imread(os.path.join(self.run_folder, f"f{n}.png"))[..., :3] for n in (1, 2, 3, 4)]
        frames = [frame[:, :frame.shape[1] * 7 // 10] for frame in frames]  # without the colour bar
        rows = [np.argwhere((frame.max(axis=2) - frame.min(axis=2)) > 0.15)[:, 0].mean() for frame in frames]  # coloured: spheres
        self.assertTrue(all(later < earlier - 1 for earlier, later in zip(rows, rows[1:])), f"the spheres rise: rows {rows}")

    def test_a_film_for_pages(self):
        from PIL import Image

        self.particles(4)
        path = os.path.join(self.run_folder, "bed.webp")
        self.film("--fps", "10", "--height", "150", "-o", path)
        with Image.open(path) as image:
            self.assertEqual((image.n_frames, image.info["loop"]), (4, 0))

    def test_a_part_of_a_run_that_still_goes(self):
        self.particles(5)
        with h5py.File(os.path.join(self.run_folder, "particles.h5"), "a") as file:
            group = file.create_group("snapshots/000005")
            group.attrs["time"] = 0.25
            group["id"], group["position"] = np.arange(3), np.zeros((2, 3))
        done = self.film("--height", "150", "--from", "0.1")
        self.assertRegex(done.stderr, "snapshot 000005 is torn .* left out")
        self.assertIn("3 frames", done.stdout)

    def test_what_cannot_be_filmed(self):
        self.particles(2)
        self.assertRegex(self.film("-o", "bed.avi", code=1).stderr, r"bed.avi: a film ends in .mp4, .webp, .gif")
        self.assertRegex(self.film("--from", "7", code=1).stderr, "no snapshots from 7 to inf s; there are those of 0 to 0.05 s")
        self.assertRegex(self.film("-o", "/nowhere/bed.mp4", code=1).stderr, "/nowhere/bed.mp4: ffmpeg failed")
        self.assertRegex(self.film("--fps", "0", code=2).stderr, "a number above 0")

    def test_without_ffmpeg_the_remedy_is_said(self):
        self.particles(2)
        empty = tempfile.mkdtemp(prefix="interphase-film-")
        self.addCleanup(shutil.rmtree, empty)
        for name in ("bash", "dirname", "readlink"):
            os.symlink(shutil.which(name), os.path.join(empty, name))
        self.assertRegex(self.film(code=1, PATH=empty).stderr, "ffmpeg is missing, .*tools/setup --no-build --with ffmpeg")

    def test_frames_of_different_sizes_are_refused(self):
        images = (np.zeros((4, size, 3), dtype=np.uint8) for size in (4, 6))
        with self.assertRaisesRegex(InputError, "a frame of 6 x 4 pixels among those of 4 x 4"):
            film.write(os.path.join(self.run_folder, "x.mp4"), images, 10)
        self.assertEqual(os.listdir(self.run_folder), [])


if __name__ == "__main__":
    sys.exit(unittest.main())
