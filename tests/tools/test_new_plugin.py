# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
# timeout: 900
"""tools/new-plugin: what it refuses, and the whole path of what it writes: configured against the build folder and against an
installation, built, its own test passed, its script run, its bed run by tools/run, installed and found by name.
"""

import os
import shutil
import subprocess

from interphase.run import Run
from interphase.tree import REPOSITORY, TOOLS
from scratch import InFolder

BUILD = os.environ.get("INTERPHASE_BUILD") or os.path.join(REPOSITORY, "build", "release")
TOOL = os.path.join(TOOLS, "new-plugin")


class Bench(InFolder):
    def run_program(self, *command, cwd=None, **changes):
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", **changes}
        return subprocess.run(
            command, cwd=cwd or self.root, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
            errors="replace", timeout=600,
        )  # fmt: skip

    def succeed(self, *command, **how):
        done = self.run_program(*command, **how)
        self.assertEqual(done.returncode, 0, f"{' '.join(command)}:\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
        return done


class Refusals(Bench):
    def refused(self, *arguments, **how):
        done = self.run_program(TOOL, *arguments, **how)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr

    def test_names(self):
        for name in ("Bouncy", "2fast", "a-b", "a b", "wall/x", "", "ümlaut"):
            with self.subTest(name):
                self.assertIn(f"the name '{name}' will not do: give lower-case letters", self.refused(name, "folder"))
        self.assertIn("my_install", self.refused("install", "folder"))
        self.assertIn("would be TDHS, which there is already", self.refused("tdhs", "folder"))
        self.assertIn("has a plug-in of that name", self.refused("mp_pic", "folder", "--stress"))
        for name in ("lun", "off"):
            self.assertIn(f"fix mp_pic knows `stress {name}` already", self.refused(name, "folder", "--stress"))
        self.assertIn("not allowed with argument", self.refused("bouncy", "folder", "--stress", "--law"))
        self.assertEqual(os.listdir(self.root), [])

    def test_a_folder_with_something_in_it(self):
        os.mkdir(os.path.join(self.root, "bouncy"))
        with open(os.path.join(self.root, "bouncy", "thesis.tex"), "w", encoding="utf-8"):
            pass
        self.assertIn("bouncy is not empty", self.refused("bouncy"))
        self.assertEqual(os.listdir(os.path.join(self.root, "bouncy")), ["thesis.tex"])

    def test_a_file(self):
        with open(os.path.join(self.root, "bouncy"), "w", encoding="utf-8"):
            pass
        self.assertIn("bouncy is a file", self.refused("bouncy"))

    def test_a_folder_inside_the_tree(self):
        folder = os.path.join(REPOSITORY, "plugins", "bouncy")
        for given, cwd in ((folder, None), (".", os.path.join(REPOSITORY, "plugins"))):
            self.assertIn("is inside the tree of interphase", self.refused("bouncy", given, cwd=cwd))
        self.assertFalse(os.path.exists(folder))

    def test_a_path_that_openfoam_does_not_bear(self):
        self.assertIn("OpenFOAM bears no ' ' in a path", self.refused("bouncy", "my folder"))


class WholePath(Bench):
    def configured(self, plugin, *options):
        build = os.path.join(plugin, "build")
        self.succeed("cmake", "-S", plugin, "-B", build, "-G", "Ninja", *options)
        self.succeed("cmake", "--build", build)
        return build

    def test_with_the_build_folder(self):
        done = self.succeed(TOOL, "soft_ball")
        self.assertIn("cmake -B build", done.stdout)
        plugin = os.path.join(self.root, "soft_ball")
        build = self.configured(plugin, f"-Dinterphase_DIR={BUILD}")
        self.succeed("ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error")

        out = os.path.join(self.root, "out")
        self.succeed(os.path.join(TOOLS, "run"), os.path.join(plugin, "case"), "--method", "soft-ball", "--out", out, "--no-picture",
                     INTERPHASE_BIN=os.path.join(BUILD, "interphase"))  # fmt: skip
        run = Run(out)
        self.assertIn("soft_ball/spheres", run.meta["plugins"])
        self.assertEqual(run.meta["method"], "SOFT_BALL")
        deepest = run.counters["deepest_overlap"].values[-1]
        self.assertGreater(deepest, 0)
        with open(os.path.join(out, "log.interphase"), encoding="utf-8") as log:
            self.assertRegex(log.read(), r"deepest overlap +[0-9.]+ R +ordinary")
        self.assertAlmostEqual(run.meta["simulated_time"], 0.1, delta=1e-9)
        self.assertEqual(run.series["particles"].values[-1], run.meta["particles"], "no sphere was lost")
        self.assertLess(abs(run.ledger["momentum_residual"].values).max(), 1e-12)

        example = os.path.join(plugin, "example")
        script = os.path.join(example, "in.liggghts")
        with open(script, encoding="utf-8") as file:
            text = file.read()
        with open(script, "w", encoding="utf-8") as file:
            file.write(text.replace("run             20000", "run             2000"))
        done = self.succeed(os.path.join(BUILD, "interphase-liggghts"), "-plugin", "../build/libsoft_ball.so", "-in", "in.liggghts", cwd=example)
        self.assertIn("2000 steps with 784 atoms", done.stdout)

    def test_one_that_remembers_its_contacts(self):
        """The template's own case and script are those of the other one, whose style has the same words."""
        self.succeed(TOOL, "sticky_ball", "--with-memory")
        plugin = os.path.join(self.root, "sticky_ball")
        build = self.configured(plugin, f"-Dinterphase_DIR={BUILD}")
        done = self.succeed("ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error")
        self.assertIn("tests passed, 0 tests failed out of 2", done.stdout)

    def test_a_law(self):
        """With the build folder, and with an installation, where the solver is a library of its own; the plot; the bed."""
        self.succeed(TOOL, "hard_ball", "--law")
        plugin = os.path.join(self.root, "hard_ball")
        build = self.configured(plugin, f"-Dinterphase_DIR={BUILD}")
        self.succeed("ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error")
        self.succeed("/usr/bin/python3", os.path.join(plugin, "test", "plot.py"), RUNNER=os.path.join(BUILD, "interphase-liggghts"))
        self.assertTrue(os.path.isfile(os.path.join(plugin, "law.png")))

        out = os.path.join(self.root, "out")
        self.succeed(os.path.join(TOOLS, "run"), os.path.join(plugin, "case"), "--out", out, "--no-picture",
                     INTERPHASE_BIN=os.path.join(BUILD, "interphase"))  # fmt: skip
        run = Run(out)
        self.assertIn("tdhs/hard_ball", run.meta["plugins"])
        self.assertEqual(run.series["particles"].values[-1], run.meta["particles"], "no sphere was lost")
        self.assertLess(abs(run.ledger["momentum_residual"].values).max(), 1e-12)

        prefix = os.path.join(self.root, "prefix")
        self.succeed("cmake", "--install", BUILD, "--prefix", prefix)
        shutil.rmtree(build)
        self.succeed("ctest", "--test-dir", self.configured(plugin, f"-DCMAKE_PREFIX_PATH={prefix}"), "--output-on-failure", "--no-tests=error")

    def test_a_stress(self):
        """With the build folder, and with an installation; the plot; the bed on two ranks, whose method is mp_pic's."""
        self.succeed(TOOL, "rubbing", "--stress")
        plugin = os.path.join(self.root, "rubbing")
        self.assertEqual(sorted(os.listdir(plugin)), ["CMakeLists.txt", "README.md", "case", "rubbing.cpp", "test"])
        build = self.configured(plugin, f"-Dinterphase_DIR={BUILD}")
        self.succeed("ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error")
        self.succeed("/usr/bin/python3", os.path.join(plugin, "test", "plot.py"), RUNNER=os.path.join(BUILD, "interphase-liggghts"))
        self.assertTrue(os.path.isfile(os.path.join(plugin, "stress.png")))

        out = os.path.join(self.root, "out")
        self.succeed(os.path.join(TOOLS, "run"), os.path.join(plugin, "case"), "--ranks", "2", "--out", out, "--no-picture",
                     INTERPHASE_BIN=os.path.join(BUILD, "interphase"))  # fmt: skip
        run = Run(out)
        self.assertIn("mp_pic/rubbing", run.meta["plugins"])
        self.assertEqual(run.meta["method"], "MPPIC")
        self.assertEqual(run.series["particles"].values[-1], run.meta["particles"], "no parcel was lost")
        self.assertLess(abs(run.ledger["momentum_residual"].values).max(), 1e-12)
        self.assertGreater(1 - run.series["lowest_voidage"].values[-1], 0.5, "it lies so close that the stress holds it")
        self.assertEqual(run.ledger["cells_beyond_close_packing"].values[-1], 0)

        prefix = os.path.join(self.root, "prefix")
        self.succeed("cmake", "--install", BUILD, "--prefix", prefix)
        shutil.rmtree(build)
        self.succeed("ctest", "--test-dir", self.configured(plugin, f"-DCMAKE_PREFIX_PATH={prefix}"), "--output-on-failure", "--no-tests=error")

    def test_with_an_installation(self):
        """An interphase in <prefix> and a plug-in installed into the same one, found by its name."""
        prefix = os.path.join(self.root, "prefix")
        self.succeed("cmake", "--install", BUILD, "--prefix", prefix)
        plugin = os.path.join(self.root, "elsewhere", "soft_ball")
        self.succeed(TOOL, "soft_ball", plugin)
        with open(os.path.join(plugin, "fix_soft_ball.cpp"), "a", encoding="utf-8") as file:  # what the tree's own plug-ins use
            file.write("#include <interphase/base/text.hpp>\nextern const std::string told = interphase::text(interphase::Vector(1, 2, 3));\n")
        build = self.configured(plugin, f"-DCMAKE_PREFIX_PATH={prefix}")
        with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as cache:
            self.assertIn(f"interphase_DIR:PATH={prefix}/lib/cmake/interphase", cache.read())
        self.succeed("cmake", "--install", build, "--prefix", prefix)
        self.assertTrue(os.path.isfile(os.path.join(prefix, "lib/interphase/plugins/libsoft_ball.so")))

        shutil.rmtree(build)
        script = os.path.join(self.root, "in.script")
        with open(script, "w", encoding="utf-8") as file:
            file.write("units si\n")
        self.succeed(os.path.join(prefix, "bin", "interphase-liggghts"), "-plugin", "soft_ball", "-in", script)
        done = self.run_program(os.path.join(prefix, "bin", "interphase-liggghts"), "-plugin", "soft_bal", "-in", script)
        self.assertIn("did you mean `soft_ball`?", done.stderr)
